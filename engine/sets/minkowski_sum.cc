// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/minkowski_sum.h"

#include <utility>

#include "engine/sets/parameters.h"
#include "engine/sets/vector_kernels.h"

namespace raygauge {

MinkowskiSum::MinkowskiSum(std::shared_ptr<const ConvexSet> A, std::shared_ptr<const ConvexSet> B)
    : ConvexSet(checked_set("Minkowski sum", "A", A)->dimension()), A_(std::move(A)), B_(std::move(B)) {
  check_dimension("Minkowski sum", "B", checked_set("Minkowski sum", "B", B_)->dimension(), dimension());
}

double MinkowskiSum::do_support(const double* u, double* point) const {
  Scratch b(dimension());
  const double value = A_->support_unchecked(u, point) + B_->support_unchecked(u, b.data());
  for (int k = 0; k < dimension(); ++k) point[k] += b.data()[k];
  return value;
}

void MinkowskiSum::do_center(double* point) const {
  Scratch b(dimension());
  A_->center_unchecked(point);
  B_->center_unchecked(b.data());
  for (int k = 0; k < dimension(); ++k) point[k] += b.data()[k];
}

void MinkowskiSum::do_magnitude(double* magnitude) const {
  Scratch b(dimension());
  A_->magnitude_unchecked(magnitude);
  B_->magnitude_unchecked(b.data());
  for (int k = 0; k < dimension(); ++k) magnitude[k] += b.data()[k];
}

}  // namespace raygauge
