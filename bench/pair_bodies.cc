// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "bench/pair_bodies.h"

#include <Eigen/Geometry>
#include <random>

#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/prepared_set.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::bench {
namespace {

using Random = std::mt19937_64;
using Body = std::shared_ptr<const ConvexSet>;

Eigen::Vector3d gaussian(Random& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random);
  return {x, y, z};
}

// `thin` shrinks what lies across the x axis.
Eigen::MatrixXd sphere_points(int N, double size, double thin, Random& random) {
  Eigen::MatrixXd points(3, N);
  for (int i = 0; i < N; ++i) points.col(i) = size * gaussian(random).normalized();
  points.bottomRows(2) *= thin;
  return points;
}

Body make_body(const std::string& kind, double size, double thin, Random& random) {
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero(), up(0, 0, 0.6 * size);
  const double across = size * thin;
  if (kind.starts_with("hull")) {
    return std::make_shared<PreparedSet>(sphere_points(std::stoi(kind.substr(4)), size, thin, random));
  }
  if (kind.starts_with("points")) {
    return std::make_shared<PointSet>(sphere_points(std::stoi(kind.substr(6)), size, thin, random));
  }
  if (kind == "box") {
    const Eigen::Vector3d half(0.6 * size, 0.5 * across, 0.4 * across);
    return std::make_shared<Box>(Eigen::Vector3d(-half), half);
  }
  if (kind == "capsule") return std::make_shared<Capsule>(Eigen::Vector3d(-up), up, 0.4 * across);
  if (kind == "cylinder") return std::make_shared<Cylinder>(Eigen::Vector3d(-up), up, 0.5 * across);
  if (kind == "cone" || kind == "pointed") {
    const double top = kind == "cone" ? 0.3 * across : 0.0;
    return std::make_shared<TruncatedCone>(Eigen::Vector3d(-up), 0.6 * across, up, top);
  }
  if (kind == "ellipsoid") {
    const Eigen::Vector3d axes(size, 0.6 * across, 0.4 * across);
    return std::make_shared<Ellipsoid>(zero, Eigen::MatrixXd(axes.asDiagonal()));
  }
  return std::make_shared<Ball>(zero, 0.8 * size);
}

Eigen::Quaterniond random_rotation(Random& random) {
  const Eigen::Vector3d v = gaussian(random);
  return Eigen::Quaterniond(gaussian(random).x(), v.x(), v.y(), v.z()).normalized();
}

// Moves the second body along the normal until the two are `gap` apart.
void bring_near(PosedPair& pair, double gap) {
  const Ball metric(Eigen::Vector3d::Zero(), 1);
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  options.tolerance = 1e-12;
  ObjectDistanceSolver solver(options);
  const auto& r = solver.solve({*pair.first, pair.pose_1}, {*pair.second, pair.pose_2}, metric);
  if (r.distance.normal.size() != 3) return;
  const Eigen::Vector3d t = pair.pose_2.translation() + (r.distance.upper - gap) * r.distance.normal;
  pair.pose_2 = Pose(pair.pose_2.rotation(), t);
}

}  // namespace

std::vector<std::string> body_kinds() {
  return {"points8", "points200", "points2000", "hull8",   "hull200",   "hull2000", "box",
          "capsule", "cylinder",  "cone",       "pointed", "ellipsoid", "ball"};
}

std::vector<std::string> pair_places() {
  return {"apart", "overlap",  "concentric", "touching", "1e-9",
          "1e-4",  "parallel", "needles",    "large",    "small"};
}

bool is_polytope(const std::string& kind) {
  return kind == "box" || kind.starts_with("hull") || kind.starts_with("points");
}

PosedPair make_pair(const std::string& one, const std::string& two, const std::string& place, int seed) {
  Random random(static_cast<std::uint64_t>(seed) + 1);
  PosedPair pair;
  pair.size = place == "large" ? 1e6 : place == "small" ? 1e-6 : 1.0;
  const double thin = place == "needles" ? 1e-6 : 1.0;
  pair.first = make_body(one, pair.size, thin, random);
  pair.second = make_body(two, pair.size, thin, random);
  const bool straight = place == "parallel";
  const Eigen::Quaterniond q_1 = straight ? Eigen::Quaterniond::Identity() : random_rotation(random);
  const Eigen::Quaterniond q_2 = straight ? Eigen::Quaterniond::Identity() : random_rotation(random);
  const Eigen::Vector3d t_1 = pair.size * gaussian(random);
  const double way = place == "overlap" ? 0.3 : place == "concentric" ? 0.0 : 3.0;
  const Eigen::Vector3d direction = straight ? Eigen::Vector3d::UnitX() : gaussian(random).normalized();
  pair.pose_1 = Pose(q_1, t_1);
  pair.pose_2 = Pose(q_2, t_1 + pair.size * way * direction);
  if (place == "touching") bring_near(pair, 0);
  if (place == "1e-9") bring_near(pair, 1e-9);
  if (place == "1e-4") bring_near(pair, 1e-4);
  if (place == "slight") bring_near(pair, -0.01);
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.01, gaussian(random).normalized()));
  pair.moved_2 = Pose(turn.toRotationMatrix() * pair.pose_2.rotation(),
                      pair.pose_2.translation() + 0.002 * pair.size * gaussian(random).normalized());
  return pair;
}

}  // namespace raygauge::bench
