# What `cmake --install` puts where: the engine as the CMake package raygauge, and the program where it is built.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(_package ${CMAKE_INSTALL_LIBDIR}/cmake/raygauge)

# The library is one shared object, engine, scenes, simulation and sweeps, behind a list of what it shows: the names of
# namespace raygauge. Its copies of Eigen's functions stay inside, so that a caller's own, compiled with other flags, never take
# their place. Its binary interface is promised within a minor version (docs/promises.md), which is why its SONAME carries one.
file(WRITE ${PROJECT_BINARY_DIR}/shared_library.cc "")
add_library(raygauge_shared SHARED ${PROJECT_BINARY_DIR}/shared_library.cc)
target_link_libraries(raygauge_shared PRIVATE $<LINK_LIBRARY:WHOLE_ARCHIVE,raygauge_sweep,raygauge_simulation>
                                      INTERFACE Eigen3::Eigen)
target_link_options(raygauge_shared PRIVATE -Wl,--version-script=${PROJECT_SOURCE_DIR}/cmake/packaging/visible.map
                                            -Wl,--no-undefined)
target_include_directories(raygauge_shared INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_compile_features(raygauge_shared INTERFACE cxx_std_20)
set_target_properties(raygauge_shared PROPERTIES
  OUTPUT_NAME raygauge EXPORT_NAME raygauge
  LINK_LIBRARY_OVERRIDE_raygauge_engine WHOLE_ARCHIVE LINK_LIBRARY_OVERRIDE_raygauge_scene WHOLE_ARCHIVE
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
  LINK_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/packaging/visible.map
  LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/shared)
foreach(_part sweep simulation)  # the same object, as its users name it
  add_library(raygauge_${_part}_shared INTERFACE)
  set_target_properties(raygauge_${_part}_shared PROPERTIES EXPORT_NAME ${_part})
  target_link_libraries(raygauge_${_part}_shared INTERFACE raygauge_shared)
endforeach()

# The same as an archive, for programs that stand alone: component static. What it needs beside is named for the linker.
add_library(raygauge_static STATIC $<TARGET_OBJECTS:raygauge_engine> $<TARGET_OBJECTS:raygauge_sweep> $<TARGET_OBJECTS:raygauge_scene>
                                   $<TARGET_OBJECTS:raygauge_simulation>)
set(_static_libraries -lgomp)
if(RAYGAUGE_HAS_FLOAT128)
  list(APPEND _static_libraries -lquadmath)
endif()
if(RAYGAUGE_HAS_QHULL)
  list(APPEND _static_libraries -lqhullcpp -lqhull_r)
endif()
target_link_libraries(raygauge_static INTERFACE Eigen3::Eigen ${_static_libraries} -pthread)
target_include_directories(raygauge_static INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_compile_features(raygauge_static INTERFACE cxx_std_20)
set_target_properties(raygauge_static PROPERTIES OUTPUT_NAME raygauge EXPORT_NAME static LINKER_LANGUAGE CXX)
install(TARGETS raygauge_static EXPORT raygauge ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
list(JOIN _static_libraries " " _static_libraries)  # for pkg-config --static

# raygauge_component(NAME) declares libraygauge_NAME.so, the room NAME of what needs more than Eigen: a component of its own, with
# its list of what it shows.
function(raygauge_component name)
  set(_visible ${PROJECT_SOURCE_DIR}/cmake/packaging/visible_${name}.map)
  add_library(raygauge_${name}_shared SHARED ${PROJECT_BINARY_DIR}/shared_library.cc)
  target_link_libraries(raygauge_${name}_shared PRIVATE $<LINK_LIBRARY:WHOLE_ARCHIVE,raygauge_${name}> INTERFACE raygauge_shared)
  target_link_options(raygauge_${name}_shared PRIVATE -Wl,--gc-sections -Wl,--no-undefined -Wl,--version-script=${_visible})
  set_target_properties(raygauge_${name}_shared PROPERTIES
    OUTPUT_NAME raygauge_${name} EXPORT_NAME ${name} LINK_DEPENDS ${_visible} LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/shared
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  install(TARGETS raygauge_${name}_shared EXPORT raygauge_${name} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${name})
  install(EXPORT raygauge_${name} FILE raygauge_${name}.cmake NAMESPACE raygauge:: DESTINATION ${_package} COMPONENT ${name})
endfunction()
if(RAYGAUGE_BUILD_PROGRAM)
  raygauge_component(results)  # raygauge/results.h: HDF5
  if(RAYGAUGE_HAS_SICONOS)
    raygauge_component(friction)  # siconos_friction() of raygauge/simulation.h: Siconos numerics
  endif()
endif()

install(TARGETS raygauge_shared EXPORT raygauge LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library
                                                        NAMELINK_COMPONENT development)
install(TARGETS raygauge_sweep_shared raygauge_simulation_shared EXPORT raygauge)
if(TARGET raygauge_c)
  install(TARGETS raygauge_c EXPORT raygauge LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library
                                                     NAMELINK_COMPONENT development)
endif()
install(EXPORT raygauge FILE raygaugeTargets.cmake NAMESPACE raygauge:: DESTINATION ${_package})

# The public headers are those of include/raygauge/; the engine's inner ones stay at home.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/raygauge DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

configure_package_config_file(cmake/raygaugeConfig.cmake.in ${PROJECT_BINARY_DIR}/raygaugeConfig.cmake
                              INSTALL_DESTINATION ${_package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/raygaugeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/raygaugeConfig.cmake ${PROJECT_BINARY_DIR}/raygaugeConfigVersion.cmake
        DESTINATION ${_package})

# The same for pkg-config, wherever the prefix is moved to.
file(RELATIVE_PATH _to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" _to_prefix ${_to_prefix})
foreach(_library raygauge raygauge_c)
  if(TARGET raygauge_c OR _library STREQUAL "raygauge")
    configure_file(cmake/packaging/${_library}.pc.in ${PROJECT_BINARY_DIR}/${_library}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/${_library}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
  endif()
endforeach()

if(RAYGAUGE_BUILD_PROGRAM)
  install(TARGETS raygauge RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  get_property(_modules GLOBAL PROPERTY RAYGAUGE_MODULES)
  foreach(_module IN LISTS _modules)
    install(TARGETS raygauge_${_module} LIBRARY DESTINATION lib/raygauge COMPONENT ${_module})
  endforeach()
endif()
