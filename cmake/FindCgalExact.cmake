# Finds the headers of CGAL and what its exact kernel needs. CGAL's own CMake package changes the flags of all that links it.
#   CgalExact_FOUND, target CgalExact::CgalExact; sources that include CGAL are compiled with -frounding-math
find_path(CgalExact_INCLUDE_DIR CGAL/version.h)
find_library(CgalExact_MPFR mpfr)
find_library(CgalExact_GMP gmp)
mark_as_advanced(CgalExact_INCLUDE_DIR CgalExact_MPFR CgalExact_GMP)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CgalExact REQUIRED_VARS CgalExact_MPFR CgalExact_GMP CgalExact_INCLUDE_DIR)
if(CgalExact_FOUND AND NOT TARGET CgalExact::CgalExact)
  add_library(CgalExact::CgalExact INTERFACE IMPORTED)
  set_target_properties(CgalExact::CgalExact PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${CgalExact_INCLUDE_DIR}
                        INTERFACE_LINK_LIBRARIES "${CgalExact_MPFR};${CgalExact_GMP}")
endif()
