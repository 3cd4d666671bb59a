// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/instance.h"

namespace raygauge {

/// Adds every generator of this room. A new one is a file that offers `Component<Generator>
/// NAME_generator()`, and one line in registry.cc.
void register_generators(GeneratorRegistry& registry);

}  // namespace raygauge
