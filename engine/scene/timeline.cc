// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/scene/timeline.h"

#include <algorithm>
#include <cmath>

namespace raygauge {
namespace {

constexpr double kOutward = 1 + 1e-13;

// How far points within `reach` of the origin are from where they were: |t' - t| + ‖R' - R‖ reach, where the
// spectral norm of a difference of two rotations of the plane or of 3-space is its Frobenius norm over √2;
// in other dimensions it is at most the Frobenius norm.
double way(const Placement& before, const Placement& after, double reach) {
  constexpr double kRotationRounding = 1e-15;
  const int n = before.dimension();
  const bool turned = before.R != after.R;
  if (!turned && before.t == after.t) return 0;
  const double frobenius = turned ? (after.R - before.R).norm() + kRotationRounding : 0.0;
  const double rotation = n <= 3 ? frobenius / std::sqrt(2.0) : frobenius;
  return ((after.t - before.t).norm() + rotation * reach) * kOutward;
}

}  // namespace

Timeline::Timeline(const Scene& scene) : size_(scene.instants.size()) {
  const std::size_t total = scene.bodies.size() * size_;
  placements_.reserve(total);
  centers_.reserve(total);
  moved_.reserve(total);
  shifted_.reserve(total);
  for (const Body& body : scene.bodies) {
    double moved = 0;
    double shifted = 0;
    for (std::size_t k = 0; k < size_; ++k) {
      Placement here = body.motion->at(scene.instants[k]);
      SmallVector center = here.R * body.ball.center + here.t;
      if (k > 0) {
        moved += way(placements_.back(), here, body.reach);
        const double rounding = 1e-15 * (center.norm() + body.reach);
        if (moved > moved_.back()) shifted += (center - centers_.back()).norm() * kOutward + rounding;
      }
      placements_.push_back(std::move(here));
      centers_.push_back(std::move(center));
      moved_.push_back(moved);
      shifted_.push_back(shifted);
    }
  }
}

std::size_t Timeline::last_within(BodyPair pair, std::size_t from, double budget, bool balls) const {
  const std::vector<double>& path = balls ? shifted_ : moved_;
  const double* a = path.data() + index(pair.a, 0);
  const double* b = path.data() + index(pair.b, 0);
  // Differences of sums of up to 1e6 terms: their rounding is far below this share of the sums.
  const double rounding = 1e-10 * (a[size_ - 1] + b[size_ - 1]);
  const auto holds = [&](std::size_t k) { return (a[k] - a[from]) + (b[k] - b[from]) + rounding < budget; };
  std::size_t step = 1;
  while (from + step < size_ && holds(from + step)) step *= 2;
  std::size_t low = from + step / 2;  // holds, or is `from`
  if (step == 1) low = from;
  std::size_t high = std::min(from + step, size_);
  while (low + 1 < high) {
    const std::size_t middle = low + (high - low) / 2;
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace raygauge
