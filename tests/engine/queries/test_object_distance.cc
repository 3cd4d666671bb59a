// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/object_distance.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "raygauge/exceptions.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/p_norm_ball.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/truncated_cone.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_object_distance {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kAccuracy = 1e-9;

double norm(const Vector& x, double p) {
  const double largest = x.cwiseAbs().maxCoeff();
  if (p == kInfinity || largest == 0) return largest;
  return largest * std::pow((x.cwiseAbs() / largest).array().pow(p).sum(), 1 / p);
}

double dual_exponent(double p) {
  if (p == 1) return kInfinity;
  return p == kInfinity ? 1 : p / (p - 1);
}

PNormBall unit_ball(int n, double p) { return {Vector::Zero(n), Vector::Ones(n), p}; }

DistanceOptions options(DistanceMethod method, double tolerance) {
  DistanceOptions result;
  result.method = method;
  result.tolerance = tolerance;
  return result;
}

// x is behind the support planes of S across random directions and across the ones given.
void expect_inside(const ConvexSet& S, const Vector& x, const Vector& u, Random& random) {
  for (int i = 0; i < 200; ++i) {
    const Vector v = i == 0 ? u : i == 1 ? Vector(-u) : Vector(sphere_points(S.dimension(), 1, random));
    EXPECT_LE(v.normalized().dot(x), S.support_function(v.normalized()) + kAccuracy);
  }
}

class ObjectDistances : public ::testing::TestWithParam<DistanceMethod> {};
INSTANTIATE_TEST_SUITE_P(Methods, ObjectDistances,
                         ::testing::Values(DistanceMethod::column_generation, DistanceMethod::newton),
                         [](const auto& instance) { return std::string(to_string(instance.param)); });

TEST_P(ObjectDistances, OfBoxesAreThePNormOfTheGapsBetweenThem) {
  Random random(81);
  ObjectDistanceSolver solver(options(GetParam(), 1e-10));
  for (const int n : {2, 3, 5}) {
    for (const double p : {1.0, 1.5, 2.0, 3.0, kInfinity}) {
      const PNormBall Q = unit_ball(n, p);
      for (int i = 0; i < 6; ++i) {
        const Vector c = 4 * gaussian_points(n, 1, random), half_1 = gaussian_points(n, 1, random).cwiseAbs(),
                     half_2 = gaussian_points(n, 1, random).cwiseAbs();
        const Box A1(-half_1, half_1), A2(c - half_2, c + half_2);
        const double truth = norm((c.cwiseAbs() - half_1 - half_2).cwiseMax(0), p);
        if (truth == 0) continue;
        const ObjectDistance& result = solver.solve(A1, A2, Q, ObjectEffects::closest_points);
        SCOPED_TRACE("n = " + std::to_string(n) + ", p = " + std::to_string(p) + ", pair " +
                     std::to_string(i));
        EXPECT_NEAR(result.distance.distance, truth, kAccuracy * truth);
        ASSERT_EQ(result.closest_point_1.size(), n);
        EXPECT_LE((result.closest_point_1.cwiseAbs() - half_1).maxCoeff(), kAccuracy);
        EXPECT_LE(((result.closest_point_2 - c).cwiseAbs() - half_2).maxCoeff(), kAccuracy);
        EXPECT_NEAR(norm(result.closest_point_2 - result.closest_point_1, p), truth, kAccuracy * truth);
      }
    }
  }
}

