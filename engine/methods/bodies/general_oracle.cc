// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/bodies/general_oracle.h"

#include <algorithm>
#include <cmath>

namespace raygauge {

// A rounding more than the support mappings have, for the difference.
GeneralOracle::GeneralOracle(const ConvexSet& A1, const ConvexSet& A2, const ConvexSet& Q)
    : A1_(A1), A2_(A2), Q_(Q), n_(Q.dimension()) {
  double of_1[3] = {0, 0, 0}, of_2[3] = {0, 0, 0};
  A1.magnitude_unchecked(of_1);
  A2.magnitude_unchecked(of_2);
  Q.magnitude_unchecked(magnitude_);
  const double reach = length({of_1[0] + of_2[0], of_1[1] + of_2[1], of_1[2] + of_2[2]}) * (1 + 0x1p-40);
  error_ = ConvexSet::rounding_error(n_ + 1) * reach;
  size_ = 2 * reach;
  for (int k = n_; k < 3; ++k) height_[k] = reach;
  for (int k = 0; n_ < 3 && k < n_; ++k) {
    for (const double side : {1.0, -1.0}) {
      Vector3 u;
      (&u.x)[k] = side;
      metric_height_ = std::max(metric_height_, metric(u, -1));
    }
  }
}

double GeneralOracle::support(const Vector3& u, DepthPoint<double>& point) {
  const double v[3] = {u.x, u.y, u.z}, back[3] = {-u.x, -u.y, -u.z};
  double a1[3] = {0, 0, 0}, a2[3] = {0, 0, 0}, beyond[3] = {0, 0, 0};
  double height = A2_.support_unchecked(v, a2) + A1_.support_unchecked(back, a1);
  queries_ += 2;
  for (int k = n_; k < 3; ++k) {
    beyond[k] = v[k] < 0 ? -height_[k] : height_[k];
    height += v[k] * beyond[k];
  }
  point.a1 = {a1[0], a1[1], a1[2]};
  point.a2 = {a2[0], a2[1], a2[2]};
  point.s = point.a2 - point.a1 + Vector3{beyond[0], beyond[1], beyond[2]};
  return height;
}

double GeneralOracle::metric(const Vector3& u, double side) {
  const double v[3] = {u.x, u.y, u.z};
  double q[3];
  double height = Q_.support_unchecked(v, q), error = 0;
  for (int k = 0; k < n_; ++k) error += std::fabs(v[k]) * magnitude_[k];
  for (int k = n_; k < 3; ++k) height += std::fabs(v[k]) * metric_height_;
  return height + side * (ConvexSet::rounding_error(n_) * error + 0x1p-50 * std::fabs(height));
}

}  // namespace raygauge
