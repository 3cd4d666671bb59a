# The shared library, the manual, and what `cpack -G DEB` makes: libraygauge0.1, libraygauge-dev, raygauge,
# raygauge-mpi, python3-raygauge.

# The shared library is the static one behind a list of what it shows: the names of namespace raygauge. Its binary
# interface is promised within a minor version (docs/promises.md), which is why its SONAME carries one.
file(WRITE ${PROJECT_BINARY_DIR}/shared_library.cc "")
add_library(raygauge_shared SHARED ${PROJECT_BINARY_DIR}/shared_library.cc)
target_link_libraries(raygauge_shared PRIVATE $<LINK_LIBRARY:WHOLE_ARCHIVE,raygauge_engine>)
target_link_options(raygauge_shared PRIVATE -Wl,--version-script=${PROJECT_SOURCE_DIR}/cmake/packaging/visible.map
                                            -Wl,--no-undefined)
set_target_properties(raygauge_shared PROPERTIES
  OUTPUT_NAME raygauge VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
  LINK_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/packaging/visible.map
  LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/shared)
install(TARGETS raygauge_shared LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library
                                        NAMELINK_COMPONENT development)

# The manual and the completion are made from the program's own help, where help2man is installed.
find_program(RAYGAUGE_HELP2MAN help2man)
if(RAYGAUGE_BUILD_PROGRAM AND RAYGAUGE_HELP2MAN)
  set(_manual ${PROJECT_BINARY_DIR}/manual)
  add_custom_command(OUTPUT ${_manual}/raygauge.bash
    COMMAND ${PROJECT_SOURCE_DIR}/cmake/packaging/make-manual $<TARGET_FILE:raygauge> ${PROJECT_VERSION} ${_manual}
    DEPENDS raygauge ${PROJECT_SOURCE_DIR}/cmake/packaging/make-manual VERBATIM)
  add_custom_target(raygauge_manual ALL DEPENDS ${_manual}/raygauge.bash)
  install(DIRECTORY ${_manual}/ DESTINATION share/man/man1 COMPONENT program FILES_MATCHING PATTERN "*.1")
  install(FILES ${_manual}/raygauge.bash DESTINATION share/bash-completion/completions RENAME raygauge COMPONENT program)
  install(FILES ${_manual}/_raygauge DESTINATION share/zsh/vendor-completions COMPONENT program)
  install(FILES ${_manual}/raygauge.fish DESTINATION share/fish/vendor_completions.d COMPONENT program)
endif()

set(CPACK_PACKAGE_VENDOR "The raygauge authors")
set(CPACK_PACKAGE_CONTACT "The raygauge authors <raygauge@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_COMPONENTS_ALL library development)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libraygauge${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libraygauge-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "${CPACK_DEBIAN_LIBRARY_PACKAGE_NAME} (= ${PROJECT_VERSION}), libeigen3-dev, libqhull-dev, libgomp1")
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "shared library")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "headers, static library and CMake package")
if(RAYGAUGE_BUILD_PROGRAM)
  list(APPEND CPACK_COMPONENTS_ALL program)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME raygauge)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS gnuplot-nox)
  set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "the program, its manual and completion")
endif()
if(TARGET raygauge_mpi)
  list(APPEND CPACK_COMPONENTS_ALL mpi)
  set(CPACK_DEBIAN_MPI_PACKAGE_NAME raygauge-mpi)
  set(CPACK_DEBIAN_MPI_PACKAGE_DEPENDS "raygauge (= ${PROJECT_VERSION})")
  set(CPACK_COMPONENT_MPI_DESCRIPTION "runs of many MPI ranks")
endif()
if(RAYGAUGE_BUILD_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-raygauge)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.11), python3 (<< 3.12), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-h5py, python3-xarray, python3-pandas, python3-matplotlib, raygauge")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "the Python package")
endif()
foreach(_component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${_component} _upper)
  install(FILES LICENSE DESTINATION share/doc/${CPACK_DEBIAN_${_upper}_PACKAGE_NAME} RENAME copyright
          COMPONENT ${_component})
endforeach()
include(CPack)
