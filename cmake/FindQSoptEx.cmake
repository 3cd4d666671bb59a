# Finds QSopt_ex, a simplex in rational arithmetic, and defines QSoptEx::QSoptEx (with GMP, whose numbers it takes).
find_path(QSoptEx_INCLUDE_DIR qsopt_ex/QSopt_ex.h)
find_library(QSoptEx_LIBRARY qsopt_ex)
find_library(QSoptEx_GMP gmp)
mark_as_advanced(QSoptEx_INCLUDE_DIR QSoptEx_LIBRARY QSoptEx_GMP)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(QSoptEx REQUIRED_VARS QSoptEx_LIBRARY QSoptEx_INCLUDE_DIR QSoptEx_GMP)
if(QSoptEx_FOUND AND NOT TARGET QSoptEx::QSoptEx)
  add_library(QSoptEx::QSoptEx UNKNOWN IMPORTED)
  set_target_properties(QSoptEx::QSoptEx PROPERTIES IMPORTED_LOCATION ${QSoptEx_LIBRARY}
                        INTERFACE_INCLUDE_DIRECTORIES ${QSoptEx_INCLUDE_DIR}
                        INTERFACE_LINK_LIBRARIES ${QSoptEx_GMP})
endif()
