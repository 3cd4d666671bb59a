// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "raygauge/queries/gradient.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/half_space.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/p_norm_ball.h"
#include "raygauge/sets/polytopes.h"
#include "tests/engine/queries/depth_cases.h"

namespace raygauge::test_pose_gradient {
namespace {

using V = Eigen::Vector3d;
using Twist6 = Eigen::Matrix<double, 6, 1>;
constexpr auto kWanted = ObjectEffects::depth | ObjectEffects::pose_gradient;
constexpr double kRounding = 1e-9;

Ball euclidean(int n) { return {Vector::Zero(n), 1.0}; }

DistanceOptions options(double tolerance, DistanceMethod method = DistanceMethod::automatic) {
  DistanceOptions result;
  result.tolerance = tolerance;
  result.method = method;
  return result;
}

Twist twist_of(const Twist6& v) { return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}}; }
Twist6 numbers(const Twist& t) {
  Twist6 v;
  v << t.linear.x, t.linear.y, t.linear.z, t.angular.x, t.angular.y, t.angular.z;
  return v;
}

// The body after a time h of the twist.
Pose moved(const Pose& pose, const Twist6& twist, double h) {
  const V omega = h * twist.tail<3>();
  const double angle = omega.norm();
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  if (angle > 0) R = Eigen::AngleAxisd(angle, omega / angle).toRotationMatrix();
  return {Eigen::MatrixXd(R * pose.rotation()), pose.translation() + h * twist.head<3>()};
}

using Value = std::function<double(const Pose&, const Pose&)>;