// Objects far from each other in one coordinate and level in the others: flat faces and sharp edges meet.
TEST_P(ObjectDistances, OfPNormBallsAreProvenByTheClosestPoints) {
  Random random(85);
  ObjectDistanceSolver solver(options(GetParam(), 1e-12));
  for (const int n : {2, 3, 8}) {
    for (const double p : {1.5, 3.0, 10.0, 100.0, 1e6}) {
      for (int i = 0; i < 6; ++i) {
        const Vector axes_1 = Vector::Ones(n) + gaussian_points(n, 1, random).cwiseAbs();
        const Vector axes_2 = Vector::Ones(n) + gaussian_points(n, 1, random).cwiseAbs();
        Vector center = gaussian_points(n, 1, random);
        center[0] = 20;
        const PNormBall A1(Vector::Zero(n), axes_1, p), A2(center, axes_2, p);
        const ObjectDistance& result = solver.solve(A1, A2, unit_ball(n, 2), ObjectEffects::closest_points);
        SCOPED_TRACE("n = " + std::to_string(n) + ", p = " + std::to_string(p) + ", pair " +
                     std::to_string(i));
        EXPECT_EQ(result.distance.status, DistanceStatus::optimal) << to_string(result.distance.status);
        if (GetParam() == DistanceMethod::newton &&
            p < 1e3) {  // beyond, only `column_generation` finds corners of cubes
          EXPECT_EQ(result.distance.counters.points_priced, 0) << "handed over to column_generation";
        }
        ASSERT_EQ(result.closest_point_1.size(), n);
        EXPECT_LE(norm(result.closest_point_1.cwiseQuotient(axes_1), p), 1 + kAccuracy);
        EXPECT_LE(norm((result.closest_point_2 - center).cwiseQuotient(axes_2), p), 1 + kAccuracy);
        const double between = (result.closest_point_2 - result.closest_point_1).norm();
        EXPECT_NEAR(between, result.distance.distance, kAccuracy * between);
      }
    }
  }
}

// Weak duality over all pairs of points, in plain loops, proves what the solver found: for the normal u,
// min (a2 - a1)·(-u) / ‖u‖_q is below the distance, ‖a2 - a1‖_p of the closest points above it.
TEST_P(ObjectDistances, OfPointSetsAreProvenByTheNormalAndTheClosestPoints) {
  Random random(82);
  ObjectDistanceSolver solver(options(GetParam(), 1e-10));
  for (const int n : {2, 3, 4}) {
    for (const double p : {1.0, 1.5, 2.0, 3.0, kInfinity}) {
      const PNormBall Q = unit_ball(n, p);
      for (int i = 0; i < 4; ++i) {
        Eigen::MatrixXd points_2 = gaussian_points(n, 30, random);
        points_2.row(0).array() += 8;
        const Eigen::MatrixXd points_1 = gaussian_points(n, 30, random);
        const PointSet A1(points_1), A2(points_2);
        const ObjectDistance& result = solver.solve(A1, A2, Q, ObjectEffects::closest_points);
        SCOPED_TRACE("n = " + std::to_string(n) + ", p = " + std::to_string(p) + ", pair " +
                     std::to_string(i));
        const Vector u = result.distance.normal;
        const double lower =
            ((-u.transpose() * points_2).minCoeff() - (-u.transpose() * points_1).maxCoeff()) /
            norm(u, dual_exponent(p));
        ASSERT_EQ(result.closest_point_1.size(), n);
        const double upper = norm(result.closest_point_2 - result.closest_point_1, p);
        EXPECT_LE(upper - lower, kAccuracy * upper);
        EXPECT_NEAR(result.distance.distance, upper, kAccuracy * upper);
        expect_inside(A1, result.closest_point_1, u, random);
        expect_inside(A2, result.closest_point_2, u, random);
      }
    }
  }
}

TEST_P(ObjectDistances, OfSmoothObjectsAreRealisedByTheirClosestPoints) {
  Random random(83);
  ObjectDistanceSolver solver(options(GetParam(), 1e-9));
  for (int i = 0; i < 30; ++i) {
    const Vector c = 6 * sphere_points(3, 1, random);
    const Vector axis = sphere_points(3, 1, random);
    const std::array<std::shared_ptr<ConvexSet>, 3> objects = {
        std::make_shared<Ellipsoid>(c, gaussian_points(3, 3, random)),
        std::make_shared<TruncatedCone>(c, 1, c + axis, 0.4), std::make_shared<Capsule>(c, c + axis, 0.5)};
    const Ball A1(Vector::Zero(3), 0.7);
    const PNormBall Q = unit_ball(3, 2);
    for (const auto& A2 : objects) {
      const ObjectDistance& result = solver.solve(A1, *A2, Q, ObjectEffects::closest_points);
      if (result.distance.lower == 0) continue;
      ASSERT_EQ(result.closest_point_1.size(), 3);
      EXPECT_LE(result.closest_point_1.norm(), 0.7 + kAccuracy);
      expect_inside(*A2, result.closest_point_2, result.distance.normal, random);
      const double realised = (result.closest_point_2 - result.closest_point_1).norm();
      EXPECT_NEAR(realised, result.distance.distance, 2e-9 * realised);
    }
  }
}

