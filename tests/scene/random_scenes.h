// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <mutex>
#include <random>
#include <string>
#include <vector>

#include "engine/sets/posed_view.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/scene/scene_run.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::random_scenes {

using SetPointer = std::shared_ptr<const ConvexSet>;
using Random = std::mt19937_64;

inline double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

inline SmallVector uniform_vector(Random& random, int n, double size) {
  SmallVector v(n);
  for (int k = 0; k < n; ++k) v[k] = uniform(random, -size, size);
  return v;
}

inline constexpr int kShapes = 6;

/// A set of one of kShapes kinds, of a size near 1, about the origin; in the plane those that there are.
inline SetPointer shape(Random& random, int n, int kind) {
  const Vector zero = Vector::Zero(n);
  const auto size = [&random] { return uniform(random, 0.2, 0.8); };
  Vector half(n);
  for (int k = 0; k < n; ++k) half[k] = size();
  if (kind == 0) return std::make_shared<Ball>(zero, size());
  if (kind == 1) return std::make_shared<Box>(-half, half);
  if (kind == 2) {
    Eigen::MatrixXd points(n, 12);
    for (Eigen::Index i = 0; i < points.cols(); ++i) points.col(i) = uniform_vector(random, n, 0.7);
    return std::make_shared<PointSet>(points);
  }
  Vector end = zero;
  end[0] = size();
  if (kind == 3) return std::make_shared<Capsule>(-end, end, 0.3 * size());
  if (kind == 4 && n == 3) return std::make_shared<Cylinder>(-end, end, size());
  return std::make_shared<Ellipsoid>(zero, Eigen::MatrixXd(half.asDiagonal()));
}

inline Placement placement(Random& random, int n, double size) {
  Placement where = Placement::identity(n);
  where.t = uniform_vector(random, n, size);
  if (n == 3) where.R = rotation_about(uniform_vector(random, 3, 3.0));
  if (n == 2) where.R = plane_rotation(uniform(random, -3.1, 3.1));
  return where;
}

/// Standing, along keyframes, or falling and spinning, over [0, 1].
inline MotionPointer motion(Random& random, int n, double size) {
  switch (random() % 4) {
    case 0:
      return std::make_shared<StaticMotion>(placement(random, n, size));
    case 1: {
      TwistMotion::Rates rates;
      rates.velocity = uniform_vector(random, n, 2 * size);
      rates.acceleration = uniform_vector(random, n, size);
      if (n == 3) rates.spin = uniform_vector(random, 3, 6.0);
      if (n == 2) rates.spin = {0, 0, uniform(random, -6, 6)};
      return std::make_shared<TwistMotion>(placement(random, n, size), rates, 0.0);
    }
    default: {
      std::vector<double> times = {0, uniform(random, 0.2, 0.8), 1};
      std::vector<Placement> frames;
      for (std::size_t i = 0; i < times.size(); ++i) frames.push_back(placement(random, n, size));
      return std::make_shared<KeyframeMotion>(times, frames);
    }
  }
}

/// Bodies of one or two parts in [-size, size]^n, looked at at `instants` moments of [0, 1].
inline Scene scene(Random& random, int n, int bodies, int instants, double size) {
  Scene scene;
  for (int i = 0; i < bodies; ++i) {
    std::vector<SetPointer> parts = {shape(random, n, static_cast<int>(random() % kShapes))};
    if (random() % 3 == 0) {
      Eigen::MatrixXd points(n, 5);
      for (Eigen::Index j = 0; j < 5; ++j) points.col(j) = uniform_vector(random, n, 0.4);
      points.row(0).array() += 0.8;
      parts.push_back(std::make_shared<PointSet>(points));
    }
    scene.bodies.push_back(make_body("body " + std::to_string(i), parts, motion(random, n, size)));
  }
  for (int k = 0; k < instants; ++k) scene.instants.push_back(k / static_cast<double>(instants - 1));
  return scene;
}

/// A query about all pairs of a scene.
inline SceneQuery all_pairs(const Scene& scene, SceneEffects effects) {
  SceneQuery query;
  query.name = "all";
  query.effects = effects;
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) query.group_1.push_back(i);
  query.group_2 = query.group_1;
  return query;
}

/// Keeps what it is given, by cell.
class Collector final : public SceneSink {
 public:
  void store(const SceneCellResult& cell) override {
    const std::lock_guard lock(mutex_);
    cells.push_back(cell);
  }

  /// In the order of cells.
  SceneCellResult all() const {
    std::vector<SceneCellResult> sorted = cells;
    std::sort(sorted.begin(), sorted.end(), [](const auto& x, const auto& y) { return x.cell < y.cell; });
    SceneCellResult sum;
    for (const SceneCellResult& cell : sorted) {
      sum.records.insert(sum.records.end(), cell.records.begin(), cell.records.end());
      sum.tallies.resize(cell.tallies.size());
      for (std::size_t q = 0; q < cell.tallies.size(); ++q) sum.tallies[q] += cell.tallies[q];
      sum.counters += cell.counters;
    }
    return sum;
  }

  std::vector<SceneCellResult> cells;

 private:
  std::mutex mutex_;
};

inline SceneCellResult run(const Scene& scene, int threads = 1) {
  Collector collector;
  run_scene(scene, plan_scene(scene), threads, {}, collector);
  return collector.all();
}

/// What is compared with: one cold solve of every pair of parts by an independent way through the public
/// solvers, without balls, planes or memory.
struct BruteForce {
  double lower = 0, upper = 0;
  bool intersecting = false;
};

inline BruteForce brute_force(const Body& a, const Body& b, double t, const SetPointer& Q = nullptr,
                              double tolerance = 1e-9) {
  DistanceOptions options;
  options.tolerance = tolerance;
  options.method = DistanceMethod::newton;
  ObjectDistanceSolver solver(options);
  const int n = a.dimension();
  const Ball ball(Vector::Zero(n), 1.0);
  const Placement at_a = a.motion->at(t);
  const Placement at_b = b.motion->at(t);
  BruteForce least{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), false};
  const Pose pose_a(at_a.R, at_a.t), pose_b(at_b.R, at_b.t);
  for (const BodyPart& part_a : a.parts) {
    for (const BodyPart& part_b : b.parts) {
      const PosedView set_a(*part_a.set, pose_a), set_b(*part_b.set, pose_b);
      const DistanceResult& found = solver.solve(set_a, set_b, Q ? *Q : ball).distance;
      least.lower = std::min(least.lower, found.lower);
      least.upper = std::min(least.upper, found.upper);
      least.intersecting |= found.status == DistanceStatus::contains_origin;
    }
  }
  return least;
}

}  // namespace raygauge::random_scenes
