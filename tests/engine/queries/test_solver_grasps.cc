// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Grasps in the space of wrenches: Q is the hull of what contacts with friction can exert. Symmetric grasps
// put the task on a low face of Q, where weights of the optimal basis are zero and no enclosure proves them
// nonnegative.
#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <vector>

#include "raygauge/queries/solver.h"
#include "raygauge/sets/grasp_wrenches.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/point_set.h"

namespace raygauge::test_solver_grasps {
namespace {

constexpr double kFriction = 0.5;

/// Contacts at the points, normals towards the origin.
UnionHull grasp(const std::vector<Eigen::Vector3d>& points, int facets) {
  std::vector<std::shared_ptr<const ConvexSet>> contacts;
  for (const Eigen::Vector3d& p : points) {
    contacts.push_back(
        std::make_shared<ContactWrenches>(Vector(p), Vector(-p), kFriction, static_cast<double>(facets)));
  }
  return UnionHull(std::move(contacts));
}

std::vector<Eigen::Vector3d> tetrahedron() {
  const double c = 0.57735026919;
  return {{c, c, c}, {c, -c, -c}, {-c, c, -c}, {-c, -c, c}};
}

std::vector<Eigen::Vector3d> octahedron() {
  return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
}

/// Upwards, with a torque about the vertical.
PointSet task() {
  Vector wrench(6);
  wrench << 0, 0, 1, 0, 0, 0.2;
  return PointSet(wrench);
}

class Grasps : public ::testing::TestWithParam<DistanceMethod> {
 protected:
  static DistanceResult solve(const ConvexSet& A, const ConvexSet& Q, double tolerance) {
    DistanceOptions options;
    options.method = GetParam();
    options.tolerance = tolerance;
    return DistanceSolver(options).solve(A, Q);
  }
};

TEST_P(Grasps, OfSymmetricContactsAreCertified) {
  for (const auto& points : {tetrahedron(), octahedron()}) {
    for (const int facets : {0, 4, 8, 16}) {
      for (const double tolerance : {1e-6, 1e-9}) {
        const DistanceResult result = solve(task(), grasp(points, facets), tolerance);
        EXPECT_EQ(result.status, DistanceStatus::optimal)
            << points.size() << " contacts, " << facets << " facets";
        EXPECT_LE(result.upper - result.lower, tolerance * result.upper);
      }
    }
  }
}

// Regular polygons of 4, 8 and 16 corners lie within each other and within the disc.
TEST_P(Grasps, ResistMoreWithMoreFacets) {
  for (const auto& points : {tetrahedron(), octahedron()}) {
    double upper_before = std::numeric_limits<double>::infinity();
    for (const int facets : {4, 8, 16, 0}) {
      const DistanceResult result = solve(task(), grasp(points, facets), 1e-6);
      EXPECT_LT(result.lower, upper_before);
      upper_before = result.upper;
    }
  }
}

TEST_P(Grasps, OfRandomContactsAreCertifiedOrBeyondReach) {
  std::mt19937_64 engine(20);
  std::normal_distribution<double> normal;
  std::uniform_int_distribution<int> count(2, 7);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Eigen::Vector3d> points(static_cast<std::size_t>(count(engine)));
    for (Eigen::Vector3d& p : points)
      p = Eigen::Vector3d(normal(engine), normal(engine), normal(engine)).normalized();
    Vector wrench(6);
    for (int k = 0; k < 6; ++k) wrench[k] = normal(engine);
    for (const int facets : {0, 3, 8, 16}) {
      const DistanceResult result = solve(PointSet(wrench), grasp(points, facets), 1e-6);
      // Every wrench set holds 0, so that h_Q(-u) is 0 at best and known to a rounding error: what no forces
      // resist is proven to need this many times as much.
      const bool beyond_reach = result.lower > 1e12;
      EXPECT_TRUE(result.status == DistanceStatus::optimal || beyond_reach)
          << to_string(result.status) << ", trial " << trial << ", " << points.size() << " contacts, "
          << facets << " facets, [" << result.lower << ", " << result.upper << "]";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Grasps,
                         ::testing::Values(DistanceMethod::column_generation, DistanceMethod::zheng_yamane),
                         [](const auto& instance) { return std::string(to_string(instance.param)); });

}  // namespace
}  // namespace raygauge::test_solver_grasps