TEST(ObjectDistance, MovesByItsGradients) {
  Random random(84);
  constexpr double step = 1e-5;
  ObjectDistanceSolver solver(options(DistanceMethod::newton, 1e-12));
  const Ellipsoid Q(Vector::Constant(3, 0.1),
                    0.3 * gaussian_points(3, 3, random) + Eigen::MatrixXd::Identity(3, 3));
  for (int i = 0; i < 20; ++i) {
    const Vector c = 6 * sphere_points(3, 1, random), axis = sphere_points(3, 1, random);
    const auto distance = [&](const Vector& move_1, const Vector& move_2, ObjectEffects effects) -> auto& {
      return solver.solve(Ball(move_1, 0.7), TruncatedCone(c + move_2, 1, c + axis + move_2, 0.4), Q,
                          effects);
    };
    const Vector zero = Vector::Zero(3);
    const ObjectDistance at_rest = distance(zero, zero, ObjectEffects::gradient);
    ASSERT_EQ(at_rest.gradient_1.size(), 3);
    EXPECT_EQ(at_rest.gradient_evaluations, 1);
    for (int k = 0; k < 3; ++k) {
      const Vector move = step * Vector::Unit(3, k);
      const auto slope = [&](double ahead, double behind) { return (ahead - behind) / (2 * step); };
      const double ahead_1 = distance(move, zero, ObjectEffects::none).distance.distance;
      const double behind_1 = distance(-move, zero, ObjectEffects::none).distance.distance;
      EXPECT_NEAR(at_rest.gradient_1[k], slope(ahead_1, behind_1), 1e-6);
      const double ahead_2 = distance(zero, move, ObjectEffects::none).distance.distance;
      const double behind_2 = distance(zero, -move, ObjectEffects::none).distance.distance;
      EXPECT_NEAR(at_rest.gradient_2[k], slope(ahead_2, behind_2), 1e-6);
    }
  }
}

TEST(ObjectDistance, ChargesNothingForWhatWasNotAskedFor) {
  const Ball A1(Vector::Zero(3), 1), A2(4 * Vector::Unit(3, 0), 1);
  const PNormBall Q = unit_ball(3, 2);
  ObjectDistanceSolver solver(options(DistanceMethod::newton, 1e-9));
  const ObjectDistance plain = solver.solve(A1, A2, Q);
  EXPECT_EQ(plain.closest_point_evaluations, 0);
  EXPECT_EQ(plain.gradient_evaluations, 0);
  EXPECT_EQ(plain.closest_point_1.size() + plain.closest_point_2.size(), 0);
  EXPECT_EQ(plain.gradient_1.size() + plain.gradient_2.size(), 0);
  const ObjectDistance all = solver.solve(A1, A2, Q, ObjectEffects::closest_points | ObjectEffects::gradient);
  EXPECT_EQ(all.closest_point_evaluations, 1);
  EXPECT_EQ(all.gradient_evaluations, 1);
  EXPECT_EQ(all.distance.counters, plain.distance.counters) << "the effects cost support queries";
}

TEST(ObjectDistance, OfObjectsThatMeetIsZeroAndHasNoClosestPoints) {
  ObjectDistanceSolver solver;
  const ObjectDistance& result =
      solver.solve(Ball(Vector::Zero(2), 1), Ball(Vector::Unit(2, 0), 1), unit_ball(2, 2),
                   ObjectEffects::closest_points | ObjectEffects::gradient);
  EXPECT_EQ(result.distance.status, DistanceStatus::contains_origin);
  EXPECT_EQ(result.distance.distance, 0);
  EXPECT_EQ(result.closest_point_1.size(), 0);
  EXPECT_EQ(result.gradient_1.size(), 0);
}

TEST(ObjectDistance, RefusesObjectsOfDifferentDimension) {
  ObjectDistanceSolver solver;
  EXPECT_THROW(solver.solve(Ball(Vector::Zero(2), 1), Ball(Vector::Zero(3), 1), unit_ball(3, 2)),
               DimensionMismatchError);
  EXPECT_THROW(solver.solve(Ball(Vector::Zero(3), 1), Ball(Vector::Zero(3), 1), unit_ball(2, 2)),
               DimensionMismatchError);
}

}  // namespace
}  // namespace raygauge::test_object_distance
