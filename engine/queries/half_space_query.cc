// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/half_space_query.h"

#include <algorithm>
#include <cmath>

#include "engine/methods/problem.h"
#include "engine/methods/spatial/precise_pair.h"
#include "engine/numerics/floating_point.h"
#include "engine/numerics/vector_kernels.h"
#include "engine/sets/parameters.h"
#include "engine/sets/posed_view.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

constexpr double kUp = 1 + 0x1p-50, kDown = 1 - 0x1p-50;
constexpr double kOutward = 1 + 0x1p-40;  // of sums of error bounds

/// R x for R given by columns.
PreciseVector3 turned(const double* R, int n, const PreciseVector3& x) {
  const auto row = [&](int k) {
    return n == 3 ? dot(x, Vector3{R[k], R[3 + k], R[6 + k]}) : dot(x, Vector3{R[k], R[2 + k], 0});
  };
  return {row(0), row(1), n == 3 ? row(2) : DoubleDouble{}};
}

PreciseVector3 turned_back(const double* R, int n, const PreciseVector3& x) {
  const auto column = [&](int k) {
    const double* r = R + std::ptrdiff_t{k} * n;
    return dot(x, Vector3{r[0], r[1], n == 3 ? r[2] : 0.0});
  };
  return {column(0), column(1), n == 3 ? column(2) : DoubleDouble{}};
}

double length_of(const double* x, int n) {
  return x == nullptr ? 0.0 : Eigen::Map<const Eigen::VectorXd>(x, n).norm();
}

}  // namespace

bool HalfSpaceQuery::bind(const Posed& first, const Posed& second) {
  const HalfSpace *one = as_half_space(first.set), *two = as_half_space(second.set);
  if (one == nullptr && two == nullptr) return false;
  if (one != nullptr && two != nullptr) {
    throw InvalidParameterError("one of two objects must be bounded, but both are half-spaces");
  }
  check_dimension("objects", "the second", second.dimension(), first.dimension());
  is_first_ = one != nullptr;
  half_space_ = is_first_ ? one : two;
  body_.emplace(is_first_ ? second : first);
  pose_ = (is_first_ ? first : second).pose;
  if (pose_ != nullptr) check_dimension("objects", "a pose", pose_->dimension(), first.dimension());
  support_queries_ = 0;
  turn_normal();
  bound_gap();
  return true;
}

// R⁻ᵀn = R(1 + E)⁻¹n with E = RᵀR - 1. A pose that only exchanges axes turns n without an error.
void HalfSpaceQuery::turn_normal() {
  const Vector& n = half_space_->normal();
  const int size = half_space_->dimension();
  normal_ = n;
  normal_error_ = 0;
  if (pose_ != nullptr) {
    const double* R = pose_->rotation_data();
    for (int k = 0; k < size; ++k) {
      normal_[k] = 0;
      for (int j = 0; j < size; ++j) normal_[k] += R[std::ptrdiff_t{j} * size + k] * n[j];
    }
    const double of_products = ConvexSet::rounding_error(size) * std::sqrt(size);
    if (!pose_->is_axis_exchange())
      normal_error_ = (1.01 * of_products + 1.02 * pose_->defect()) * n.norm() * kOutward;
  }
  direction_ = (is_first_ ? -1.0 : 1.0) * normal_;
}

void HalfSpaceQuery::bound_gap() {
  const int n = half_space_->dimension();
  const InPose body(*body_);
  minus_ = -normal_;
  point_.resize(n);
  of_metric_.resize(n);
  magnitude_.resize(n);
  const double h = body.set().support_unchecked(minus_.data(), point_.data());
  body.set().magnitude_unchecked(magnitude_.data());
  ++support_queries_;
  double of_place = 0, terms = 0;
  const double* t = pose_ != nullptr ? pose_->translation_data() : nullptr;
  for (int k = 0; k < n; ++k) {
    terms += std::fabs(normal_[k]) * magnitude_[k];
    if (t == nullptr) continue;
    of_place += normal_[k] * t[k];
    terms += std::fabs(normal_[k] * t[k]);
  }
  const double b = half_space_->offset();
  const double gap = -h - of_place - b;
  const double of_sum = 4 * kUnitRoundoff * (std::fabs(h) + std::fabs(of_place) + std::fabs(b));
  const double of_normal =
      normal_error_ > 0 ? normal_error_ * (magnitude_.norm() + length_of(t, n)) : normal_error_;
  const double error = (ConvexSet::rounding_error(n) * terms + of_sum + of_normal + kUnderflow) * kOutward;
  minus_ = -direction_;
  const bool finite = std::isfinite(gap) && std::isfinite(error);
  gap_lower_ = finite ? gap - error : -kInfinity;
  gap_upper_ = finite ? gap + error : kInfinity;
}

