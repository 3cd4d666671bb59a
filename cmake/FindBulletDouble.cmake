# Finds Bullet in double precision, which Debian builds beside the one in single precision.
#   BulletDouble_FOUND, target BulletDouble::BulletDouble
include(RaygaugeFind)
raygauge_find(HEADER btBulletCollisionCommon.h SUFFIX bullet
              LIBRARIES BulletDynamics-float64 BulletCollision-float64 LinearMath-float64)
if(BulletDouble_FOUND)
  target_compile_definitions(BulletDouble::BulletDouble INTERFACE BT_USE_DOUBLE_PRECISION)
endif()
