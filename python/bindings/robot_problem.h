// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "raygauge/scene/edge_checker.h"

namespace raygauge::python {

/// What raygauge.EdgeChecker and raygauge.plan are about: a robot among obstacles. Both modules of the
/// package know the class.
struct RobotProblem {
  RobotModel robot;
  std::vector<Body> obstacles;
  EdgeOptions options;
};

}  // namespace raygauge::python
