// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/column_generation/support_oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/lp/scaling.h"
#include "engine/methods/column_generation/tuning.h"
#include "engine/numerics/floating_point.h"
#include "engine/sets/capability_queries.h"
#include "engine/sets/highest_points.h"
#include "engine/sets/object_pair.h"

namespace raygauge {
void SupportOracle::bind(const ConvexSet& S, const double* factor, const Kernels& kernels,
                         SupportPairs* pairs) {
  set_ = &S;
  pairs_ = pairs;
  points_ = as_point_set(S);
  kernels_ = &kernels;
  const auto n = static_cast<std::size_t>(S.dimension());
  direction_.reserve(n);
  if (factor == nullptr) {
    unit_.reserve(n);
    std::fill_n(unit_.data(), n, 1.0);
  }
  factor_ = factor != nullptr ? factor : unit_.data();
  if (points_ == nullptr) {
    magnitude_.reserve(n);
    S.magnitude_unchecked(magnitude_.data());
    const bool is_origin = *std::max_element(magnitude_.data(), magnitude_.data() + n) == 0;
    double largest = 0;
    for (std::size_t k = 0; k < n; ++k) {
      magnitude_[k] *= factor_[k];
      largest = std::max(largest, magnitude_[k]);
    }
    largest_magnitude_ = largest;
    underflow_ = is_origin ? 0.0 : kUnderflow;
    coordinate_error_ = ConvexSet::rounding_error(S.dimension()) * largest + underflow_;
    return;
  }
  coordinate_error_ = 0;
  largest_magnitude_ = 0;
  for (std::size_t k = 0; k < n; ++k) {
    largest_magnitude_ = std::max(largest_magnitude_, points_->coordinate_magnitude()[k] * factor_[k]);
  }
  working_.choose(*points_, factor_, factor == nullptr, keeps_shortlist());
  if (working_.is_complete()) return;
  const auto growth = static_cast<std::size_t>(ColumnPool::growth(*points_));
  better_.reserve(growth);
  better_value_.reserve(growth);
}

double SupportOracle::query(const double* u, double sign, double* point) {
  const int n = set_->dimension();
  double* direction = direction_.data();
  if (points_ != nullptr) {
    for (int k = 0; k < n; ++k) direction[k] = sign * u[k];
    std::ptrdiff_t index = 0;
    const PricedPoints view = working_.view();
    const double value = kernels_->price(view.blocks, view.block_count, n, direction, &index);
    working_.copy_point(index, point);
    return value;
  }
  for (int k = 0; k < n; ++k) direction[k] = sign * Scaling::direction_component(factor_[k], u[k]);
  const double value =
      pairs_ != nullptr ? pairs_->support(direction, point) : set_->support_unchecked(direction, point);
  for (int k = 0; k < n; ++k) point[k] *= factor_[k];
  return value;
}

bool SupportOracle::keeps_shortlist() const noexcept {
  return points_ != nullptr && points_->dimension() >= tuned::kShortlistDimension;
}

void SupportOracle::pass(const double* u, double sign) {
  const int n = set_->dimension();
  shortlist_.reserve(static_cast<std::size_t>(n) * PointSet::kLanes);
  single_.reserve(static_cast<std::size_t>(n));
  double* direction = direction_.data();
  for (int k = 0; k < n; ++k) direction[k] = sign * u[k];
  const PricedPoints view = working_.view();
  kernels_->best_of_lanes(&view, n, direction, single_.data(), shortlist_.data());
}

double SupportOracle::query_shortlist(const double* u, double sign, double* point) {
  const int n = set_->dimension();
  double* direction = direction_.data();
  for (int k = 0; k < n; ++k) direction[k] = sign * u[k];
  std::ptrdiff_t lane = 0;
  const double value = kernels_->price(shortlist_.data(), 1, n, direction, &lane);
  for (int k = 0; k < n; ++k)
    point[k] = shortlist_[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(k) * PointSet::kLanes + lane)];
  return value;
}

SupportValue SupportOracle::verify(const double* u, double sign, double known, double* point) {
  if (points_ != nullptr) return verify_points(u, sign, known, point);
  SupportValue result;
  result.value = query(u, sign, point);
  const int n = set_->dimension();
  double magnitude = 0;
  for (int k = 0; k < n; ++k) magnitude += std::fabs(u[k]) * magnitude_[static_cast<std::size_t>(k)];
  result.error = ConvexSet::rounding_error(n) * magnitude + underflow_;
  return result;
}

SupportValue SupportOracle::verify_points(const double* u, double sign, double known, double* point) {
  const int n = set_->dimension();
  if (known == -kInfinity && !working_.is_complete()) known = query(u, sign, point);
  double* direction = direction_.data();
  for (int k = 0; k < n; ++k) direction[k] = sign * Scaling::direction_component(factor_[k], u[k]);
  if (working_.is_complete()) {
    std::ptrdiff_t index = 0;
    const SupportValue result = support_value(*kernels_, *points_, direction, &index);
    working_.copy_point(index, point);
    return result;
  }
  Collection better{better_.data(), better_value_.data(), ColumnPool::growth(*points_), 0, known};
  SupportValue result;
  result.value = collect_points(*kernels_, *points_, direction, better);
  result.error = dot_error(*points_, direction);
  if (!well_resolved(result.value, result.error)) result = support_value(*kernels_, *points_, direction);
  for (std::ptrdiff_t i = 0; i < better.count; ++i) {
    working_.add(*points_, factor_, std::min<std::int64_t>(better.index[i], points_->size() - 1));
  }
  query(u, sign, point);
  return result;
}

double SupportOracle::inner_radius() {
  if (points_ != nullptr) return 0;
  const int n = set_->dimension();
  std::fill_n(direction_.data(), n, 0.0);
  const double radius =
      set_->inner_radius_unchecked(direction_.data()) * *std::min_element(factor_, factor_ + n);
  return std::isnormal(radius) ? radius : 0.0;
}

double SupportOracle::magnitude(int k) const noexcept {
  return points_ != nullptr ? points_->coordinate_magnitude()[k] * factor_[k]
                            : magnitude_[static_cast<std::size_t>(k)];
}

double SupportOracle::coordinate_error(int k) const noexcept {
  return points_ != nullptr ? 0.0 : ConvexSet::rounding_error(set_->dimension()) * magnitude(k) + underflow_;
}

double SupportOracle::gauge(const double* x, double* normal) {
  const int n = set_->dimension();
  for (int k = 0; k < n; ++k) {
    const double unscaled = x[k] / factor_[k];
    if (x[k] != 0 && !std::isnormal(unscaled)) return kInfinity;  // not x any more
    direction_[static_cast<std::size_t>(k)] = unscaled;
  }
  const double gauge = gauge_bound(*set_, direction_.data(), normal);
  for (int k = 0; k < n; ++k) normal[k] /= factor_[k];
  return gauge;
}

void SupportOracle::center(double* point) {
  set_->center_unchecked(point);
  for (int k = 0; k < set_->dimension(); ++k) point[k] *= factor_[k];
}

}  // namespace raygauge
