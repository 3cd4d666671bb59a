// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "cli/input/toml_source.h"
#include "raygauge/sweep/experiment.h"
#include "raygauge/sweep/instance.h"
#include "raygauge/sweep/method.h"

namespace raygauge::cli {

/// The [[generator]] entries of an experiment. Parameters given as lists or ranges are swept: one component
/// for each combination, the last parameter (in name order) fastest; n and N are the axes of the entry, not
/// swept here. Throws as read_experiment does.
std::vector<GeneratorSpec> read_generators(const TomlSource& source, const GeneratorRegistry& registry);

/// The [[method]] entries, each with its label. Throws as read_experiment does.
std::vector<ComponentSpec> read_methods(const TomlSource& source, const MethodRegistry& registry);

}  // namespace raygauge::cli
