# Finds the headers of CGAL and what its exact kernel needs. CGAL's own CMake package changes the flags of all that links it.
#   CgalExact_FOUND, target CgalExact::CgalExact; sources that include CGAL are compiled with -frounding-math
include(RaygaugeFind)
raygauge_find(HEADER CGAL/version.h LIBRARIES mpfr gmp)
