// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "raygauge/sweep/instance.h"
#include "raygauge/sweep/method.h"

namespace raygauge::cli {

/// Every generator of this build that needs a seed only.
GeneratorRegistry all_generators();

/// What a sweep may name: these and `files`, whose relative names start at the folder of the experiment.
GeneratorRegistry sweep_generators(const std::string& experiment_path);

/// Every method of this build: the engine's and the baselines'.
MethodRegistry all_methods();

/// What a sweep may name: these and `command`, which needs a parameter that tells whose program to run.
MethodRegistry sweep_methods();

}  // namespace raygauge::cli
