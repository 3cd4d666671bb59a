// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// The method `newton` at its limits: sets of more pieces than it keeps, sizes whose squares underflow,
// contact at the origin itself. Its certificates must hold there too.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "raygauge/queries/solver.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/polytopes.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_newton_limits {
namespace {

DistanceOptions newton_options(double tolerance = 1e-9) {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  options.tolerance = tolerance;
  return options;
}

Vector at(double x, double y, double z) { return Vector{{x, y, z}}; }

// 2 · 2 · 2 pieces, which cannot be listed in place.
std::shared_ptr<ConvexSet> sum_of_three_capsules(const Vector& shift) {
  const auto first = std::make_shared<Capsule>(shift - at(1, 0, 0), shift + at(1, 0, 0), 0.1);
  const auto second = std::make_shared<Capsule>(at(0, -1, 0), at(0, 1, 0), 0.1);
  const auto third = std::make_shared<Capsule>(at(0, 0, -1), at(0, 0, 1), 0.1);
  return std::make_shared<MinkowskiSum>(std::make_shared<MinkowskiSum>(first, second), third);
}

// The unit cube around `center`, its corners balls of radius 0.1, and one more ball inside.
std::shared_ptr<ConvexSet> hull_of_nine_balls(const Vector& center) {
  std::vector<std::shared_ptr<const ConvexSet>> balls{std::make_shared<Ball>(center, 0.1)};
  for (int corner = 0; corner < 8; ++corner) {
    const Vector offset = at(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
    balls.push_back(std::make_shared<Ball>(center + offset, 0.1));
  }
  return std::make_shared<UnionHull>(std::move(balls));
}

// Leaves other pieces, smaller and larger, in the solver's memory.
void poison(DistanceSolver& solver, double size) {
  solver.solve(Ball(at(3 * size, size, 0), size), Ball(at(0, 0, 0), 0.1 * size));
  solver.solve(Capsule(at(-7, 2, 5) * size, at(9, 3, 5) * size, 0.5 * size), Ball(at(0, 0, 0), 2 * size));
}

TEST(NewtonLimits, SetsOfMorePiecesThanItKeepsAreAnsweredRightly) {
  const Ball gauge(at(0, 0, 0), 1.0);
  for (const double size : {1e-3, 1.0, 1e3}) {
    DistanceSolver solver(newton_options());
    poison(solver, size);
    // A cube of edge 2, rounded by 0.3, around (5, 0, 0).
    const DistanceResult& far = solver.solve(*sum_of_three_capsules(at(5, 0, 0)), gauge);
    EXPECT_LE(far.lower, 3.7 * (1 + 1e-14));
    EXPECT_GE(far.upper, 3.7 * (1 - 1e-14));
    EXPECT_LE(far.upper - far.lower, 1e-9 * far.upper);
    poison(solver, size);
    const DistanceResult& hull = solver.solve(*hull_of_nine_balls(at(2, 0, 0)), gauge);
    EXPECT_LE(hull.lower, 1.4 * (1 + 1e-14));
    EXPECT_GE(hull.upper, 1.4 * (1 - 1e-14));
    EXPECT_LE(hull.upper - hull.lower, 1e-9 * hull.upper);
  }
}

TEST(NewtonLimits, AGaugeOfMorePiecesThanItKeepsIsAnsweredRightly) {
  DistanceSolver solver(newton_options());
  poison(solver, 1.0);
  const DistanceResult& result = solver.solve(Ball(at(5, 0, 0), 0.5), *sum_of_three_capsules(at(0, 0, 0)));
  const double truth = 4.5 / 1.3;
  EXPECT_LE(result.lower, truth * (1 + 1e-14));
  EXPECT_GE(result.upper, truth * (1 - 1e-14));
}

class Sizes : public ::testing::TestWithParam<int> {};

// A squared residual would vanish; nothing may be concluded from that.
TEST_P(Sizes, LeaveTheBoundsOfBallsTrue) {
  const double size = std::ldexp(1.0, GetParam());
  for (int trial = 0; trial < 20; ++trial) {
    Random random(static_cast<unsigned>(trial));
    const Vector direction = sphere_points(3, 1, random);
    const Ball A(size * 3 * direction, size);
    const Ball Q(size * 0.25 * sphere_points(3, 1, random), size);
    const DistanceResult reference =
        DistanceSolver(newton_options()).solve(Ball(A.center() / size, 1.0), Ball(Q.center() / size, 1.0));
    DistanceSolver solver(newton_options(1e-12));
    const DistanceResult& result = solver.solve(A, Q);
    EXPECT_LE(result.lower, reference.upper * (1 + 1e-12));
    EXPECT_GE(result.upper, reference.lower * (1 - 1e-12)) << to_string(result.status);
  }
}

INSTANTIATE_TEST_SUITE_P(PowersOfTwo, Sizes, ::testing::Values(-700, -600, -560, -540, -500, 0, 450, 500));

// A ball that all but touches the origin from outside: its distance is |c| - r over the unit ball.
TEST(NewtonLimits, BallsThatAllButTouchTheOriginHaveTrueBounds) {
  const Ball gauge(at(0, 0, 0), 1.0);
  for (int trial = 0; trial < 400; ++trial) {
    Random random(static_cast<unsigned>(trial));
    const Vector c = sphere_points(3, 1, random) * (1 + std::ldexp(1.0, -53 + trial % 12));
    long double square = 0;
    for (const double x : c) square += static_cast<long double>(x) * x;
    const double truth = static_cast<double>(std::sqrt(square) - 1.0L);
    const DistanceResult result = DistanceSolver(newton_options(1e-6)).solve(Ball(c, 1.0), gauge);
    EXPECT_LE(0, result.lower);
    EXPECT_LE(result.lower, result.upper);
    EXPECT_LE(result.lower, std::max(truth, 0.0) + 1e-18) << to_string(result.status);
    EXPECT_GE(result.upper, truth - 1e-18) << to_string(result.status);
  }
}

// The slanted face of a simplex with long legs passes near the origin.
TEST(NewtonLimits, ASimplexOfLongLegsKnowsTheBallInIt) {
  for (const int exponent : {0, 500, 545, 600}) {
    const double leg = std::ldexp(1.0, exponent);
    const Simplex simplex(-0.25 * leg * Vector::Ones(3), leg * Vector::Ones(3));
    const double origin[3] = {};
    const double radius = simplex.inner_radius_unchecked(origin);
    EXPECT_GT(radius, 0.14 * leg);
    EXPECT_LE(radius, 0.25 / std::sqrt(3.0) * leg) << "beyond the face x + y + z = leg / 4";
  }
}

// Found by `raygauge_soak sets --seed 41`, pair 10735403. No ball around 0 lies in Q, which has 0 on its
// boundary, and the points of A are exact, which left nothing to shift A by: a ball elsewhere in Q then paid
// for residuals. The gauge of Q at x is |x|²/(2 x·c).
TEST(NewtonLimits, BoundsHoldWhereTheOnlyKnownBallOfQIsNotAroundTheOrigin) {
  const Vector c{{1, 0, 0}};
  const Ball Q(c, 1);
  for (const double height : {1e-4, 1e-2, 1.0}) {
    Eigen::MatrixXd points(3, 2);
    points << height, 2 * height, 1, -1, 0.5, 0.25;
    double truth = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= 100000; ++i) {
      const Vector x = points.col(0) + i * 1e-5 * (points.col(1) - points.col(0));
      truth = std::min(truth, x.squaredNorm() / (2 * x.dot(c)));
    }
    for (int evaluations = 1; evaluations < 30; ++evaluations) {
      DistanceOptions options;
      options.method = DistanceMethod::newton;
      options.tolerance = 1e-12;
      options.max_iterations = evaluations;
      const DistanceResult result = DistanceSolver(options).solve(PointSet(points), Q);
      SCOPED_TRACE(std::to_string(evaluations) + " evaluations, height " + std::to_string(height));
      EXPECT_LE(result.lower, truth);
      EXPECT_GE(result.upper, truth * (1 - 1e-8));  // as near as the samples come
    }
  }
}

}  // namespace
}  // namespace raygauge::test_newton_limits
