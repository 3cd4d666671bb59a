// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "engine/methods/spatial/spatial_distance.h"

namespace raygauge {

/// What bounds the growth distance σ = gauge_B(p) of a pair, in the terms of spatial_growth().
class GrowthBounds {
 public:
  GrowthBounds(SpatialPair& pair, double tolerance, double threshold, SpatialAnswer& answer)
      : pair_(pair),
        tolerance_(tolerance),
        threshold_(threshold),
        p_(pair.between_centers()),
        answer_(answer) {
    inner_radius_ = kDown * pair.inner_radius() - 2 * pair.error();
  }

  SpatialPair& pair() const noexcept { return pair_; }
  const Vector3& p() const noexcept { return p_; }
  double tolerance() const noexcept { return tolerance_; }
  SpatialAnswer& answer() const noexcept { return answer_; }

  /// s_B(u), balls included.
  SpatialPoint support(const Vector3& u);

  /// Whether the bounds are close enough, or on one side of the threshold: the answer has its end then.
  bool is_done();

  /// σ >= u·p/u·s, s the support point of u. Both are within |u| error() of what they stand for.
  void bound_from_below(const Vector3& u, const Vector3& s);

  /// σ <= Σ c_l + |p - Σ c_l s_l|/R.
  void bound_from_above(const SpatialPoint* corner, int count, const double* weight);

  /// A ball is inside B: where the ray of p leaves it, t p, proves σ <= 1/t. Its centre and radius are off by
  /// `error`. Needs a lower bound; false where the ray misses the ball.
  bool bound_in_ball(const Vector3& center, double radius, double error);

 protected:
  static constexpr double kUp = 1 + 0x1p-46,
                          kDown = 1 - 0x1p-46;  ///< a few operations on numbers that are certain otherwise

  SpatialPair& pair_;
  double tolerance_, threshold_;
  Vector3 p_;
  double inner_radius_;
  SpatialAnswer& answer_;
};

// Not in line: loops over exchanges and discoveries are the faster for it.
[[gnu::noinline]] inline SpatialPoint GrowthBounds::support(const Vector3& u) {
  SpatialPoint w;
  pair_.support(u, w);
  w.s = w.s + p_;
  if (pair_.radius() > 0) w.s = w.s + u * (pair_.radius() / length(u));
  ++answer_.iterations;
  return w;
}

inline bool GrowthBounds::is_done() {
  if (answer_.bounds.close(tolerance_)) {
    answer_.end = SpatialEnd::closed;
  } else if (answer_.bounds.lower() > threshold_) {
    answer_.end = SpatialEnd::separated;
  } else if (answer_.bounds.upper() < threshold_) {
    answer_.end = SpatialEnd::intersecting;
  }
  return answer_.end != SpatialEnd::open;
}

[[gnu::noinline]] inline void GrowthBounds::bound_from_below(const Vector3& u, const Vector3& s) {
  const double slack = 2 * pair_.error() * length(u);
  const double along = dot(u, p_) - slack, height = dot(u, s) + slack;
  if (!(along > 0) || !(height > 0)) return;
  answer_.raise_lower(along / height * kDown, u);
}

// p and the rounding of what is below are within error(), t times.
inline bool GrowthBounds::bound_in_ball(const Vector3& center, double radius, double error) {
  const double least = answer_.bounds.lower();
  if (!(least > 0)) return false;
  radius -= error + 2 * pair_.error() * (1 + 1 / least);
  const double square = dot(p_, p_), along = dot(p_, center);
  const Vector3 off = center - p_ * (along / square);
  const double room = radius * radius - dot(off, off);
  if (!(radius > 0) || !(room > 0)) return false;
  const double leaves = along + std::sqrt(square * room);  // t p²
  if (leaves > 0) answer_.bounds.reduce_upper(square / leaves * kUp);
  return leaves > 0;
}

[[gnu::noinline]] inline void GrowthBounds::bound_from_above(const SpatialPoint* corner, int count,
                                                             const double* weight) {
  Vector3 r = p_;
  double sum = 0, price = __builtin_inf();
  for (int i = 0; i < count; ++i) {
    r = r - corner[i].s * weight[i];
    sum += weight[i];
  }
  if (inner_radius_ > 0) price = (length(r) + 2 * pair_.error() * (1 + sum)) / inner_radius_ * kUp;
  answer_.bounds.reduce_upper(sum * kUp + price);
}

}  // namespace raygauge
