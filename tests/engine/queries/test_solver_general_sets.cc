// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "raygauge/queries/object_distance.h"
#include "tests/engine/both_methods.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_solver_general_sets {
namespace {

// {x : |x - c| <= r}, as a user would write it.
class Ball final : public ConvexSet {
 public:
  Ball(Vector center, double radius)
      : ConvexSet(static_cast<int>(center.size())), center_(std::move(center)), radius_(radius) {}

 private:
  double do_support(const double* u, double* point) const override {
    const Eigen::Map<const Eigen::VectorXd> direction(u, dimension());
    Eigen::Map<Eigen::VectorXd> maximiser(point, dimension());
    const double length = direction.norm();
    maximiser = center_;
    if (length > 0) maximiser += radius_ / length * direction;
    return direction.dot(center_) + radius_ * length;
  }
  void do_center(double* point) const override { Vector::Map(point, dimension()) = center_; }

  Vector center_;
  double radius_;
};

// conv of a few points behind the general interface: nothing in it tells the solver that it is a point set.
class DisguisedPoints final : public ConvexSet {
 public:
  explicit DisguisedPoints(const Eigen::MatrixXd& points)
      : ConvexSet(static_cast<int>(points.rows())), points_(points) {}

 private:
  double do_support(const double* u, double* point) const override {
    return points_.support_unchecked(u, point);
  }
  void do_center(double* point) const override { points_.center_unchecked(point); }

  PointSet points_;
};

class GeneralSets : public BothMethods {
 protected:
  static DistanceResult solve(const ConvexSet& A, const ConvexSet& Q, double tolerance) {
    return DistanceSolver(options(tolerance)).solve(A, Q);
  }

