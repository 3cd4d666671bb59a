// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/minkowski_difference.h"

#include <utility>

#include "engine/sets/parameters.h"
#include "engine/sets/vector_kernels.h"

namespace raygauge {

MinkowskiDifference::MinkowskiDifference(std::shared_ptr<const ConvexSet> A2,
                                         std::shared_ptr<const ConvexSet> A1)
    : ConvexSet(checked_set("Minkowski difference", "A2", A2)->dimension()),
      A2_(std::move(A2)),
      A1_(std::move(A1)) {
  check_dimension("Minkowski difference", "A1", checked_set("Minkowski difference", "A1", A1_)->dimension(),
                  dimension());
}

double MinkowskiDifference::do_support(const double* u, double* point) const {
  const int n = dimension();
  Scratch opposite(n), a1(n);
  for (int k = 0; k < n; ++k) opposite.data()[k] = -u[k];
  const double value = A2_->support_unchecked(u, point) + A1_->support_unchecked(opposite.data(), a1.data());
  for (int k = 0; k < n; ++k) point[k] -= a1.data()[k];
  return value;
}

void MinkowskiDifference::do_center(double* point) const {
  Scratch a1(dimension());
  A2_->center_unchecked(point);
  A1_->center_unchecked(a1.data());
  for (int k = 0; k < dimension(); ++k) point[k] -= a1.data()[k];
}

void MinkowskiDifference::do_magnitude(double* magnitude) const {
  Scratch a1(dimension());
  A2_->magnitude_unchecked(magnitude);
  A1_->magnitude_unchecked(a1.data());
  for (int k = 0; k < dimension(); ++k) magnitude[k] += a1.data()[k];
}

}  // namespace raygauge
