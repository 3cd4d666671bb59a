// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/simulation.h"

extern "C" raygauge::FrictionSolver* raygauge_create_friction() {
  return raygauge::siconos_friction().release();
}
