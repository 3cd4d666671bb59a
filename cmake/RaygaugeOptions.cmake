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

# raygauge_room(NAME SOURCES... ) declares the library of one top-level folder.
function(raygauge_room name)
  add_library(raygauge_${name} STATIC ${ARGN})
  add_library(raygauge::${name} ALIAS raygauge_${name})
  target_include_directories(raygauge_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  target_link_libraries(raygauge_${name} PRIVATE $<BUILD_INTERFACE:raygauge_warnings>)
  target_precompile_headers(raygauge_${name} PRIVATE <algorithm> <cmath> <functional> <map> <memory> <string> <vector>
                                                     <Eigen/Core>)
  set_target_properties(raygauge_${name} PROPERTIES UNITY_BUILD ${RAYGAUGE_UNITY_BUILD})
endfunction()

# raygauge_compile_together(ROOM COUNT) compiles at least so many files of a room as one: where those that stand together
# in its list share a large header, its templates are read and compiled once.
function(raygauge_compile_together room count)
  if(CMAKE_UNITY_BUILD_BATCH_SIZE LESS count)
    set_target_properties(raygauge_${room} PROPERTIES UNITY_BUILD_BATCH_SIZE ${count})
  endif()
endfunction()

# raygauge_require(PACKAGE DEBIAN_PACKAGE ...) finds a package or says in one line what to install.
macro(raygauge_require package debian)
  find_package(${package} ${ARGN} QUIET)
  if(NOT ${package}_FOUND)
    message(FATAL_ERROR "raygauge needs ${package}: apt-get install ${debian} (or ./run.sh, which installs everything)")
  endif()
endmacro()
