// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "raygauge/sweep/experiment.h"
#include "raygauge/sweep/instance.h"
#include "raygauge/sweep/method.h"

namespace raygauge::cli {

/// Reads an experiment (docs/experiments.md) and applies `overrides` ("sweep.n=3,4", see read_toml) before
/// anything is checked. The result is valid: grid_of accepts it, the registries know every generator, method
/// and parameter.
///
/// Throws, each with one line that names file and line: InvalidParameterError for a file that cannot be read,
/// TOML syntax, a wrong type or range; UnknownNameError for a key, generator, method or parameter that nobody
/// knows, with the known ones and the nearest of them.
Experiment read_experiment(const std::string& path, const std::vector<std::string>& overrides,
                           const GeneratorRegistry& generators, const MethodRegistry& methods);

/// The same of the text that a results file keeps, which came from `place`.
Experiment experiment_from_text(const std::string& text, const std::string& place,
                                const GeneratorRegistry& generators, const MethodRegistry& methods);

}  // namespace raygauge::cli
