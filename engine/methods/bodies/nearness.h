// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "raygauge/numerics/vector3.h"

namespace raygauge {

/// Whether two unit vectors are within an angle of each other: the cosine is asked for only where its first
/// terms do not tell.
class Nearness {
 public:
  explicit Nearness(double angle) noexcept : angle_(angle), least_(1 - 0.5 * angle * angle) {}

  bool operator()(const Vector3& u, const Vector3& v) const noexcept {
    const double along = dot(u, v), square = angle_ * angle_;
    if (along > least_ + square * square * kFourth) return true;
    return along > least_ && along > std::cos(angle_);
  }

 private:
  static constexpr double kFourth = 1.0 / 24 + 1e-6;

  double angle_, least_;
};

}  // namespace raygauge
