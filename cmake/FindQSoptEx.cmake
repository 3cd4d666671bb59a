# Finds QSopt_ex, a simplex in rational arithmetic, and defines QSoptEx::QSoptEx (with GMP, whose numbers it takes).
include(RaygaugeFind)
raygauge_find(HEADER qsopt_ex/QSopt_ex.h LIBRARIES qsopt_ex gmp)
