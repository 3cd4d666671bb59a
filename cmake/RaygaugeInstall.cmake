# What `cmake --install` puts where: the engine as the CMake package raygauge, and the program where it is built.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(_package ${CMAKE_INSTALL_LIBDIR}/cmake/raygauge)

target_include_directories(raygauge_engine PUBLIC $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
install(TARGETS raygauge_engine raygauge_sweep EXPORT raygauge ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT raygauge FILE raygaugeTargets.cmake NAMESPACE raygauge:: DESTINATION ${_package})

# The public headers are those of include/raygauge/; the engine's inner ones stay at home.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/raygauge DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

configure_package_config_file(cmake/raygaugeConfig.cmake.in ${PROJECT_BINARY_DIR}/raygaugeConfig.cmake
                              INSTALL_DESTINATION ${_package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/raygaugeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/raygaugeConfig.cmake ${PROJECT_BINARY_DIR}/raygaugeConfigVersion.cmake
        DESTINATION ${_package})

if(RAYGAUGE_BUILD_PROGRAM)
  install(TARGETS raygauge RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  if(TARGET raygauge_mpi)
    install(TARGETS raygauge_mpi LIBRARY DESTINATION lib/raygauge COMPONENT mpi)
  endif()
endif()
