# Finds LIBSVM (support vector machines) and defines Libsvm::Libsvm.
#   Libsvm_FOUND, Libsvm_VERSION
include(FindPackageHandleStandardArgs)

find_path(Libsvm_INCLUDE_DIR svm.h PATH_SUFFIXES libsvm)
find_library(Libsvm_LIBRARY svm)
if(Libsvm_INCLUDE_DIR)
  file(STRINGS ${Libsvm_INCLUDE_DIR}/svm.h _line REGEX "^#define LIBSVM_VERSION +[0-9]+")
  string(REGEX REPLACE ".* ([0-9]+)([0-9][0-9])$" "\\1.\\2" Libsvm_VERSION "${_line}")
endif()
find_package_handle_standard_args(Libsvm REQUIRED_VARS Libsvm_LIBRARY Libsvm_INCLUDE_DIR VERSION_VAR Libsvm_VERSION)
mark_as_advanced(Libsvm_INCLUDE_DIR Libsvm_LIBRARY)

if(Libsvm_FOUND AND NOT TARGET Libsvm::Libsvm)
  add_library(Libsvm::Libsvm UNKNOWN IMPORTED)
  set_target_properties(Libsvm::Libsvm PROPERTIES IMPORTED_LOCATION ${Libsvm_LIBRARY}
                                                  INTERFACE_INCLUDE_DIRECTORIES ${Libsvm_INCLUDE_DIR})
endif()
