// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "bindings/c/border.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/queries/pair_batch.h"
#include "raygauge/queries/solver.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/pose.h"

// What is behind the handles of the C interface.

struct rg_set {
  std::shared_ptr<const raygauge::ConvexSet> set;
};

struct rg_pose {
  raygauge::Pose pose;
  raygauge::Pose next;  ///< takes new numbers, until they have proved to be a rotation
};

struct rg_warm {
  std::vector<raygauge::WarmStart> starts;
};

namespace raygauge::c {

/// The unit ball of the Euclidean metric, kept from call to call.
class EuclideanBall {
 public:
  const ConvexSet& of(int n) {
    if (ball_ == nullptr || ball_->dimension() != n) ball_ = std::make_unique<Ball>(Vector(n), 1.0);
    return *ball_;
  }

 private:
  std::unique_ptr<const Ball> ball_;
};

/// What the last query has left in its solver: one of the three, or none.
struct LastResult {
  int n = 0;
  const DistanceResult* distance = nullptr;
  const ObjectDistance* objects = nullptr;
  const SeparationResult* separation = nullptr;
};

/// The set in its pose. Throws InvalidParameterError for a null set, DimensionMismatchError for a pose of
/// another space.
Posed posed(const rg_set* set, const rg_pose* pose, const char* name);

/// Of growth distances and separations, whose automatic method is newton.
DistanceOptions growth_options(const DistanceOptions& options);

}  // namespace raygauge::c

/// Solvers are made when they are first asked, and made anew after an option has changed.
struct rg_solver {
  raygauge::DistanceOptions options;
  std::function<bool()> stop;
  std::optional<raygauge::DistanceSolver> distances;
  std::optional<raygauge::ObjectDistanceSolver> objects;
  std::optional<raygauge::GrowthDistanceSolver> growth;
  raygauge::c::EuclideanBall euclidean;
  raygauge::c::LastResult last;
};

struct rg_batch {
  raygauge::DistanceOptions options;
  std::optional<raygauge::PairBatch> objects;
  std::optional<raygauge::PairBatch> growth;
  raygauge::c::EuclideanBall euclidean;
  std::vector<raygauge::PosedPair> pairs;
  std::vector<raygauge::DistanceStatus> statuses;
};
