// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/point_clouds.h"

#include <memory>

#include "raygauge/sets/point_set.h"

namespace raygauge {

Instance to_instance(const PointClouds& clouds, std::optional<double> exact_distance) {
  return {std::make_shared<PointSet>(clouds.A), std::make_shared<PointSet>(clouds.Q), exact_distance};
}

}  // namespace raygauge