// With R(1 - E)n, which is R⁻ᵀn but for E².
void HalfSpaceQuery::refine_gap(InstructionSet isa) {
  static constexpr double kIdentity3[] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, kIdentity2[] = {1, 0, 0, 1};
  static constexpr double kZero[] = {0, 0, 0};
  const int n = half_space_->dimension();
  if (n != 2 && n != 3) return;
  if (!origin_ || origin_->dimension() != n) origin_.emplace(Vector::Zero(n), 0.0);
  const double* t = pose_ != nullptr ? pose_->translation_data() : kZero;
  if (!pair_.bind(body_->set, *origin_, isa) ||
      !pair_.place(PoseNumbers(body_->pose), {n == 3 ? kIdentity3 : kIdentity2, t, 0})) {
    return;
  }
  PrecisePair precise;
  if (!precise.bind(pair_)) return;
  const Vector& given = half_space_->normal();
  PreciseVector3 m = raygauge::precise({given[0], given[1], n == 3 ? given[2] : 0.0});
  double defect = 0;
  if (pose_ != nullptr) {
    const double* R = pose_->rotation_data();
    const PreciseVector3 once = turned(R, n, m), change = turned_back(R, n, once) - m;
    m = once - turned(R, n, change);
    defect = pose_->defect();
  }
  const DoubleDouble height = precise.height(-m);
  const double b = half_space_->offset(), size = 2 * pair_.size();
  const DoubleDouble gap = -height + -b;
  const double of_points = 2 * precise.error() + (1.1 * defect * defect + 0x1p-94) * size;
  const double error =
      (of_points * given.norm() * kUp + 0x1p-98 * (std::fabs(height.high) + std::fabs(b)) + kUnderflow) *
      kOutward;
  const double rounded = gap.rounded(), last = std::fabs(rounded) * 0x1p-52;
  ++support_queries_;
  if (!std::isfinite(rounded) || !std::isfinite(error)) return;
  gap_lower_ = std::max(gap_lower_, rounded - (last + error) * kUp);
  gap_upper_ = std::min(gap_upper_, rounded + (last + error) * kUp);
}

HalfSpaceQuery::Height HalfSpaceQuery::height_of(const ConvexSet& Q, const Vector& u, double* point) const {
  const int n = half_space_->dimension();
  Scratch room(n);
  const Eigen::Map<Eigen::VectorXd> magnitude(room.data(), n);
  const double h = Q.support_unchecked(u.data(), point);
  Q.magnitude_unchecked(room.data());
  const double error =
      (ConvexSet::rounding_error(n) * u.cwiseAbs().dot(magnitude) + normal_error_ * magnitude.norm()) *
      kOutward;
  return {h - error, h + error};
}

double HalfSpaceQuery::lower_bound(const ConvexSet& Q) const {
  if (!(gap_lower_ > 0)) return 0;
  Scratch point(half_space_->dimension());
  const Height height = height_of(Q, minus_, point.data());
  return height.upper > 0 ? gap_lower_ / height.upper * kDown : 0.0;
}

// `length` times the support point of the metric leads from a point of the first object to one of the second.
void HalfSpaceQuery::put_points(double length, Vector& point_1, Vector& point_2) const {
  point_1 = point_2 = point_;
  if (is_first_) {
    point_1 -= length * of_metric_;
  } else {
    point_2 += length * of_metric_;
  }
}

