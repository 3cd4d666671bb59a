# Finds the numerics of Siconos (solvers of friction-contact problems) and defines SiconosNumerics::SiconosNumerics.
include(FindPackageHandleStandardArgs)

find_path(SiconosNumerics_INCLUDE_DIR SiconosConfig.h PATH_SUFFIXES siconos)
find_library(SiconosNumerics_LIBRARY siconos_numerics)
find_library(SiconosNumerics_EXTERNALS siconos_externals)
find_package_handle_standard_args(SiconosNumerics REQUIRED_VARS SiconosNumerics_LIBRARY SiconosNumerics_EXTERNALS
                                                                SiconosNumerics_INCLUDE_DIR)
mark_as_advanced(SiconosNumerics_INCLUDE_DIR SiconosNumerics_LIBRARY SiconosNumerics_EXTERNALS)

if(SiconosNumerics_FOUND AND NOT TARGET SiconosNumerics::SiconosNumerics)
  add_library(SiconosNumerics::SiconosNumerics UNKNOWN IMPORTED)
  set_target_properties(SiconosNumerics::SiconosNumerics PROPERTIES
    IMPORTED_LOCATION ${SiconosNumerics_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES "${SiconosNumerics_INCLUDE_DIR};${SiconosNumerics_INCLUDE_DIR}/numerics"
    INTERFACE_LINK_LIBRARIES ${SiconosNumerics_EXTERNALS})
endif()
