// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "raygauge/sweep/instance.h"

namespace raygauge {

/// The points of both sets of an instance, one a column; both have n rows.
struct PointClouds {
  Eigen::MatrixXd A;
  Eigen::MatrixXd Q;
};

/// The clouds as point sets, with the exact distance where it is known.
Instance to_instance(const PointClouds& clouds, std::optional<double> exact_distance = std::nullopt);

}  // namespace raygauge
