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

# Usage requirements of our own code only; never exported to users of the package.
add_library(raygauge_warnings INTERFACE)
target_compile_options(raygauge_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wno-psabi
                       $<$<BOOL:${RAYGAUGE_WARNINGS_AS_ERRORS}>:-Werror>)

# raygauge_room(NAME SOURCES... ) declares the library of one top-level folder.
function(raygauge_room name)
  add_library(raygauge_${name} STATIC ${ARGN})
  add_library(raygauge::${name} ALIAS raygauge_${name})
  target_include_directories(raygauge_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  target_link_libraries(raygauge_${name} PRIVATE $<BUILD_INTERFACE:raygauge_warnings>)
endfunction()

# raygauge_require(PACKAGE DEBIAN_PACKAGE ...) finds a package or says in one line what to install.
macro(raygauge_require package debian)
  find_package(${package} ${ARGN} QUIET)
  if(NOT ${package}_FOUND)
    message(FATAL_ERROR "raygauge needs ${package}: apt-get install ${debian} (or ./run.sh, which installs everything)")
  endif()
endmacro()
