// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/streamed_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/proof/bounds.h"
#include "engine/proof/certificate.h"
#include "engine/queries/streamed_hull.h"
#include "engine/queries/tuning.h"

namespace raygauge {
namespace {

// Of a plane that leaves a set behind, how much nearer points may come.
constexpr double kShareOfPlane = 0.5;
// Far more than any problem needs.
constexpr int kMostPasses = 50;

bool is_concluded(DistanceStatus status) {
  return status != DistanceStatus::optimal && status != DistanceStatus::unreachable &&
         status != DistanceStatus::precision_limit;
}

}  // namespace

StreamedDistance::StreamedDistance(const ConvexSet& A, const ConvexSet& Q, const DistanceOptions& options,
                                   const std::function<bool()>* stop)
    : options_(options), stop_(stop) {
  const ConvexSet* sets[] = {&A, &Q};
  for (int t = 0; t < 2; ++t) {
    side_[t].set = sets[t];
    side_[t].sign = t == 0 ? 1.0 : -1.0;
    if (const StreamedHull* hull = as_streamed_hull(*sets[t]))
      side_[t].streamed = std::make_unique<StreamedSet>(hull->stream());
    take_working_set(side_[t]);
  }
}

void StreamedDistance::take_working_set(Side& side) {
  if (side.streamed == nullptr) return;
  side.working_set = side.streamed->working_set();
  side.set = side.working_set.get();
}

const DistanceResult& StreamedDistance::solve(Effects effects) {
  effects_ = effects;
  passes_ = 0;
  points_priced_ = 0;
  stopwatch_.start(options_.time_limit, stop_);
  resolve();
  bool again = !is_concluded(result_.status);
  while (again) {
    ++passes_;
    bool turned = false;
    for (Side& side : side_) turned = (side.streamed != nullptr && pass(side)) || turned;
    if (is_concluded(result_.status)) break;
    if (!turned) prove();
    again = turned && passes_ < kMostPasses;
    if (turned && !again) result_.status = DistanceStatus::iteration_limit;
  }
  // Of the working sets alone nothing is known from below.
  if (is_concluded(result_.status)) result_.lower = 0;
  if (result_.upper == 0) result_.status = DistanceStatus::contains_origin;
  result_.counters.outer_iterations = passes_;
  result_.counters.points_priced = points_priced_;
  return result_;
}

// Of the working sets as they are now.
void StreamedDistance::resolve() {
  DistanceOptions options = options_;
  options.tolerance *= tuned::kShareOfStream;
  if (stopwatch_.limited()) options.time_limit = std::max(stopwatch_.remaining(), 1e-3);
  for (Side& side : side_) take_working_set(side);
  DistanceSolver solver(options);
  if (stop_ != nullptr) solver.set_stop(*stop_);
  result_ = solver.solve(*side_[0].set, *side_[1].set, effects_);
  for (PointWeight& weight : result_.origin_weights) {
    if (side_[0].streamed != nullptr) weight.index = side_[0].streamed->number_of(weight.index);
  }
  for (Side& side : side_) aim(side);
}

void StreamedDistance::aim(Side& side) const {
  side.direction = side.sign * result_.normal;
  side.level = side.set->support_function(side.direction);
  const bool is_plane = result_.status == DistanceStatus::unreachable;
  side.slack =
      (is_plane ? kShareOfPlane : tuned::kShareOfStream * options_.tolerance) * std::fabs(side.level);
}

// Whether the normal has changed meanwhile.
bool StreamedDistance::pass(Side& side) {
  bool turned = false;
  side.h.value = -std::numeric_limits<double>::infinity();
  side.streamed->stream().pass([&](const StreamedPoints& part) {
    for (;;) {
      const double reach = tuned::kReachOfStream * std::fabs(side.level);
      const double value = side.streamed->look(part, side.direction.data(), side.level, reach);
      points_priced_ += part.count;
      side.h.value = std::max(side.h.value, value);
      if (stopwatch_.expired()) result_.status = DistanceStatus::time_limit;
      if (is_concluded(result_.status)) return false;
      if (!(value > side.level + side.slack)) return true;
      if (!std::isfinite(value)) return false;  // proves nothing
      resolve();
      turned = true;
    }
  });
  return turned;
}

// h of what the last pass has not gone through.
void StreamedDistance::measure_known(Side& side) const {
  if (side.streamed != nullptr) {
    side.h.error = side.streamed->rounding(side.direction.data());
    return;
  }
  Vector magnitude(side.set->dimension());
  side.set->magnitude_unchecked(magnitude.data());
  side.h.value = side.level;
  side.h.error = ConvexSet::rounding_error(side.set->dimension()) * side.direction.cwiseAbs().dot(magnitude) *
                     (1 + 1e-9) +
                 std::numeric_limits<double>::min();
}

// What is proven of working sets that hold all points is proven.
void StreamedDistance::prove() {
  const auto is_whole = [](const Side& side) {
    return side.streamed == nullptr || side.working_set->size() == side.streamed->size();
  };
  if (is_whole(side_[0]) && is_whole(side_[1])) return;
  for (Side& side : side_) measure_known(side);
  const double lower = lower_bound(side_[0].h, side_[1].h);
  if (result_.status == DistanceStatus::unreachable && lower == std::numeric_limits<double>::infinity())
    return;
  if (result_.status == DistanceStatus::unreachable) {
    result_.lower = 0;
    result_.status = DistanceStatus::precision_limit;
    return;
  }
  result_.lower = std::min(lower, result_.upper);
  result_.distance = std::clamp(result_.distance, result_.lower, result_.upper);
  const bool close = Bounds(lower, result_.upper).close(options_.tolerance);
  result_.status = close ? DistanceStatus::optimal : DistanceStatus::precision_limit;
}

}  // namespace raygauge
