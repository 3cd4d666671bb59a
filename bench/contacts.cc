// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What do gradients by pose and contact patches add to the time of a distance or a depth? A body of each kind
// above a box: parallel to it, and turned. Warm: after a motion of 0.01 rad and 0.002.
#include <benchmark/benchmark.h>

#include <Eigen/Geometry>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/prepared_set.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::bench {
namespace {

using V = Eigen::Vector3d;

const std::vector<std::pair<const char*, std::shared_ptr<const ConvexSet>>>& bodies() {
  static const auto kAll = [] {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    Eigen::MatrixXd points(3, 200);
    for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] = normal(random);
    points.colwise().normalize();
    return std::vector<std::pair<const char*, std::shared_ptr<const ConvexSet>>>{
        {"ball", std::make_shared<Ball>(V(0, 0, 0), 0.5)},
        {"box", std::make_shared<Box>(V(-0.5, -0.4, -0.3), V(0.5, 0.4, 0.3))},
        {"capsule", std::make_shared<Capsule>(V(-0.5, 0, 0), V(0.5, 0, 0), 0.25)},
        {"cylinder", std::make_shared<Cylinder>(V(0, 0, -0.5), V(0, 0, 0.5), 0.5)},
        {"ellipsoid", std::make_shared<Ellipsoid>(V(0, 0, 0), Eigen::MatrixXd(V(1, 0.5, 0.4).asDiagonal()))},
        {"hull of 200", std::make_shared<PreparedSet>(points)}};
  }();
  return kAll;
}

// Arguments: the body, and whether it is turned. It is 1e-3 above the box, or in it.
struct Scene {
  explicit Scene(const benchmark::State& state, double gap = 1e-3)
      : body(*bodies()[static_cast<std::size_t>(state.range(0))].second) {
    const Eigen::Quaterniond q =
        state.range(1) != 0 ? Eigen::Quaterniond(1, 0.3, 0.2, 0.1) : Eigen::Quaterniond::Identity();
    pose = Pose(q, V(0.1, 0.2, 3));
    ObjectDistanceSolver solver;
    const double away = solver.solve({box}, {body, pose}, metric).distance.distance;
    pose = Pose(q, V(0.1, 0.2, 3 - away + gap));
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.01, V(1, 2, 3).normalized()));
    moved = Pose(turn * q, pose.translation() + 0.002 * V(2, -1, 0.1).normalized());
  }

  const Box box{V(-2, -2, -1), V(2, 2, 0)};
  const Ball metric{V(0, 0, 0), 1.0};
  const ConvexSet& body;
  Pose pose{3}, moved{3};
};

void distance(benchmark::State& state, ObjectEffects more) {
  const Scene scene(state);
  ObjectDistanceSolver solver;
  const ObjectEffects effects = ObjectEffects::depth | ObjectEffects::closest_points | more;
  for (auto _ : state)
    benchmark::DoNotOptimize(&solver.solve({scene.box}, {scene.body, scene.pose}, scene.metric, effects));
  state.SetLabel(bodies()[static_cast<std::size_t>(state.range(0))].first);
}

void growth(benchmark::State& state, bool with_gradient) {
  const Scene scene(state);
  GrowthDistanceSolver solver;
  PoseGradient gradient;
  PoseGradient* const wanted = with_gradient ? &gradient : nullptr;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        &solver.solve_about_centers({scene.box}, {scene.body, scene.pose}, nullptr, wanted));
  state.SetLabel(bodies()[static_cast<std::size_t>(state.range(0))].first);
}

// The same pose after pose, each beginning with what another place left.
void patch(benchmark::State& state, double gap, bool is_warm) {
  const Scene scene(state, gap);
  ContactPatchSolver solver;
  WarmStart warm, kept;
  solver.solve({scene.box}, {scene.body, scene.pose}, 0.01, &kept);
  for (auto _ : state) {
    warm = kept;
    benchmark::DoNotOptimize(
        &solver.solve({scene.box}, {scene.body, scene.moved}, 0.01, is_warm ? &warm : nullptr));
  }
  state.SetLabel(bodies()[static_cast<std::size_t>(state.range(0))].first);
}

void every_body(benchmark::internal::Benchmark* benchmark) {
  for (std::size_t i = 0; i < bodies().size(); ++i)
    for (const int turned : {0, 1}) benchmark->Args({static_cast<std::int64_t>(i), turned});
}

BENCHMARK_CAPTURE(distance, alone, ObjectEffects::none)->Apply(every_body);
BENCHMARK_CAPTURE(distance, with_pose_gradient, ObjectEffects::pose_gradient)->Apply(every_body);
BENCHMARK_CAPTURE(growth, alone, false)->Apply(every_body);
BENCHMARK_CAPTURE(growth, with_pose_gradient, true)->Apply(every_body);
BENCHMARK_CAPTURE(patch, apart, 1e-3, false)->Apply(every_body);
BENCHMARK_CAPTURE(patch, apart_warm, 1e-3, true)->Apply(every_body);
BENCHMARK_CAPTURE(patch, deep, -5e-3, false)->Apply(every_body);
BENCHMARK_CAPTURE(patch, deep_warm, -5e-3, true)->Apply(every_body);

}  // namespace
}  // namespace raygauge::bench
