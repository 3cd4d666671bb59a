// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "scene/simulation/friction.h"

namespace raygauge {

/// By Siconos numerics: nonsmooth Gauss-Seidel on the contacts, from the first guess to a relative error of
/// 1e-10 or 4000 passes, beyond which it gains little.
std::unique_ptr<FrictionSolver> siconos_friction();

}  // namespace raygauge