// The relative error against central differences, of both gradients together.
double error_of(const PoseGradient& gradient, const Value& value, const Pose& first, const Pose& second) {
  constexpr double kStep = 1e-5;
  double off = 0, size = 0;
  for (int k = 0; k < 12; ++k) {
    const Twist6 e = Twist6::Unit(k % 6);
    const auto at = [&](double h) {
      return k < 6 ? value(moved(first, e, h), second) : value(first, moved(second, e, h));
    };
    const double slope = (at(kStep) - at(-kStep)) / (2 * kStep);
    const double found = numbers(k < 6 ? gradient.body_1 : gradient.body_2)[k % 6];
    off = std::max(off, std::fabs(slope - found));
    size = std::max(size, std::fabs(slope));
  }
  return off / size;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

// Every pair of kinds: the median error is below 1e-6, and nearly all are.
void expect_errors(const std::vector<double>& errors, std::size_t least) {
  ASSERT_GE(errors.size(), least);
  EXPECT_LT(median(errors), 1e-6);
  EXPECT_LT(std::count_if(errors.begin(), errors.end(), [](double e) { return !(e < 1e-4); }),
            static_cast<std::ptrdiff_t>(errors.size() / 20 + 1));
}

void check_distances(double away, double tolerance, bool overlapping) {
  Random random(41);
  ObjectDistanceSolver solver(options(tolerance));
  const Ball Q = euclidean(3);
  std::vector<double> errors;
  for (const auto& [name_1, A1] : depth_bodies()) {
    for (const auto& [name_2, A2] : depth_bodies()) {
      const Pose p1 = random_pose(random, 0.5), p2 = random_pose(random, away);
      const ObjectDistance r = solver.solve({*A1, p1}, {*A2, p2}, Q, kWanted);
      if ((r.depth.evaluations > 0) != overlapping) continue;
      EXPECT_EQ(r.pose_gradient.kind, GradientKind::unique) << name_1 << ' ' << name_2;
      const auto value = [&, &first = *A1, &second = *A2](const Pose& a, const Pose& b) {
        return solver.solve({first, a}, {second, b}, Q, ObjectEffects::depth).signed_distance();
      };
      errors.push_back(error_of(r.pose_gradient, value, p1, p2));
      EXPECT_LT(errors.back(), 1e-2) << name_1 << ' ' << name_2;
    }
  }
  expect_errors(errors, 60);
}

TEST(PoseGradient, OfDistancesIsThatOfCentralDifferences) { check_distances(3, 1e-12, false); }

TEST(PoseGradient, OfDepthsIsThatOfCentralDifferences) { check_distances(0.4, 1e-10, true); }

// Apart and overlapping, the floor first and second; after a depth of two other bodies.
TEST(PoseGradient, OfHalfSpacesIsThatOfCentralDifferences) {
  Random random(47);
  ObjectDistanceSolver solver(options(1e-12));
  const Ball Q = euclidean(3);
  const HalfSpace floor(V(0.3, -0.2, 1), 0.1);
  std::vector<double> errors;
  for (const auto& [name, body] : depth_bodies()) {
    for (int i = 0; i < 4; ++i) {
      const ConvexSet &first = i < 2 ? static_cast<const ConvexSet&>(floor) : *body,
                      &second = i < 2 ? *body : static_cast<const ConvexSet&>(floor);
      const Pose p1 = random_pose(random, i % 2 == 0 ? 0.2 : 3.0), p2 = random_pose(random, 0.1);
      solver.solve({*body, p1}, {*body, p2}, Q, kWanted);
      const ObjectDistance r = solver.solve({first, p1}, {second, p2}, Q, kWanted);
      EXPECT_EQ(r.pose_gradient.kind, GradientKind::unique) << name;
      const auto value = [&](const Pose& a, const Pose& b) {
        return solver.solve({first, a}, {second, b}, Q, ObjectEffects::depth).signed_distance();
      };
      errors.push_back(error_of(r.pose_gradient, value, p1, p2));
      EXPECT_LT(errors.back(), 1e-6) << name;
    }
  }
  expect_errors(errors, 40);
}

TEST(PoseGradient, OfAFaceOnAHalfSpaceIsOneSided) {
  ObjectDistanceSolver solver(options(1e-12));
  const HalfSpace floor(V(0, 0, 1), 0);
  for (const double height : {-0.25, 0.5}) {
    const Box box(V(-1, -1, height), V(1, 1, 3));
    const PoseGradient& g = solver.solve(box, floor, euclidean(3), kWanted).pose_gradient;
    EXPECT_EQ(g.kind, GradientKind::one_sided);
    EXPECT_LT((numbers(g.body_1).head<3>() - V(0, 0, 1)).norm(), kRounding);
    EXPECT_EQ(g.candidates.size(), 4U);
    EXPECT_NEAR(g.along({{}, {1, 0, 0}}, {}), -1, kRounding);  // ω y, least at y = -1
    EXPECT_NEAR(g.along({{}, {0, -1, 0}}, {}), -1, kRounding);
    EXPECT_NEAR(g.along({}, {{}, {1, 0, 0}}), -1, kRounding);  // the floor turns
    EXPECT_NEAR(g.along({{0, 0, -2}, {}}, {}), -2, kRounding);
  }
}

void check_growth_distances(DistanceMethod method) {
  Random random(43);
  GrowthDistanceSolver solver(options(1e-12, method));
  for (const bool about_origin : {false, true}) {
    std::vector<double> errors;
    for (const auto& [name_1, A1] : depth_bodies()) {
      for (const auto& [name_2, A2] : depth_bodies()) {
        const Pose p1 = random_pose(random, 0.05), p2 = random_pose(random, 2);
        PoseGradient gradient, unused;
        const auto solve = [&, &first = *A1, &second = *A2](const Pose& a, const Pose& b,
                                                            PoseGradient* wanted) {
          if (about_origin) return solver.solve({second, b}, {first, a}, nullptr, wanted).distance;
          return solver.solve_about_centers({first, a}, {second, b}, nullptr, wanted).distance;
        };
        solve(p1, p2, &gradient);
        EXPECT_EQ(gradient.kind, GradientKind::unique) << name_1 << ' ' << name_2;
        const auto value = [&](const Pose& a, const Pose& b) { return solve(a, b, nullptr); };
        errors.push_back(error_of(gradient, value, p1, p2));
        EXPECT_LT(errors.back(), 1e-2) << name_1 << ' ' << name_2 << about_origin;
      }
    }
    expect_errors(errors, 100);
  }
}

TEST(PoseGradient, OfGrowthDistancesIsThatOfCentralDifferences) {
  check_growth_distances(DistanceMethod::automatic);
}

// Of a normal that is known to the root of the gap, vertices that only seem to be the highest are not taken
// for the contact.
TEST(PoseGradient, OfGrowthDistancesAtACoarseToleranceIsNearlyThatOfCentralDifferences) {
  constexpr double kNearly = 0.05;
  Random random(44);
  GrowthDistanceSolver coarse(options(1e-6)), fine(options(1e-12));
  int known = 0;
  for (const auto& [name_1, A1] : depth_bodies()) {
    for (const auto& [name_2, A2] : depth_bodies()) {
      for (int i = 0; i < 4; ++i) {
        const Pose p1 = random_pose(random, 0.05), p2 = random_pose(random, 2);
        PoseGradient gradient;
        coarse.solve_about_centers({*A1, p1}, {*A2, p2}, nullptr, &gradient);
        EXPECT_NE(gradient.kind, GradientKind::none) << name_1 << ' ' << name_2;
        if (gradient.kind != GradientKind::unique) continue;
        const auto value = [&, &first = *A1, &second = *A2](const Pose& a, const Pose& b) {
          return fine.solve_about_centers({first, a}, {second, b}).distance;
        };
        ++known;
        EXPECT_LT(error_of(gradient, value, p1, p2), kNearly) << name_1 << ' ' << name_2;
      }
    }
  }
  EXPECT_GE(known, 398);
}

TEST(PoseGradient, OfGrowthDistancesByNewtonIsThatOfCentralDifferences) {
  check_growth_distances(DistanceMethod::newton);
}

TEST(PoseGradient, OfBallsIsAlongTheLineOfCentres) {
  ObjectDistanceSolver solver(options(1e-12));
  const Ball A(V(1, 0, 0), 1.0), B(V(0, 0, 0), 0.5);
  const Pose at(Eigen::MatrixXd(Eigen::Matrix3d::Identity()), V(5, 0, 3));
  const ObjectDistance& r = solver.solve(A, {B, at}, euclidean(3), kWanted);
  const V u = V(4, 0, 3) / 5;
  EXPECT_EQ(r.pose_gradient.kind, GradientKind::unique);
  Twist6 first, second;
  first << -u, (V(1, 0, 0) + u).cross(-u);  // about the origin of the world
  second << u, V::Zero();                   // a ball that turns about its centre
  EXPECT_LT((numbers(r.pose_gradient.body_1) - first).norm(), kRounding);
  EXPECT_LT((numbers(r.pose_gradient.body_2) - second).norm(), kRounding);
}

// A small plate above the edge of a large one: what both have in common is 9 <= x <= 10, and the small one
// turns about x = 10.5.
TEST(PoseGradient, OfParallelFacesIsOneSided) {
  ObjectDistanceSolver solver(options(1e-12));
  const Box large(V(0, 0, -1), V(10, 10, 0)), small(V(-1.5, -1, 0), V(1.5, 1, 1));
  const Pose at(Eigen::MatrixXd(Eigen::Matrix3d::Identity()), V(10.5, 5, 0.25));
  const PoseGradient g = solver.solve(large, {small, at}, euclidean(3), kWanted).pose_gradient;
  EXPECT_EQ(g.kind, GradientKind::one_sided);
  const Twist still;
  EXPECT_NEAR(g.along(still, {{0, 0, 1}, {}}), 1, kRounding);
  EXPECT_NEAR(g.along(still, {{}, {0, 1, 0}}), 0.5, kRounding);    // -ω (x - 10.5), least at x = 10
  EXPECT_NEAR(g.along(still, {{}, {0, -1, 0}}), -1.5, kRounding);  // ... and at x = 9
  EXPECT_NEAR(g.along(still, {{}, {1, 0, 0}}), -1, kRounding);     // ω (y - 5)
  const double h = 1e-6;
  for (const Twist6& twist : {Twist6(Twist6::Unit(3)), Twist6(-Twist6::Unit(4)), Twist6(Twist6::Unit(4))}) {
    const double d = solver.solve(large, {small, moved(at, twist, h)}, euclidean(3)).distance.distance;
    EXPECT_NEAR((d - 0.25) / h, g.along(still, twist_of(twist)), 1e-5);
  }
}

// The top edge of a cube that stands on an edge, along y, below an edge of another one along x or along y.
TEST(PoseGradient, OfEdgesIsUniqueWhereTheyCross) {
  const Box cube(V(-1, -1, -1), V(1, 1, 1));
  const double eighth = std::atan(1.0);
  const Eigen::Quaterniond on_edge_y(Eigen::AngleAxisd(eighth, V::UnitY())),
      on_edge_x(Eigen::AngleAxisd(eighth, V::UnitX()));
  const Pose below(on_edge_y, V(0, 0, 0));
  ObjectDistanceSolver solver;
  for (const double height : {3.0, 2.5}) {  // apart by 3 - 2√2, and deep
    const auto kind = [&](const Eigen::Quaterniond& q, double x, double y) {
      const Pose above(q, V(x, y, height));
      return solver.solve({cube, below}, {cube, above}, euclidean(3), kWanted).pose_gradient.kind;
    };
    EXPECT_EQ(kind(on_edge_x, 0.3, 0.2), GradientKind::unique);
    EXPECT_EQ(kind(on_edge_y, 0, 0.2), GradientKind::one_sided);  // parallel
    EXPECT_EQ(kind(on_edge_y, 0, 0), GradientKind::one_sided);
  }
}

TEST(PoseGradient, OfSeveralNearestFacetsIsTheGreatestOfThem) {
  ObjectDistanceSolver solver(options(1e-10));
  const Box A(V(-1, -1, -1), V(1, 1, 1)), B(V(-2, -2, -2), V(2, 2, 2));
  const PoseGradient g = solver.solve(A, B, euclidean(3), kWanted).pose_gradient;
  ASSERT_EQ(g.kind, GradientKind::one_sided);
  Random random(44);
  for (int i = 0; i < 20; ++i) {
    const V v = sphere_points(3, 1, random);
    EXPECT_NEAR(g.along({{v[0], v[1], v[2]}, {}}, {}), v.cwiseAbs().maxCoeff(), kRounding);
  }
}

TEST(PoseGradient, InThePlaneHasThreeComponents) {
  using V2 = Eigen::Vector2d;
  ObjectDistanceSolver solver(options(1e-12));
  const Box box(V2(0, 0), V2(2, 2));
  const Ball ball(V2(3, 1.5), 0.5);
  const ObjectDistance& r = solver.solve(box, ball, euclidean(2), kWanted);
  EXPECT_EQ(r.pose_gradient.kind, GradientKind::unique);
  Twist6 first;
  first << -1, 0, 0, 0, 0, 1.5;  // (2, 1.5) × (-1, 0)
  EXPECT_LT((numbers(r.pose_gradient.body_1) - first).norm(), kRounding);
  const Box beside(V2(3, 1), V2(4, 5));
  const PoseGradient& g = solver.solve(box, beside, euclidean(2), kWanted).pose_gradient;
  EXPECT_EQ(g.kind, GradientKind::one_sided);
  EXPECT_NEAR(g.along({{}, {0, 0, 1}}, {}), 1, kRounding);  // ω y, least at y = 1
  EXPECT_NEAR(g.along({{}, {0, 0, -1}}, {}), -2, kRounding);
}

// Sets without a closed form, by their support mappings.
TEST(PoseGradient, OfOtherSetsKnowsParallelFacesToo) {
  ObjectDistanceSolver solver(options(1e-10));
  Eigen::MatrixXd normals(6, 3);
  normals << Eigen::Matrix3d::Identity(), -Eigen::Matrix3d::Identity();
  const HPolytope cube(normals, Vector::Ones(6));
  const Box above(V(-0.5, -0.5, 2), V(0.5, 0.5, 3)), corner(V(2, 3, 4), V(5, 5, 5));
  const PoseGradient flat = solver.solve(cube, above, euclidean(3), kWanted).pose_gradient;
  EXPECT_EQ(flat.kind, GradientKind::one_sided);
  EXPECT_NEAR(flat.along({{}, {1, 0, 0}}, {}), -0.5, kRounding);
  EXPECT_EQ(solver.solve(cube, corner, euclidean(3), kWanted).pose_gradient.kind, GradientKind::unique);
}

TEST(PoseGradient, InAnotherMetricIsNotKnownToBeUnique) {
  ObjectDistanceSolver solver(options(1e-10));
  const PNormBall Q(Vector::Zero(3), Vector::Ones(3), 1.0);
  const ObjectDistance& r = solver.solve(Ball(V(0, 0, 0), 1.0), Ball(V(5, 1, 0), 1.0), Q, kWanted);
  EXPECT_EQ(r.pose_gradient.kind, GradientKind::undecided);
  EXPECT_TRUE(std::isnan(r.pose_gradient.along({}, {})));
}

// By a solver that has answered about other bodies, with a warm start that makes it ask for the depth first.
TEST(PoseGradient, AfterOtherBodiesIsThatOfANewSolver) {
  Random random(48);
  int undecided = 0;  // where a minimum is nearly flat, facets beside the normal may be as near
  ObjectDistanceSolver used(options(1e-10));
  const Ball Q = euclidean(3);
  for (const auto& [name_1, A1] : depth_bodies()) {
    for (const auto& [name_2, A2] : depth_bodies()) {
      const Pose p1 = random_pose(random, 0), near = random_pose(random, 0.3), far = random_pose(random, 3);
      WarmStart warm;
      used.solve({*A1, p1}, {*A2, near}, Q, kWanted, &warm);
      used.solve({*A2, p1}, {*A1, far}, Q, kWanted);
      const PoseGradient g = used.solve({*A1, p1}, {*A2, near}, Q, kWanted, &warm).pose_gradient;
      ObjectDistanceSolver fresh(options(1e-10));
      const PoseGradient& other = fresh.solve({*A1, p1}, {*A2, near}, Q, kWanted).pose_gradient;
      undecided += g.kind == GradientKind::undecided ? 1 : 0;
      if (g.kind != GradientKind::undecided) {
        EXPECT_EQ(g.kind, other.kind) << name_1 << ' ' << name_2;
      }
      EXPECT_LT((numbers(g.body_2) - numbers(other.body_2)).norm(), 1e-4) << name_1 << ' ' << name_2;
    }
  }
  EXPECT_LE(undecided, 1);
}

TEST(PoseGradient, ThatIsNotAskedForIsNotComputed) {
  ObjectDistanceSolver solver(options(1e-6));
  const Ball A(V(0, 0, 0), 1.0), B(V(5, 1, 0), 1.0);
  EXPECT_EQ(solver.solve(A, B, euclidean(3), kWanted).pose_gradient_evaluations, 1);
  const ObjectDistance& r = solver.solve(A, B, euclidean(3), ObjectEffects::gradient);
  EXPECT_EQ(r.pose_gradient_evaluations, 0);
  EXPECT_EQ(r.pose_gradient.kind, GradientKind::none);
}

}  // namespace
}  // namespace raygauge::test_pose_gradient
