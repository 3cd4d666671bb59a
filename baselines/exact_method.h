// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/method.h"

namespace raygauge {

/// Adds `exact`: the linear program of Example 2 in rational arithmetic (solve_exact_lp). No parameters. Its
/// bounds are neighbouring doubles, whatever tolerance is asked for; a time limit is honoured.
void register_exact_method(MethodRegistry& registry);

/// "6.2.1", of the library that is linked.
const char* gmp_library_version();

}  // namespace raygauge
