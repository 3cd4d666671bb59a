// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What does a distance, or a depth, from a half-space cost, beside two balls and a box of 1 km for the floor?
#include <benchmark/benchmark.h>

#include <memory>
#include <random>

#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/half_space.h"
#include "raygauge/sets/prepared_set.h"

namespace raygauge::bench {
namespace {

using Eigen::Vector3d;
using SetPointer = std::shared_ptr<const ConvexSet>;

SetPointer body(int kind) {
  if (kind == 0) return std::make_shared<Ball>(Vector3d::Zero(), 0.5);
  if (kind == 1) return std::make_shared<Capsule>(Vector3d(0, 0, -1), Vector3d(0, 0, 1), 0.3);
  if (kind == 2) return std::make_shared<Box>(Vector3d(-0.5, -0.4, -0.3), Vector3d(0.5, 0.4, 0.3));
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd points(3, 200);
  for (double& x : points.reshaped()) x = normal(random);
  points.colwise().normalize();
  return std::make_shared<PreparedSet>(points);
}

SetPointer ground(int kind) {
  if (kind == 0) return std::make_shared<HalfSpace>(Vector3d(0, 0, 1), 0);
  if (kind == 1) return std::make_shared<Box>(Vector3d(-500, -500, -1000), Vector3d(500, 500, 0));
  return std::make_shared<Ball>(Vector3d(0, 0, -1), 1);
}

/// Arguments: body (ball, capsule, box, hull of 200), ground (half-space, box, ball), height in hundredths.
void distance(benchmark::State& state) {
  const SetPointer falling = body(static_cast<int>(state.range(0))),
                   below = ground(static_cast<int>(state.range(1)));
  const double height = 0.01 * static_cast<double>(state.range(2));
  const Ball metric(Vector3d::Zero(), 1.0);
  const Pose pose(Eigen::Quaterniond(1, 0.2, 0.3, 0.4).normalized(), Vector3d(0.1, 0.2, height));
  const Pose still(3);
  ObjectDistanceSolver solver;
  const auto effects = ObjectEffects::closest_points | ObjectEffects::depth;
  for (auto _ : state) {
    benchmark::DoNotOptimize(solver.solve({*falling, pose}, {*below, still}, metric, effects).distance.lower);
  }
}
BENCHMARK(distance)
    ->ArgsProduct({{0, 1, 2, 3}, {0, 1, 2}, {150, 20}})
    ->ArgNames({"body", "ground", "height"});

}  // namespace
}  // namespace raygauge::bench
