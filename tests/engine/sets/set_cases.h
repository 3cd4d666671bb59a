// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "raygauge/sets/convex_set.h"
#include "tests/engine/point_clouds.h"

namespace raygauge {

/// A set, and what is known of it independently of its support function.
struct SetCase {
  std::string name;
  std::shared_ptr<const ConvexSet> set;
  /// A random point of the set, often one of its boundary.
  std::function<Vector(Random&)> sample;
  /// How far x is outside the set, by some measure of length; <= 0 inside.
  std::function<double(const Vector&)> excess;
};

/// Every closed-form set and combinator, in several dimensions and degenerations.
std::vector<SetCase> set_cases();

inline std::ostream& operator<<(std::ostream& out, const SetCase& tested) { return out << tested.name; }

/// An orthogonal matrix with determinant 1.
Eigen::MatrixXd random_rotation(int n, Random& random);

}  // namespace raygauge
