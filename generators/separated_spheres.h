// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "generators/point_clouds.h"
#include "generators/random.h"
#include "raygauge/sweep/instance.h"

namespace raygauge {

/// The parameter `separation` = (distance of the spheres' centres) / (sum of their radii): 1 for touching
/// spheres.
ParameterInfo separation_parameter();

/// N points uniform on the unit sphere about the origin of R^n.
Eigen::MatrixXd random_sphere_points(RandomStream& stream, int n, int N);

/// Adds to every point of A the centre 2 · separation · e, e uniform on the unit sphere: A's unit sphere is
/// moved away from Q's.
void move_apart(PointClouds& clouds, const InstanceKey& key, std::string_view generator, double separation);

}  // namespace raygauge