  // The support values of a ball are themselves rounded, so truth is met within 1e-13.
  static void expect_result(const DistanceResult& result, double truth, double tolerance) {
    EXPECT_EQ(result.status, DistanceStatus::optimal) << "truth " << truth;
    EXPECT_LE(result.lower, truth * (1 + 1e-13));
    EXPECT_GE(result.upper, truth * (1 - 1e-13));
    EXPECT_LE(result.upper - result.lower, tolerance * result.upper);
  }
};
RAYGAUGE_BOTH_METHODS(GeneralSets);
RAYGAUGE_NEWTON_TOO(GeneralSets);

TEST_P(GeneralSets, OfTwoBallsAreAtTheDistanceOfTheirCentersLessOneRadius) {
  Random random(91);
  for (const int n : {1, 2, 3, 5, 10}) {
    const Vector c = 5 * sphere_points(n, 1, random);
    expect_result(solve(Ball(c, 1), Ball(Vector::Zero(n), 2), 1e-6), 2, 1e-6);
  }
}

TEST_P(GeneralSets, OfABallAgainstPointsMatchItsClosedForm) {
  // A ball of radius r at c against the cube: max_i |c_i| - r along an axis.
  for (const int n : {1, 2, 3, 4}) {
    const Ball ball(4 * Vector::Unit(n, n - 1), 0.5);
    expect_result(solve(ball, PointSet(cube_vertices(n)), 1e-6), 3.5, 1e-6);
    expect_result(solve(PointSet(Vector(-6 * Vector::Unit(n, 0))), Ball(Vector::Zero(n), 1.5), 1e-6), 4,
                  1e-6);
  }
}

TEST_P(GeneralSets, OfAnOffCenterGaugeAreFoundToo) {
  // Q = ball of radius 2 at (1, 0): the point (6, 0) is reached at 6 / 3.
  const Ball Q((Vector(2) << 1, 0).finished(), 2);
  expect_result(solve(PointSet((Vector(2) << 6, 0).finished()), Q, 1e-9), 2, 1e-9);
}

TEST_P(GeneralSets, ThatAreHiddenPointSetsGetTheSameAnswer) {
  Random random(92);
  for (const int n : {2, 3, 6, 10}) {
    Eigen::MatrixXd A = sphere_points(n, 200, random);
    A.row(0).array() += 3;
    const Eigen::MatrixXd Q = sphere_points(n, 200, random);
    const DistanceResult open = BothMethods::solve(A, Q, 1e-9);
    const DistanceResult hidden = solve(DisguisedPoints(A), DisguisedPoints(Q), 1e-9);
    EXPECT_EQ(hidden.status, DistanceStatus::optimal);
    EXPECT_LE(hidden.lower, open.upper);
    EXPECT_LE(open.lower, hidden.upper);
  }
}

// The linear program scales sets far from magnitude 1: what it answers is in the sets' own units.
// Of large point sets a sample is solved first, which the points that price out join.
TEST_P(GeneralSets, BesideThousandsOfPointsAreAsIfAllWerePoints) {
  Random random(92);
  for (const int n : {3, 6, 20}) {
    const Eigen::MatrixXd a = sphere_points(n, 4000, random).colwise() + 3 * Vector::Unit(n, 0);
    const Eigen::MatrixXd q = sphere_points(n, 4000, random);
    const double truth = solve(PointSet(a), PointSet(q), 1e-9).distance;
    expect_result(solve(DisguisedPoints(a), PointSet(q), 1e-6), truth, 1e-6);
    expect_result(solve(PointSet(a), DisguisedPoints(q), 1e-6), truth, 1e-6);
  }
}

TEST_P(GeneralSets, OfAnyMagnitudeHaveNormalsAndContactsInTheirOwnUnits) {
  for (const double unit : {0x1p-40, 1.0, 0x1p20, 0x1p100}) {
    const Vector center = unit * (Vector(3) << 6, 8, 0).finished();
    const Ball A(center, 2 * unit), Q(Vector::Zero(3), unit);
    const DistanceResult result = DistanceSolver(options(1e-9)).solve(A, Q, Effects::witness);
    expect_result(result, 8, 1e-9);
    EXPECT_NEAR(Q.support_function(-result.normal), 1, 1e-12) << unit;
    EXPECT_NEAR(-A.support_function(result.normal), 8, 1e-7) << unit;
    EXPECT_LE((result.contact_point - 0.8 * center).norm(), 1e-3 * unit);
  }
}

TEST_P(GeneralSets, OfAnyMagnitudeHaveClosestPointsInTheirOwnUnits) {
  for (const double unit : {0x1p-40, 1.0, 0x1p20}) {
    const Ball A1(Vector::Zero(2), unit), A2(unit * Vector::Unit(2, 0) * 5, unit), Q(Vector::Zero(2), unit);
    ObjectDistanceSolver solver(options(1e-9));
    const ObjectDistance& result = solver.solve(A1, A2, Q, ObjectEffects::closest_points);
    expect_result(result.distance, 3, 1e-9);
    ASSERT_EQ(result.closest_point_1.size(), 2);
    EXPECT_LE((result.closest_point_1 - unit * Vector::Unit(2, 0)).norm(), 1e-3 * unit);
    EXPECT_LE((result.closest_point_2 - 4 * unit * Vector::Unit(2, 0)).norm(), 1e-3 * unit);
  }
}

TEST_P(GeneralSets, SayThatTheOriginLiesInside) {
  const DistanceResult result = solve(Ball(Vector::Unit(3, 0), 2), Ball(Vector::Zero(3), 1), 1e-6);
  EXPECT_EQ(result.status, DistanceStatus::contains_origin);
  EXPECT_EQ(result.distance, 0);
}

TEST_P(GeneralSets, SayThatAGaugeCannotReach) {
  // Q lies in x_1 >= 1; A in x_1 <= -1.
  const DistanceResult result =
      solve(Ball(-2 * Vector::Unit(3, 0), 1), Ball(2 * Vector::Unit(3, 0), 1), 1e-6);
  EXPECT_EQ(result.status, DistanceStatus::unreachable);
  EXPECT_TRUE(std::isinf(result.distance));
}

}  // namespace
}  // namespace raygauge::test_solver_general_sets
