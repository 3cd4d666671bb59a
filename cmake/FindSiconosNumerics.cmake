# Finds the numerics of Siconos (solvers of friction-contact problems) and defines SiconosNumerics::SiconosNumerics.
include(RaygaugeFind)
raygauge_find(HEADER SiconosConfig.h SUFFIX siconos LIBRARIES siconos_numerics siconos_externals)
if(SiconosNumerics_FOUND)
  target_include_directories(SiconosNumerics::SiconosNumerics INTERFACE ${SiconosNumerics_INCLUDE_DIR}/numerics)
endif()
