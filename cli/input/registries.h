// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/sweep/instance.h"
#include "engine/sweep/method.h"

namespace raygauge::cli {

/// Every generator of this build.
GeneratorRegistry all_generators();

/// Every method of this build: the engine's and the baselines'.
MethodRegistry all_methods();

}  // namespace raygauge::cli
