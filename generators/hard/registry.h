// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/instance.h"

namespace raygauge {

/// Adds the hard families: instances that break solvers, most of them with an exact answer. A new one is one
/// line in registry.cc.
void register_hard_generators(GeneratorRegistry& registry);

}  // namespace raygauge
