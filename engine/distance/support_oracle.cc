// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/distance/support_oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/distance/scaling.h"

namespace raygauge {

void SupportOracle::bind(const ConvexSet& S, const double* factor, const Kernels& kernels) {
  set_ = &S;
  points_ = dynamic_cast<const PointSet*>(&S);
  factor_ = factor;
  kernels_ = &kernels;
  direction_.reserve(static_cast<std::size_t>(S.dimension()));
}

void SupportOracle::scale_direction(const double* u, double sign) {
  for (int k = 0; k < set_->dimension(); ++k) {
    direction_[static_cast<std::size_t>(k)] =
        sign * Scaling::direction_component(factor_ != nullptr ? factor_[k] : 1.0, u[k]);
  }
}

void SupportOracle::scale_point(double* point) const {
  if (factor_ == nullptr) return;
  for (int k = 0; k < set_->dimension(); ++k) point[k] *= factor_[k];
}

double SupportOracle::query(const double* u, double sign, double* point) {
  scale_direction(u, sign);
  double value = 0;
  if (points_ != nullptr) {
    std::ptrdiff_t index = 0;
    value = kernels_->price(points_->data(), points_->block_count(), points_->dimension(), direction_.data(),
                            &index);
    points_->copy_point(std::min(index, points_->size() - 1), point);
  } else {
    value = set_->support_unchecked(direction_.data(), point);
  }
  scale_point(point);
  return value;
}

SupportValue SupportOracle::query_with_error(const double* u, double sign, double* point) {
  SupportValue result;
  result.value = query(u, sign, point);
  if (points_ != nullptr) {
    result.error = dot_error(*points_, direction_.data());
    // Near cancellation the plain bound is too wide: evaluate the doubtful points more accurately.
    if (!well_resolved(result.value, result.error)) {
      result = support_value(*kernels_, *points_, direction_.data());
    }
    return result;
  }
  double magnitude = 0;
  for (int k = 0; k < set_->dimension(); ++k) magnitude += std::fabs(u[k] * point[k]);
  result.error = (set_->dimension() + 4) * (std::numeric_limits<double>::epsilon() / 2) * magnitude;
  return result;
}

void SupportOracle::center(double* point) {
  set_->center_unchecked(point);
  scale_point(point);
}

}  // namespace raygauge
