# Finds the Random123 headers (counter-based random numbers) and defines Random123::Random123.
include(RaygaugeFind)
raygauge_find(HEADER Random123/philox.h)
