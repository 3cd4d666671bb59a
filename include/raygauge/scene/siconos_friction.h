// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "raygauge/scene/friction.h"

namespace raygauge {

/// Of the library raygauge::friction, by Siconos numerics: nonsmooth Gauss-Seidel on the contacts, from the
/// first guess to a relative error of 1e-10 or 4000 passes, beyond which it gains little.
std::unique_ptr<FrictionSolver> siconos_friction();

}  // namespace raygauge
