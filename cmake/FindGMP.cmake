# Finds the GNU Multiple Precision library together with the Boost headers that wrap it here.
#   GMP_FOUND, GMP_VERSION, target GMP::GMP
find_path(GMP_INCLUDE_DIR gmp.h)
find_library(GMP_LIBRARY gmp)
find_path(GMP_BOOST_INCLUDE_DIR boost/multiprecision/gmp.hpp)
mark_as_advanced(GMP_INCLUDE_DIR GMP_LIBRARY GMP_BOOST_INCLUDE_DIR)

if(GMP_INCLUDE_DIR)
  # The version stands in gmp.h, or in an architecture's own header that it includes.
  file(GLOB _gmp_headers ${GMP_INCLUDE_DIR}/gmp.h ${GMP_INCLUDE_DIR}/gmp-*.h)
  foreach(_gmp_header ${_gmp_headers})
    file(STRINGS ${_gmp_header} _gmp_lines REGEX "#define +__GNU_MP_VERSION(_MINOR|_PATCHLEVEL)? +[0-9]+")
    if(_gmp_lines)
      string(REGEX REPLACE "[^;]*[^0-9;]([0-9]+)[^0-9;]*" "\\1" _gmp_numbers "${_gmp_lines}")
      string(REPLACE ";" "." GMP_VERSION "${_gmp_numbers}")
    endif()
  endforeach()
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(GMP REQUIRED_VARS GMP_LIBRARY GMP_INCLUDE_DIR GMP_BOOST_INCLUDE_DIR
                                  VERSION_VAR GMP_VERSION)
if(GMP_FOUND AND NOT TARGET GMP::GMP)
  add_library(GMP::GMP UNKNOWN IMPORTED)
  set_target_properties(GMP::GMP PROPERTIES IMPORTED_LOCATION ${GMP_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES "${GMP_INCLUDE_DIR};${GMP_BOOST_INCLUDE_DIR}")
endif()
