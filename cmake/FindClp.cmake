# Finds COIN-OR Clp through pkg-config.
#   Clp_FOUND, Clp_VERSION, target Clp::Clp
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(PC_CLP QUIET IMPORTED_TARGET clp)
endif()

set(Clp_VERSION ${PC_CLP_VERSION})
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Clp REQUIRED_VARS PC_CLP_FOUND PC_CLP_LINK_LIBRARIES VERSION_VAR Clp_VERSION)
if(Clp_FOUND AND NOT TARGET Clp::Clp)
  add_library(Clp::Clp INTERFACE IMPORTED)
  target_link_libraries(Clp::Clp INTERFACE PkgConfig::PC_CLP)
endif()
