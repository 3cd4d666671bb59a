// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "generators/random.h"
#include "raygauge/sweep/instance.h"

namespace raygauge::soak {

/// A generator, its parameters and the key of an instance, drawn at random.
struct RandomFamily {
  std::string generator;
  Parameters parameters;
  InstanceKey key;
};

/// Names of the generators whose instances are pairs of point sets.
std::vector<std::string> point_set_generators(const GeneratorRegistry& registry);

/// Draws one of `names`, every parameter within its declared range (half of the time near its default), n in
/// 2, …, 50 with small n far more often, and N from n + 1 to a few hundred.
RandomFamily draw_family(const GeneratorRegistry& registry, const std::vector<std::string>& names,
                         RandomStream& stream);

}  // namespace raygauge::soak
