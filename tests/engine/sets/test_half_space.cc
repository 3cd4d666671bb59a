// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/half_space.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <cmath>
#include <limits>

#include "raygauge/exceptions.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/membership.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/queries/pair_batch.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/p_norm_ball.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/prepared_set.h"
#include "raygauge/sets/truncated_cone.h"
#include "tests/engine/rational.h"
#include "tests/engine/sets/set_cases.h"

namespace raygauge::test_half_space {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kRounding = 5e-14;  // of a few numbers of size 10 at most, rounded outward
constexpr ObjectEffects kAll = ObjectEffects::closest_points | ObjectEffects::gradient | ObjectEffects::depth;

Ball unit_ball(int n) { return {Vector::Zero(n), 1.0}; }

struct Signed {
  double lower, upper;
};

Signed bounds_of(const ObjectDistance& r) {
  if (r.depth.evaluations == 0) return {r.distance.lower, r.distance.upper};
  return {-r.depth.upper, r.depth.lower > 0 ? -r.depth.lower : r.distance.upper};
}

TEST(HalfSpace, KeepsItsSetWhateverTheLengthOfItsNormal) {
  const HalfSpace large(Vector3d(0, 3e200, 4e200), 5e200), small(Vector3d(0, 3e-200, 4e-200), 5e-200);
  EXPECT_EQ(large.normal()[2] / large.normal()[1], 4.0 / 3);
  EXPECT_GE(small.normal().maxCoeff(), 1);
  EXPECT_LT(small.normal().maxCoeff(), 2);
  ObjectDistanceSolver solver;
  for (const HalfSpace* half_space : {&large, &small}) {
    const ObjectDistance& r = solver.solve(Ball(Vector3d(0, 3, 4), 1), *half_space, unit_ball(3));
    EXPECT_NEAR(r.distance.distance, 3, 1e-12);
  }
}

TEST(HalfSpace, RefusesWhatIsNone) {
  EXPECT_THROW(HalfSpace(Vector3d(0, 0, 0), 1), InvalidParameterError);
  EXPECT_THROW(HalfSpace(Vector(0), 1), InvalidParameterError);
  EXPECT_THROW(HalfSpace(Vector2d(std::nan(""), 1), 1), NonFiniteError);
  EXPECT_THROW(HalfSpace(Vector2d(0, 1), INFINITY), NonFiniteError);
  EXPECT_THROW(HalfSpace(Vector2d(0, 1e-300), 1e300), InvalidParameterError);
  EXPECT_THROW(HalfSpace(Vector2d(0, 1e300), 1.5e-300), InvalidParameterError);
}

TEST(HalfSpace, HasClosestPointsAndADepthInClosedForm) {
  const HalfSpace floor(Vector3d(0, 0, 2), 1);  // z <= 1/2
  ObjectDistanceSolver solver;
  const ObjectDistance& apart = solver.solve(Ball(Vector3d(1, 2, 3), 1), floor, unit_ball(3), kAll);
  EXPECT_EQ(apart.distance.status, DistanceStatus::optimal);
  EXPECT_NEAR(apart.distance.distance, 1.5, kRounding);
  EXPECT_LE(apart.distance.lower, 1.5);
  EXPECT_GE(apart.distance.upper, 1.5);
  EXPECT_LT((apart.closest_point_1 - Vector3d(1, 2, 2)).norm(), 1e-14);
  EXPECT_LT((apart.closest_point_2 - Vector3d(1, 2, 0.5)).norm(), kRounding);
  EXPECT_LT((apart.gradient_1 - Vector3d(0, 0, 1)).norm(), 1e-14);
  EXPECT_EQ(apart.depth.evaluations, 0);
  const ObjectDistance& inside = solver.solve(floor, Ball(Vector3d(1, 2, 0.25), 1), unit_ball(3), kAll);
  EXPECT_EQ(inside.distance.status, DistanceStatus::contains_origin);
  EXPECT_NEAR(inside.signed_distance(), -1.25, kRounding);
  EXPECT_EQ(inside.depth.status, DistanceStatus::optimal);
  EXPECT_LT((inside.depth.normal - Vector3d(0, 0, -1)).norm(), 1e-14) << "the floor gets out downwards";
  EXPECT_LT((inside.depth.point_1 - Vector3d(1, 2, 0.5)).norm(), kRounding);
  EXPECT_LT((inside.depth.point_2 - Vector3d(1, 2, -0.75)).norm(), 1e-14);
  const ObjectDistance& asked_less = solver.solve(floor, Ball(Vector3d(1, 2, 0.25), 1), unit_ball(3));
  EXPECT_EQ(
      asked_less.depth.evaluations + asked_less.gradient_evaluations + asked_less.closest_point_evaluations,
      0);
}

TEST(HalfSpace, FollowsAMetricThatIsNotTheSameBothWays) {
  const Box Q(Vector2d(-1, -0.5), Vector2d(1, 4));  // down by 1 costs 2, up by 1 a quarter
  const HalfSpace floor(Vector2d(0, 1), 0);
  ObjectDistanceSolver solver;
  const Ball above(Vector2d(0, 3), 1), below(Vector2d(0, 0), 1);
  EXPECT_NEAR(solver.solve(above, floor, Q).distance.distance, 4, 1e-13) << "a2 - a1 leads down";
  EXPECT_NEAR(solver.solve(floor, above, Q).distance.distance, 0.5, 1e-13);
  EXPECT_NEAR(solver.solve(below, floor, Q, kAll).depth.depth, 0.25, 1e-13) << "A1 gets out upwards";
  EXPECT_NEAR(solver.solve(floor, below, Q, kAll).depth.depth, 2, 1e-13);
  const Box one_sided(Vector2d(-1, 0), Vector2d(1, 4));
  EXPECT_EQ(solver.solve(above, floor, one_sided).distance.status, DistanceStatus::precision_limit)
      << "the origin is on the boundary of Q: the distance is infinite, to rounding errors";
}

/// A box so large that nothing near tells it from the half-space.
AffineImage large_box(const HalfSpace& half_space, double size) {
  const int n = half_space.dimension();
  Vector lower = Vector::Constant(n, -size), upper = Vector::Constant(n, size);
  upper[0] = 0;
  Eigen::MatrixXd basis = Eigen::MatrixXd::Random(n, n);
  basis.col(0) = half_space.normal();
  const Eigen::MatrixXd R = Eigen::HouseholderQR<Eigen::MatrixXd>(basis).householderQ();
  const double sign = R.col(0).dot(half_space.normal()) > 0 ? 1 : -1;
  const double length = half_space.normal().norm();
  return {std::make_shared<Box>(lower, upper), sign * R,
          Vector(half_space.normal() * (half_space.offset() / length / length))};
}

TEST(HalfSpace, AgreesWithALargeBoxForEveryKindOfSet) {
  Random random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  ObjectDistanceSolver solver;
  int apart = 0, overlapping = 0;
  for (const SetCase& tested : set_cases()) {
    const int n = tested.set->dimension();
    if (n > 6) continue;
    for (int trial = 0; trial < 6; ++trial) {
      const Vector normal = gaussian_points(n, 1, random).col(0);
      const double middle = normal.dot(tested.set->center());
      const HalfSpace half_space(normal, middle + 4 * uniform(random) * normal.norm());
      const AffineImage box = large_box(half_space, 300);
      const Signed known = bounds_of(solver.solve(*tested.set, half_space, unit_ball(n), kAll));
      const Signed other =
          bounds_of(solver.solve(*tested.set, box, unit_ball(n), n <= 3 ? kAll : ObjectEffects::none));
      const double rounding = 1e-11;  // of the rotation of the box, 300 long
      EXPECT_LE(known.lower, std::max(0.0, other.upper) + (known.lower > 0 ? rounding : 0)) << tested.name;
      if (n <= 3 || other.lower > 0) {
        EXPECT_LE(known.lower, other.upper + rounding) << tested.name;
        EXPECT_GE(known.upper, other.lower - rounding) << tested.name;
      }
      const double size = std::max(std::fabs(known.lower), std::fabs(known.upper));
      EXPECT_LE(known.upper - known.lower, 1e-6 * size) << tested.name;
      ++(known.lower > 0 ? apart : overlapping);
    }
  }
  EXPECT_GT(apart, 50);
  EXPECT_GT(overlapping, 50);
}

TEST(HalfSpace, InAPoseIsTheOneThatWasMoved) {
  Random random(8);
  ObjectDistanceSolver solver;
  for (const SetCase& tested : set_cases()) {
    const int n = tested.set->dimension();
    if (n > 6) continue;
    const Eigen::MatrixXd R = random_rotation(n, random), S = random_rotation(n, random);
    const Vector t = 2 * gaussian_points(n, 1, random).col(0), s = 2 * gaussian_points(n, 1, random).col(0);
    const Vector normal = gaussian_points(n, 1, random).col(0);
    const Pose pose(R, t), pose_of_body(S, s);
    const HalfSpace half_space(normal, 0.5);
    const Vector turned = R * normal;
    const HalfSpace moved(turned, 0.5 + turned.dot(t));
    const Signed posed =
        bounds_of(solver.solve({half_space, pose}, {*tested.set, pose_of_body}, unit_ball(n), kAll));
    const Signed same = bounds_of(solver.solve(moved, {*tested.set, pose_of_body}, unit_ball(n), kAll));
    EXPECT_LE(posed.lower, same.upper + 1e-13) << tested.name;
    EXPECT_GE(posed.upper, same.lower - 1e-13) << tested.name;
  }
}

// Everything is a rational number but |n|, whose square is one.
TEST(HalfSpace, HasBoundsThatHoldInExactArithmetic) {
  EXPECT_TRUE(rc::check([] {
    const int n = *rc::gen::inRange(1, 5);
    const auto number =
        rc::gen::map(rc::gen::pair(rc::gen::inRange(-999, 1000), rc::gen::inRange(-30, 4)),
                     [](const std::pair<int, int>& x) { return std::ldexp(x.first, x.second); });
    const int N = *rc::gen::inRange(1, 7);
    const auto coordinates =
        *rc::gen::container<std::vector<double>>(static_cast<std::size_t>(n * N), number);
    const auto direction = *rc::gen::container<std::vector<double>>(static_cast<std::size_t>(n), number);
    const Eigen::MatrixXd points = Eigen::MatrixXd::Map(coordinates.data(), n, N);
    const Vector normal = Vector::Map(direction.data(), n);
    RC_PRE(normal.lpNorm<1>() > 0);
    const bool touching = *rc::gen::arbitrary<bool>();
    const double offset = touching ? normal.dot(points.col(0)) : *number;
    const HalfSpace half_space(normal, offset);
    const Rational gap = -exact_support(points, -normal) - Rational(offset);
    const Rational square = exact_dot(normal, normal);
    ObjectDistanceSolver solver;
    const bool first = *rc::gen::arbitrary<bool>();
    const PointSet body(points);
    const ObjectDistance& r = first ? solver.solve(half_space, body, unit_ball(n), kAll)
                                    : solver.solve(body, half_space, unit_ball(n), kAll);
    const auto holds = [&](double lower, double upper, const Rational& g) {
      const Rational low = Rational(lower) * Rational(lower) * square;
      if (lower > 0 && !(g > 0 && low <= g * g)) return false;
      return std::isinf(upper) || g <= 0 || g * g <= Rational(upper) * Rational(upper) * square;
    };
    RC_ASSERT(holds(r.distance.lower, r.distance.upper, gap));
    if (r.distance.status == DistanceStatus::contains_origin) RC_ASSERT(gap <= 0);
    if (r.depth.evaluations > 0) RC_ASSERT(holds(r.depth.lower, r.depth.upper, -gap));
    GrowthDistanceSolver separation;
    const Separation outcome =
        (first ? separation.separation(half_space, body) : separation.separation(body, half_space)).outcome;
    if (outcome == Separation::separated) RC_ASSERT(gap > 0);
    if (outcome == Separation::intersecting) RC_ASSERT(gap <= 0);
  }));
}

TEST(HalfSpace, IsDecidedToTheToleranceFarBelowTheRoundingOfDoubles) {
  const HalfSpace floor(Vector3d(0, 0, 1), 0);
  const Box box(Vector3d(-1, -1, -1), Vector3d(1, 1, 1));
  const Cylinder cylinder(Vector3d(0, 0, -1), Vector3d(0, 0, 1), 1);
  const Eigen::Matrix3d tilt = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  ObjectDistanceSolver solver;
  for (const ConvexSet* body : std::array<const ConvexSet*, 2>{&box, &cylinder}) {
    for (const double away : {1e-3, 1e-9, 1e-13, -1e-9, -1e-13}) {
      const Pose posed(tilt, Vector3d(50, -70, 3));
      Vector lowest = body->support_mapping(tilt.transpose() * Vector3d(0, 0, -1));
      const double height = 3 + (tilt * lowest)[2];
      const HalfSpace near(Vector3d(0, 0, 1), height - away);
      const ObjectDistance& r = solver.solve({*body, posed}, near, unit_ball(3), kAll);
      const Signed known = bounds_of(r);
      EXPECT_LE(known.upper - known.lower, 1e-6 * std::fabs(known.upper)) << away;
      EXPECT_NEAR(known.upper, away, 1e-6 * std::fabs(away) + 3e-15) << "height is rounded";
    }
  }
  const ObjectDistance& touching = solver.solve(box, HalfSpace(Vector3d(0, 0, 1), -1), unit_ball(3), kAll);
  EXPECT_EQ(touching.distance.lower, 0);
  EXPECT_LE(touching.distance.upper, 1e-25);
  EXPECT_LE(touching.depth.upper, 1e-25);
}

TEST(HalfSpace, IsSeparatedOrNot) {
  const HalfSpace floor(Vector3d(0, 0, 1), 0);
  GrowthDistanceSolver solver;
  const SeparationResult& apart = solver.separation(floor, Ball(Vector3d(0, 0, 3), 1));
  EXPECT_EQ(apart.outcome, Separation::separated);
  EXPECT_LT(apart.normal[2], 0) << "max over A2 < min over A1";
  EXPECT_EQ(solver.separation(Ball(Vector3d(0, 0, 3), 1), floor).normal[2], 1);
  EXPECT_EQ(solver.separation(Ball(Vector3d(0, 0, 0.5), 1), floor).outcome, Separation::intersecting);
}

TEST(HalfSpace, IsServedInBatches) {
  const HalfSpace floor(Vector3d(0, 0, 1), 0);
  const Ball ball(Vector3d(0, 0, 2), 0.5);
  std::array<double, 2> distance{};
  BatchAnswers answers;
  answers.distance = distance;
  const std::array<PosedPair, 2> pairs = {PosedPair{ball, floor}, PosedPair{floor, ball}};
  PairBatch batch{DistanceOptions()};
  batch.distances(pairs, unit_ball(3), answers);
  EXPECT_NEAR(distance[0], 1.5, 1e-14);
  EXPECT_NEAR(distance[1], 1.5, 1e-14);
  EXPECT_THROW(batch.growth_distances(pairs, answers), InvalidParameterError);
}

TEST(HalfSpace, IsRefusedByEveryOtherQueryInOneLine) {
  const auto shared = std::make_shared<HalfSpace>(Vector3d(0, 0, 1), 0);
  const auto ball = std::make_shared<Ball>(Vector3d(0, 0, 3), 1.0);
  const HalfSpace& floor = *shared;
  const auto refused = [](const char* what, const std::function<void()>& use) {
    SCOPED_TRACE(what);
    try {
      use();
      ADD_FAILURE() << "not refused";
    } catch (const InvalidParameterError& error) {
      const std::string text = error.what();
      EXPECT_NE(text.find("half-space"), std::string::npos) << text;
      EXPECT_EQ(text.find('\n'), std::string::npos);
    }
  };
  for (const DistanceMethod method : {DistanceMethod::automatic, DistanceMethod::newton,
                                      DistanceMethod::zheng_yamane, DistanceMethod::column_generation}) {
    DistanceOptions options;
    options.method = method;
    DistanceSolver solver(options);
    GrowthDistanceSolver growth(options);
    ObjectDistanceSolver objects(options);
    refused("A", [&] { solver.solve(floor, *ball); });
    refused("Q", [&] { solver.solve(*ball, floor); });
    refused("growth", [&] { growth.solve(*ball, floor); });
    refused("growth about centres", [&] { growth.solve_about_centers(floor, *ball); });
    refused("metric", [&] { objects.solve(*ball, *ball, floor); });
    refused("metric of a half-space", [&] { objects.solve(*ball, floor, floor); });
    refused("two half-spaces", [&] { objects.solve(floor, floor, *ball); });
    refused("an image", [&] {
      objects.solve(AffineImage(shared, Eigen::Matrix3d::Identity(), Vector::Zero(3)), *ball, unit_ball(3));
    });
    refused("a sum", [&] { objects.solve(MinkowskiSum(shared, ball), *ball, unit_ball(3)); });
    refused("a hull", [&] { objects.solve(UnionHull({shared, ball}), *ball, unit_ball(3)); });
  }
  refused("two half-spaces", [&] { GrowthDistanceSolver().separation(floor, floor); });
  refused("contains", [&] { contains(floor, Vector3d(0, 0, 1)); });
  refused("gauge", [&] { gauge(floor, Vector3d(0, 0, 1)); });
  refused("center", [&] { floor.center(); });
  refused("support_mapping", [&] { floor.support_mapping(Vector3d(0, 0, 1)); });
  EXPECT_THROW(ObjectDistanceSolver().solve(floor, Ball(Vector2d(0, 0), 1), unit_ball(3)),
               DimensionMismatchError);
  EXPECT_THROW(ObjectDistanceSolver().solve(floor, *ball, unit_ball(2)), DimensionMismatchError);
}

TEST(HalfSpace, LeavesASolverAsItWas) {
  const HalfSpace floor(Vector3d(0, 0, 1), 0);
  const Ball ball(Vector3d(0, 0, 0.5), 1), far(Vector3d(4, 0, 0), 1);
  ObjectDistanceSolver used, fresh;
  used.solve(ball, floor, unit_ball(3), kAll);
  EXPECT_THROW(used.solve(floor, floor, unit_ball(3)), InvalidParameterError);
  const ObjectDistance& r = used.solve(ball, far, unit_ball(3), kAll);
  const ObjectDistance& s = fresh.solve(ball, far, unit_ball(3), kAll);
  EXPECT_EQ(r.distance.distance, s.distance.distance);
  EXPECT_EQ(r.depth.evaluations, 0);
  EXPECT_TRUE(std::isnan(r.depth.depth));
}

}  // namespace
}  // namespace raygauge::test_half_space
