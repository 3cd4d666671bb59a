// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Ferrari & Canny's grasp quality: the depth of the origin among the wrenches of the contacts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "raygauge/exceptions.h"
#include "raygauge/queries/membership.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/grasp_wrenches.h"
#include "raygauge/sets/operations.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_grasp_quality {
namespace {

using Eigen::Vector3d;
using Contacts = std::vector<GraspContact>;

constexpr double kFriction = 0.5;
constexpr double kRounding = 1e-12;

DistanceOptions options(double tolerance) {
  DistanceOptions result;
  result.tolerance = tolerance;
  return result;
}

const Ball& euclidean() {
  static const Ball kBall(Vector::Zero(6), 1.0);
  return kBall;
}

Contacts octahedron() {
  Contacts contacts;
  for (int i = 0; i < 6; ++i) {
    const Vector3d p = (i % 2 == 0 ? 1 : -1) * Vector3d::Unit(i / 2);
    contacts.push_back({p, -p, kFriction});
  }
  return contacts;
}

/// On the unit sphere, normals inwards but for a random tilt.
Contacts random_grasp(int count, Random& random) {
  const Eigen::MatrixXd points = sphere_points(3, count, random), tilts = gaussian_points(3, count, random);
  std::uniform_real_distribution<double> friction(0.1, 1);
  Contacts contacts;
  for (int i = 0; i < count; ++i) {
    const Vector3d p = points.col(i);
    contacts.push_back({p, Vector3d(-p + 0.3 * tilts.col(i)).normalized(), friction(random)});
  }
  return contacts;
}

using SetPointer = std::shared_ptr<const ConvexSet>;

std::vector<SetPointer> cones_of(const Contacts& contacts, int edges) {
  std::vector<SetPointer> cones;
  for (const GraspContact& c : contacts)
    cones.push_back(std::make_shared<ContactWrenches>(Vector(c.point), Vector(c.normal), c.friction, edges));
  return cones;
}

SetPointer sum_of(const std::vector<SetPointer>& sets) {
  SetPointer sum = sets.front();
  for (std::size_t i = 1; i < sets.size(); ++i) sum = std::make_shared<MinkowskiSum>(sum, sets[i]);
  return sum;
}

/// h of exact cones at forces of sum 1, by the formula, and a maximiser.
double formula(const Contacts& contacts, const Vector& u, Vector& point) {
  double best = -1e300;
  for (const GraspContact& c : contacts) {
    const Vector3d w = u.head<3>() + Vector3d(u.tail<3>()).cross(c.point);
    const double along = w.dot(c.normal);
    const Vector3d across = w - along * c.normal;
    const double height = along + c.friction * across.norm();
    if (height < best) continue;
    best = height;
    const Vector3d f = c.normal + c.friction * across.stableNormalized();
    point << f, c.point.cross(f);
  }
  return best;
}

/// Steps down from u on the sphere: an upper bound of the depth that knows nothing of polytopes.
double descend(const Contacts& contacts, Vector u) {
  Vector point(6);
  u.normalize();
  double best = formula(contacts, u, point);
  double step = 0.3;
  for (int i = 0; i < 60; ++i) {
    const Vector next = (u - step * (point - point.dot(u) * u).normalized()).normalized();
    Vector there(6);
    const double height = formula(contacts, next, there);
    best = std::min(best, height);
    if (height < formula(contacts, u, point)) {
      u = next;
      point = there;
    } else {
      step *= 0.7;
    }
  }
  return best;
}

// With a pure torque τ the contacts at ±e_k reach μ |τ - τ_k e_k|, whose largest is least for equal τ_k.
TEST(GraspQuality, OfSixContactsOnAxesHasAClosedForm) {
  DepthSolver solver(options(1e-4));
  const ObjectDepth& exact = solver.solve(GraspWrenches(octahedron()), euclidean());
  const double truth = kFriction * std::sqrt(2.0 / 3);
  EXPECT_EQ(exact.status, DistanceStatus::optimal);
  EXPECT_LE(exact.lower, truth + kRounding);
  EXPECT_GE(exact.upper, truth - kRounding);
  EXPECT_LE(exact.upper - exact.lower, 1e-4 * exact.upper);
}

TEST(GraspQuality, OfPyramidsIsProvenFarBelowTheirDifference) {
  DepthSolver solver(options(1e-6));
  double before = 0;
  for (const int edges : {4, 8, 16}) {
    const ObjectDepth& depth =
        solver.solve(GraspWrenches(octahedron(), GraspForces::sum, edges), euclidean());
    EXPECT_EQ(depth.status, DistanceStatus::optimal);
    EXPECT_GE(depth.upper, before);  // edges of the next include these
    before = depth.lower;
  }
  EXPECT_LE(before, kFriction * std::sqrt(2.0 / 3) + kRounding);
}

TEST(GraspQuality, OfAThousandRandomGraspsIsNeverFalse) {
  Random random(1);
  DepthSolver solver(options(1e-3));
  Vector point(6);
  int closures = 0;
  for (int i = 0; i < 1000; ++i) {
    const Contacts contacts = random_grasp(3 + i % 6, random);
    const ObjectDepth& depth = solver.solve(GraspWrenches(contacts), euclidean());
    double least = depth.normal.size() > 0 ? formula(contacts, depth.normal, point) : 0.0;
    if (!(depth.lower > 0)) {
      // Two contacts exert no torque about the line through them: 0 is often on the boundary.
      ASSERT_LE(least, kRounding) << "grasp " << i;
      ASSERT_LE(depth.upper, kRounding) << "grasp " << i;
      continue;
    }
    ASSERT_EQ(depth.status, DistanceStatus::optimal) << "grasp " << i;
    ASSERT_LE(depth.upper - depth.lower, 1e-3 * depth.upper);
    ++closures;
    ASSERT_NEAR(depth.normal.norm(), 1, kRounding);
    ASSERT_LE(least, depth.upper * (1 + kRounding));
    least = std::min(least, descend(contacts, depth.normal));
    for (int start = 0; start < 20; ++start)
      least = std::min(least, descend(contacts, gaussian_points(6, 1, random)));
    ASSERT_LE(depth.lower, least * (1 + kRounding)) << "grasp " << i;
  }
  EXPECT_GT(closures, 400);
}

// The ball of the lower bound is in the set: asked of the gauge, which uses other methods.
TEST(GraspQuality, IsARadiusWhoseBallTheGaugeFindsInside) {
  Random random(2);
  DepthSolver solver(options(1e-6));
  for (int i = 0; i < 12; ++i) {
    const Contacts contacts = random_grasp(6 + i % 3, random);
    const GraspWrenches W(contacts, GraspForces::sum, i % 2 == 0 ? 0 : 6);
    const ObjectDepth& depth = solver.solve(W, euclidean());
    ASSERT_EQ(depth.status, DistanceStatus::optimal);
    if (!(depth.lower > 0)) continue;
    EXPECT_LE(gauge(W, depth.lower * depth.normal, 1e-7).lower, 1);
    for (int k = 0; k < 20; ++k)
      EXPECT_LE(gauge(W, depth.lower * sphere_points(6, 1, random), 1e-7).lower, 1);
  }
}

TEST(GraspQuality, InAMetricThatWeighsTorquesIsThatOfScaledPoints) {
  Random random(4);
  DepthSolver solver(options(1e-6));
  const Contacts contacts = random_grasp(7, random);
  Contacts smaller = contacts;
  for (GraspContact& c : smaller) c.point *= 0.25;
  Vector axes(6);
  axes << 1, 1, 1, 4, 4, 4;
  const double scaled = solver.solve(GraspWrenches(smaller), euclidean()).depth;
  const ObjectDepth& depth =
      solver.solve(GraspWrenches(contacts), Ellipsoid(Vector::Zero(6), axes.asDiagonal().toDenseMatrix()));
  EXPECT_EQ(depth.status, DistanceStatus::optimal);
  EXPECT_NEAR(depth.depth, scaled, 3e-6 * scaled);
}

TEST(GraspQuality, WithEachForceBoundedIsThatOfTheSumOfCones) {
  Random random(5);
  DepthSolver solver(options(1e-3));
  const Contacts contacts = octahedron();
  const double of_sum = solver.solve(*sum_of(cones_of(contacts, 4)), euclidean()).depth;
  const ObjectDepth& depth = solver.solve(GraspWrenches(contacts, GraspForces::each, 4), euclidean());
  EXPECT_EQ(depth.status, DistanceStatus::optimal);
  EXPECT_NEAR(depth.depth, of_sum, 1e-3 * of_sum);
  const double upper = depth.upper;  // of a set that holds the hull
  EXPECT_GE(upper, solver.solve(GraspWrenches(contacts, GraspForces::sum, 4), euclidean()).lower);
}

TEST(GraspWrenches, SupportIsThatOfTheContactsHull) {
  Random random(6);
  const Contacts contacts = random_grasp(4, random);
  for (const int edges : {0, 3, 8}) {
    const std::vector<SetPointer> cones = cones_of(contacts, edges);
    const UnionHull hull(cones);
    const SetPointer sum = sum_of(cones);
    const GraspWrenches W(contacts, GraspForces::sum, edges), each(contacts, GraspForces::each, edges);
    for (int i = 0; i < 200; ++i) {
      const Vector u = gaussian_points(6, 1, random);
      EXPECT_NEAR(std::max(0.0, W.support_function(u)), hull.support_function(u), kRounding);
      EXPECT_NEAR(each.support_function(u), sum->support_function(u), kRounding);
      EXPECT_NEAR(W.support_mapping(u).dot(u), W.support_function(u), kRounding);
    }
    EXPECT_LE(contains(each, each.center()), Membership::inside);
  }
}

// The torque of a force along its own point is 0; what is computed may lose as much as its products do.
TEST(GraspWrenches, StateHowMuchOfATorqueIsRounded) {
  Vector magnitude(6), of_cone(6), u = Vector::Zero(6), point(6);
  const Vector3d p(1e8, 2e8, 3e8), n(1, 2, 3);
  u[5] = 1;
  const GraspWrenches W({{p, n, 0}});
  const ContactWrenches cone(Vector(p), Vector(n), 0, 0);
  W.magnitude_unchecked(magnitude.data());
  cone.magnitude_unchecked(of_cone.data());
  EXPECT_LE(std::fabs(W.support_unchecked(u.data(), point.data())),
            ConvexSet::rounding_error(6) * magnitude[5]);
  EXPECT_GE(magnitude[5], 3e8);
  EXPECT_GE(of_cone[5], 3e8);
}

TEST(GraspWrenches, RefuseWhatIsNoContact) {
  EXPECT_THROW(GraspWrenches(Contacts{}), EmptySetError);
  EXPECT_THROW(GraspWrenches({{{0, 0, 0}, {0, 0, 0}, 1}}), InvalidParameterError);
  EXPECT_THROW(GraspWrenches({{{0, 0, 0}, {1, 0, 0}, -1}}), InvalidParameterError);
  EXPECT_THROW(GraspWrenches({{{0, NAN, 0}, {1, 0, 0}, 1}}), NonFiniteError);
  EXPECT_THROW(GraspWrenches(octahedron(), GraspForces::sum, 2), InvalidParameterError);
}

}  // namespace
}  // namespace raygauge::test_grasp_quality
