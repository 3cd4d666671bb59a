# Finds Bullet in double precision, which Debian builds beside the one in single precision.
#   BulletDouble_FOUND, targets BulletDouble::BulletDouble (collision detection), BulletDouble::Dynamics
find_path(BulletDouble_INCLUDE_DIR btBulletCollisionCommon.h PATH_SUFFIXES bullet)
find_library(BulletDouble_COLLISION BulletCollision-float64)
find_library(BulletDouble_DYNAMICS BulletDynamics-float64)
find_library(BulletDouble_MATH LinearMath-float64)
mark_as_advanced(BulletDouble_INCLUDE_DIR BulletDouble_COLLISION BulletDouble_DYNAMICS BulletDouble_MATH)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(BulletDouble REQUIRED_VARS BulletDouble_COLLISION BulletDouble_DYNAMICS BulletDouble_MATH
                                  BulletDouble_INCLUDE_DIR)
if(BulletDouble_FOUND AND NOT TARGET BulletDouble::BulletDouble)
  add_library(BulletDouble::BulletDouble UNKNOWN IMPORTED)
  set_target_properties(BulletDouble::BulletDouble PROPERTIES IMPORTED_LOCATION ${BulletDouble_COLLISION}
                        INTERFACE_INCLUDE_DIRECTORIES ${BulletDouble_INCLUDE_DIR}
                        INTERFACE_COMPILE_DEFINITIONS BT_USE_DOUBLE_PRECISION
                        INTERFACE_LINK_LIBRARIES ${BulletDouble_MATH})
  add_library(BulletDouble::Dynamics UNKNOWN IMPORTED)
  set_target_properties(BulletDouble::Dynamics PROPERTIES IMPORTED_LOCATION ${BulletDouble_DYNAMICS}
                        INTERFACE_LINK_LIBRARIES BulletDouble::BulletDouble)
endif()