void HalfSpaceQuery::put_distance(const ConvexSet& Q, double tolerance, bool points, ObjectDistance& result) {
  DistanceResult& distance = result.distance;
  const Height height = height_of(Q, minus_, of_metric_.data());
  distance.normal.resize(0);
  if (gap_upper_ <= 0) return write_bounds({0, 0}, 0, DistanceStatus::contains_origin, distance);
  const bool apart = gap_lower_ > 0;
  if (apart && height.upper <= 0) {
    write_bounds({kInfinity, kInfinity}, kInfinity, DistanceStatus::unreachable, distance);
    distance.normal = direction_;
    return;
  }
  Bounds bounds;
  if (apart) bounds.raise_lower(gap_lower_ / height.upper * kDown);
  if (height.lower > 0) bounds.reduce_upper(gap_upper_ / height.lower * kUp);
  write_bounds(bounds, bounds.upper() < kInfinity ? bounds.upper() : bounds.lower(),
               bounds.close(tolerance) ? DistanceStatus::optimal : DistanceStatus::precision_limit, distance);
  if (!apart) return;
  distance.normal.resize(direction_.size());  // into the memory that it keeps
  distance.normal = direction_ / height.upper;
  if (!points || !(bounds.upper() < kInfinity)) return;
  put_points(distance.distance, result.closest_point_1, result.closest_point_2);
  ++result.closest_point_evaluations;
}

void HalfSpaceQuery::put_depth(const ConvexSet& Q, double tolerance, ObjectDepth& depth) {
  const Height height = height_of(Q, direction_, of_metric_.data());
  depth.evaluations = 1;
  depth.iterations = 0;
  depth.support_queries = 1;
  Bounds bounds;
  if (height.upper > 0) {
    bounds.raise_lower(-gap_upper_ / height.upper * kDown);
  } else if (gap_upper_ < 0) {
    bounds.raise_lower(kInfinity);
  }
  if (height.lower > 0) bounds.reduce_upper(std::max(0.0, -gap_lower_) / height.lower * kUp);
  depth.lower = bounds.lower();
  depth.upper = depth.depth = bounds.upper();
  const bool known = bounds.close(tolerance) || bounds.upper() == 0;
  depth.status = bounds.lower() == kInfinity ? DistanceStatus::unreachable
                 : known                     ? DistanceStatus::optimal
                                             : DistanceStatus::precision_limit;
  depth.normal.resize(0);
  depth.point_1.resize(0);
  depth.point_2.resize(0);
  if (!(height.lower > 0)) return;
  depth.normal.resize(direction_.size());
  depth.normal = direction_ / height.upper;
  put_points(depth.depth, depth.point_1, depth.point_2);
}

void HalfSpaceQuery::distance(const ConvexSet& Q, const DistanceOptions& options, ObjectEffects effects,
                              ObjectDistance& result) {
  check_dimension("distance", "Q", Q.dimension(), half_space_->dimension());
  constexpr double kShare = 0.5;  // of the tolerance, for the gap; the other is the metric's
  const double size = std::max(gap_upper_, -gap_lower_);
  if (!(gap_upper_ - gap_lower_ <= kShare * options.tolerance * size)) refine_gap(options.instruction_set);
  DistanceResult& distance = result.distance;
  result.closest_point_evaluations = result.gradient_evaluations = 0;
  result.closest_point_1.resize(0);
  result.closest_point_2.resize(0);
  put_distance(Q, options.tolerance, has_effect(effects, ObjectEffects::closest_points), result);
  distance.counters = {};
  distance.counters.outer_iterations = 1;
  distance.counters.support_queries = support_queries_ + 1;
  distance.sigma = distance.seconds = DistanceResult::kUnset;
  distance.origin_weights.clear();
  distance.contact_point.resize(0);
  if (has_effect(effects, ObjectEffects::depth) && !(distance.lower > 0))
    put_depth(Q, options.tolerance, result.depth);
}

Separation HalfSpaceQuery::separation(const DistanceOptions& options) {
  if (!(gap_lower_ > 0) && !(gap_upper_ <= 0)) refine_gap(options.instruction_set);
  if (gap_lower_ > 0) return Separation::separated;
  return gap_upper_ <= 0 ? Separation::intersecting : Separation::undecided;
}

}  // namespace raygauge
