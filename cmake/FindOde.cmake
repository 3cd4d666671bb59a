# Finds ODE, an engine of physics: Ode_FOUND, target Ode::Ode.
include(RaygaugeFind)
raygauge_find(HEADER ode/ode.h LIBRARIES ode)
