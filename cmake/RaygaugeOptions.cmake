# Build options, language level and warnings: decided once, for every room.

option(RAYGAUGE_BUILD_PROGRAM "Build generators, baselines, results, analysis and the program" ${PROJECT_IS_TOP_LEVEL})
option(RAYGAUGE_BUILD_C "Build the C interface, the shared library raygauge_c" ${RAYGAUGE_BUILD_PROGRAM})
option(RAYGAUGE_BUILD_TESTS "Build the test suite" ${PROJECT_IS_TOP_LEVEL})
option(RAYGAUGE_BUILD_BENCH "Build the Google Benchmarks" ${PROJECT_IS_TOP_LEVEL})
option(RAYGAUGE_FUZZ "Build the libFuzzer targets too (preset fuzz)" OFF)
option(RAYGAUGE_INSTALL "Install the engine as a CMake package, and the program" ${PROJECT_IS_TOP_LEVEL})
option(RAYGAUGE_WARNINGS_AS_ERRORS "Treat compiler warnings as errors" OFF)

include(RaygaugeOptional)

# The Python package belongs to Debian's interpreter, which another one may hide on PATH; it needs NumPy to be imported.
set(Python_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "Interpreter that the Python package is built for")
set(_python_default OFF)
if(RAYGAUGE_BUILD_PROGRAM)
  set(_python_default AUTO)
endif()
raygauge_option(RAYGAUGE_BUILD_PYTHON "Build the Python package" ${_python_default})
set(_python OFF)
if(RAYGAUGE_BUILD_PYTHON)
  find_package(Python 3.11 COMPONENTS Interpreter Development.Module QUIET)
  find_package(pybind11 2.10 CONFIG QUIET)
  if(Python_FOUND AND pybind11_FOUND)
    execute_process(COMMAND ${Python_EXECUTABLE} -c "import numpy" RESULT_VARIABLE _no_numpy ERROR_QUIET)
    if(_no_numpy EQUAL 0)
      set(_python ON)
    endif()
  endif()
endif()
raygauge_decide(RAYGAUGE_HAS_PYTHON RAYGAUGE_BUILD_PYTHON ${_python} "The Python package"
                "python3-dev pybind11-dev python3-numpy")

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

# Programs look for libraries where they were linked. CMake's own search path, for what is not installed yet, ends with an
# empty entry: the folder that one happens to be in.
set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)
set(CMAKE_BUILD_WITH_INSTALL_RPATH ON)

# No room waits for another one's archive before it compiles: both cores stay busy.
set(CMAKE_OPTIMIZE_DEPENDENCIES ON)

# Half of the compile time goes into a few large headers, which are precompiled. Compiler caches cannot follow
# precompiled headers.
if(CMAKE_CXX_COMPILER_LAUNCHER AND NOT DEFINED CMAKE_DISABLE_PRECOMPILE_HEADERS)
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()

# raygauge_require(PACKAGE DEBIAN_PACKAGE ...) finds a package or says in one line what to install.
macro(raygauge_require package debian)
  find_package(${package} ${ARGN} QUIET)
  if(NOT ${package}_FOUND)
    message(FATAL_ERROR "raygauge needs ${package}: apt-get install ${debian} (or ./run.sh, which installs everything)")
  endif()
endmacro()

raygauge_require(Eigen3 libeigen3-dev 3.4)
raygauge_require(OpenMP libgomp1 COMPONENTS CXX)

# Usage requirements of our own code only, never those of a user of the library: headers of rooms, and warnings.
add_library(raygauge_own_code INTERFACE)
target_include_directories(raygauge_own_code INTERFACE ${PROJECT_SOURCE_DIR})
# The threads of a solve or a sweep are the caller's to choose; Eigen is not to add its own.
target_compile_definitions(raygauge_own_code INTERFACE EIGEN_DONT_PARALLELIZE)
target_link_libraries(raygauge_own_code INTERFACE OpenMP::OpenMP_CXX)
target_compile_options(raygauge_own_code INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wno-psabi
                       $<$<BOOL:${RAYGAUGE_WARNINGS_AS_ERRORS}>:-Werror>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # False alarms of GCC 12 inside std::string (its bug 105651 and the like) and Eigen; AddressSanitizer finds the real ones.
  target_compile_options(raygauge_own_code INTERFACE -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow
                         -Wno-maybe-uninitialized)
endif()

# No product and sum is fused where a CPU could: instances, statistics and error-free transformations have the same bits on
# every machine. The vector kernels, which ask for fused operations by name, say so themselves.
add_compile_options(-ffp-contract=off)

# Nobody replaces a function of the library at load time: position-independent code may call and inline it directly.
add_compile_options(-fno-semantic-interposition)

# Compiled once, and shared by all rooms: one set of flags for all of them. Rooms go into Python's modules and into the
# shared library, too.
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/nothing.cc CONTENT "// Headers alone.\n")
add_library(raygauge_room_headers OBJECT ${PROJECT_BINARY_DIR}/nothing.cc)
target_link_libraries(raygauge_room_headers PRIVATE raygauge_own_code Eigen3::Eigen)
set_target_properties(raygauge_room_headers PROPERTIES POSITION_INDEPENDENT_CODE ON)
target_precompile_headers(raygauge_room_headers PRIVATE <algorithm> <cmath> <functional> <map> <memory> <string> <vector>
                                                        <Eigen/Core>)

# raygauge_source_options(OPTIONS sources...): sources with compiler options of their own, which the precompiled headers do
# not have.
function(raygauge_source_options options)
  set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS "${options}" SKIP_PRECOMPILE_HEADERS ON)
endfunction()

# raygauge_room(NAME [EXTRA...] [SOURCES sources...]) declares the library of one top-level folder, made of every source
# in it (or of SOURCES alone) and of EXTRA.
function(raygauge_room name)
  cmake_parse_arguments(PARSE_ARGV 1 _room "" "" "SOURCES")
  if(NOT _room_SOURCES)
    file(GLOB_RECURSE _room_SOURCES CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} *.cc)
    list(REMOVE_ITEM _room_SOURCES main.cc)
  endif()
  add_library(raygauge_${name} STATIC ${_room_SOURCES} ${_room_UNPARSED_ARGUMENTS})
  add_library(raygauge::${name} ALIAS raygauge_${name})
  target_link_libraries(raygauge_${name} PRIVATE $<BUILD_INTERFACE:raygauge_own_code>)
  set_target_properties(raygauge_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_precompile_headers(raygauge_${name} REUSE_FROM raygauge_room_headers)
endfunction()

# raygauge_module(NAME sources... LIBRARIES libraries...) declares raygauge_NAME.so, which the program loads when it needs it
# (results/run/own_module.h); it is installed as a component of its own.
function(raygauge_module name)
  cmake_parse_arguments(PARSE_ARGV 1 _module "" "" "LIBRARIES")
  add_library(raygauge_${name} MODULE ${_module_UNPARSED_ARGUMENTS})
  set_target_properties(raygauge_${name} PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
  target_include_directories(raygauge_${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(raygauge_${name} PRIVATE ${_module_LIBRARIES} raygauge_own_code)
  set_property(GLOBAL APPEND PROPERTY RAYGAUGE_MODULES ${name})
endfunction()
