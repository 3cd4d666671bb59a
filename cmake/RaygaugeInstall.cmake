# What `cmake --install` puts where: the engine as the CMake package raygauge, and the program where it is built.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(_headers ${CMAKE_INSTALL_INCLUDEDIR}/raygauge)
set(_package ${CMAKE_INSTALL_LIBDIR}/cmake/raygauge)

target_include_directories(raygauge_engine PUBLIC $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
                                                  $<INSTALL_INTERFACE:${_headers}>)
install(TARGETS raygauge_engine EXPORT raygauge ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT raygauge FILE raygaugeTargets.cmake NAMESPACE raygauge:: DESTINATION ${_package})

# The public headers are those that raygauge.h includes, and what they include in turn; the engine's inner ones stay at
# home.
set(_umbrella engine/include/raygauge/raygauge.h)
set(_public)
set(_pending ${_umbrella})
while(_pending)
  list(POP_FRONT _pending _header)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${_header})
  file(STRINGS ${_header} _includes REGEX "^#include \"engine/")
  foreach(_include IN LISTS _includes)
    string(REGEX REPLACE "^#include \"(.*)\"$" "\\1" _included ${_include})
    if(NOT _included IN_LIST _public)
      list(APPEND _public ${_included})
      list(APPEND _pending ${_included})
    endif()
  endforeach()
endwhile()
foreach(_header IN LISTS _public)
  cmake_path(GET _header PARENT_PATH _folder)
  install(FILES ${_header} DESTINATION ${_headers}/${_folder})
endforeach()
install(FILES ${_umbrella} DESTINATION ${_headers})
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
