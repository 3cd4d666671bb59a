// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "raygauge/simulation.h"

namespace raygauge {

/// Friction by the module raygauge_siconos.so, loaded by the first call: it brings forty libraries along, and
/// one of them defines functions of MPI that do nothing. Throws Error in a build without Siconos, and says
/// what to install.
std::unique_ptr<FrictionSolver> loaded_friction();

}  // namespace raygauge
