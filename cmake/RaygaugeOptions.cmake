# Build options, language level and warnings: decided once, for every room.

option(RAYGAUGE_BUILD_PROGRAM "Build generators, baselines, results, analysis and the program" ${PROJECT_IS_TOP_LEVEL})
option(RAYGAUGE_BUILD_TESTS "Build the test suite" ${PROJECT_IS_TOP_LEVEL})
option(RAYGAUGE_BUILD_BENCH "Build the Google Benchmarks" ${PROJECT_IS_TOP_LEVEL})
option(RAYGAUGE_FUZZ "Build the libFuzzer targets too (preset fuzz)" OFF)
option(RAYGAUGE_INSTALL "Install the engine as a CMake package, and the program" ${PROJECT_IS_TOP_LEVEL})
option(RAYGAUGE_WARNINGS_AS_ERRORS "Treat compiler warnings as errors" OFF)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

# g++ looks for memory to free when its heap has grown to 256 MB, and whenever it has doubled. First at 2 GB, which no
# file here needs, it never does: a twentieth of the instructions and a tenth of the time to compile are spared.
add_compile_options($<$<COMPILE_LANG_AND_ID:CXX,GNU>:--param=ggc-min-heapsize=1000000>)

# Programs look for libraries where they were linked. CMake's own search path, for what is not installed yet, ends with an
# empty entry: the folder that one happens to be in.
set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)
set(CMAKE_BUILD_WITH_INSTALL_RPATH ON)

# No room waits for another one's archive before it compiles: both cores stay busy.
set(CMAKE_OPTIMIZE_DEPENDENCIES ON)

# Half of the compile time goes into a few large headers. Compiler caches cannot follow precompiled ones, though.
if(CMAKE_CXX_COMPILER_LAUNCHER AND NOT DEFINED CMAKE_DISABLE_PRECOMPILE_HEADERS)
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()

# The other half goes into compiling the same templates in file after file: several files of a room are compiled as one,
# so that even names without linkage are unique within a room. Off (-DRAYGAUGE_UNITY_BUILD=OFF) while one of them is
# edited again and again.
option(RAYGAUGE_UNITY_BUILD "Compile several files of a room as one" ON)
set(CMAKE_UNITY_BUILD_BATCH_SIZE 8 CACHE STRING "Files compiled as one")

# Usage requirements of our own code only; never exported to users of the package.
add_library(raygauge_warnings INTERFACE)
target_compile_options(raygauge_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wno-psabi
                       $<$<BOOL:${RAYGAUGE_WARNINGS_AS_ERRORS}>:-Werror>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # False alarms of GCC 12 inside std::string (its bug 105651 and the like) and Eigen; AddressSanitizer finds the real ones.
  target_compile_options(raygauge_warnings INTERFACE -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow
                         -Wno-maybe-uninitialized)
endif()

# A target of nothing but precompiled headers, for others to reuse.
file(WRITE ${PROJECT_BINARY_DIR}/nothing.cc "")
function(raygauge_headers name)
  add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/nothing.cc)
  target_link_libraries(${name} PRIVATE raygauge_warnings)
endfunction()

set(_headers_of_rooms <algorithm> <cmath> <functional> <map> <memory> <string> <vector> <Eigen/Core>)

# The headers of all rooms that are optimised at `level`: g++ takes the level from what is precompiled.
function(raygauge_reuse_headers target level)
  string(REPLACE "-" "" _headers "raygauge_headers_${level}")
  if(NOT TARGET ${_headers})
    raygauge_headers(${_headers})
    target_link_libraries(${_headers} PRIVATE raygauge::engine)
    target_compile_options(${_headers} PRIVATE $<$<CONFIG:Release>:${level}> -ffp-contract=off)
    target_precompile_headers(${_headers} PRIVATE ${_headers_of_rooms})
  endif()
  target_precompile_headers(${target} REUSE_FROM ${_headers})
endfunction()

# raygauge_room(NAME [LEVEL -Ox] SOURCES...) declares the library of one top-level folder. A room where little time is
# spent says with LEVEL how much it is optimised in a release: half of the time to compile it goes into -O3.
function(raygauge_room name)
  cmake_parse_arguments(PARSE_ARGV 1 _room "" "LEVEL" "")
  add_library(raygauge_${name} STATIC ${_room_UNPARSED_ARGUMENTS})
  add_library(raygauge::${name} ALIAS raygauge_${name})
  target_include_directories(raygauge_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  target_link_libraries(raygauge_${name} PRIVATE $<BUILD_INTERFACE:raygauge_warnings>)
  set_target_properties(raygauge_${name} PROPERTIES UNITY_BUILD ${RAYGAUGE_UNITY_BUILD})
  if(_room_LEVEL)
    # What these rooms compute is the same, bit for bit, on any machine: nothing is fused where a CPU could.
    target_compile_options(raygauge_${name} PRIVATE $<$<CONFIG:Release>:${_room_LEVEL}> -ffp-contract=off)
    raygauge_reuse_headers(raygauge_${name} ${_room_LEVEL})
  else()
    target_precompile_headers(raygauge_${name} PRIVATE ${_headers_of_rooms})
  endif()
endfunction()

# raygauge_compile_together(TARGET COUNT) compiles at least so many files of a target as one: the templates that they
# share are compiled once, which spares a fifth of the work. At 30 the compiler takes 1.3 GB.
function(raygauge_compile_together target count)
  if(CMAKE_UNITY_BUILD_BATCH_SIZE LESS count)
    set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE ${count})
  endif()
endfunction()

# raygauge_require(PACKAGE DEBIAN_PACKAGE ...) finds a package or says in one line what to install.
macro(raygauge_require package debian)
  find_package(${package} ${ARGN} QUIET)
  if(NOT ${package}_FOUND)
    message(FATAL_ERROR "raygauge needs ${package}: apt-get install ${debian} (or ./run.sh, which installs everything)")
  endif()
endmacro()
