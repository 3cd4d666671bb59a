// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/queries/timeline.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "engine/numerics/floating_point.h"
#include "engine/threads/team.h"
#include "raygauge/sets/pose.h"

namespace raygauge {
namespace {

constexpr double kOutward = 1 + 1e-13;
constexpr std::size_t kInstantsPerStop = 1024;

// path + step, and more than path where there is a step at all, however small: a body that has moved is not
// taken for one that stands. NaN, which equals nothing, where numbers are too large for their squares.
double longer(double path, double step) {
  constexpr double kLongest = 1e150;
  if (step == 0) return path;
  double sum = path + step;
  if (sum == path) sum = std::nextafter(path, kInfinity);
  return sum <= kLongest ? sum : std::numeric_limits<double>::quiet_NaN();
}

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
  return ((after.t - before.t).norm() + (turned ? rotation * reach : 0)) * kOutward;
}

}  // namespace

Timeline::Timeline(const Scene& scene, int threads, const std::function<bool()>& stop)
    : dimension_(scene.dimension()), size_(scene.instants.size()) {
  const std::size_t total = scene.bodies.size() * size_;
  const auto n = static_cast<std::size_t>(dimension_);
  placements_ = std::make_unique_for_overwrite<double[]>(total * numbers_of_placement());
  centers_ = std::make_unique_for_overwrite<double[]>(total * n);
  moved_ = std::make_unique_for_overwrite<double[]>(total);
  shifted_ = std::make_unique_for_overwrite<double[]>(total);
  std::atomic<std::size_t> next{0};
  run_team(threads, {}, [&](int, int) {
    for (std::size_t body = next++; body < scene.bodies.size(); body = next++) follow(scene, body, stop);
  });
}

// The body's way from instant to instant.
void Timeline::follow(const Scene& scene, std::size_t number, const std::function<bool()>& stop) {
  const Body& body = scene.bodies[number];
  const auto n = static_cast<std::size_t>(dimension_);
  double moved = 0;
  double shifted = 0;
  Placement before;
  SmallVector center_before;
  Pose pose(dimension_);
  for (std::size_t k = 0; k < size_; ++k) {
    if (k % kInstantsPerStop == 0 && stop && stop()) return;
    const std::size_t at = number * size_ + k;
    const Placement here = body.motion->at(scene.instants[k]);
    const SmallVector center = here.R * body.ball.center + here.t;
    if (k > 0) {
      moved = longer(moved, way(before, here, body.reach));
      const double rounding = 1e-15 * (center.norm() + body.reach);
      const bool stands = moved == moved_[at - 1];
      if (!stands) shifted = longer(shifted, (center - center_before).norm() * kOutward + rounding);
    }
    pose.assign(here.R.data(), here.t.data());
    double* placement = placements_.get() + at * numbers_of_placement();
    std::copy_n(here.R.data(), n * n, placement);
    std::copy_n(here.t.data(), n, placement + n * n);
    placement[n * n + n] = pose.defect();
    std::copy_n(center.data(), n, centers_.get() + at * n);
    before = here;
    center_before = center;
    moved_[at] = moved;
    shifted_[at] = shifted;
  }
}

Placement Timeline::placement(int body, std::size_t k) const {
  const int n = dimension_;
  const double* numbers = placements_.get() + index(body, k) * numbers_of_placement();
  const double* t = numbers + std::ptrdiff_t{n} * n;
  return {SmallMatrix::Map(numbers, n, n), SmallVector::Map(t, n), t[n]};
}

std::size_t Timeline::last_within(BodyPair pair, std::size_t from, double budget, bool balls) const {
  const double* path = balls ? shifted_.get() : moved_.get();
  const double* a = path + index(pair.a, 0);
  const double* b = path + index(pair.b, 0);
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
