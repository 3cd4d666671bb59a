// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "raygauge/sweep/instance.h"

namespace raygauge {

/// A family of instances as a function: it must depend on nothing but its arguments.
using GenerateFunction = Instance (*)(const InstanceKey& key, const Parameters& parameters);

/// The registry's entry for `generate`. The generators it makes throw InvalidParameterError unless
/// key.n >= minimum_n, key.N >= 1 and key.repetition >= 0, so that `generate` need not check these.
Component<Generator> generator_component(std::string name, std::string description,
                                         std::vector<ParameterInfo> parameters, GenerateFunction generate,
                                         int minimum_n = 1);

/// The same generator, which states the distance of every instance, whatever its parameters; `rounding` is
/// the relative error of what it states.
Component<Generator> with_known_distance(Component<Generator> generator, double rounding = 0);

/// Measures of hardness, see Hardness.
double reciprocal(double value);
double power_of_two(double value);

}  // namespace raygauge
