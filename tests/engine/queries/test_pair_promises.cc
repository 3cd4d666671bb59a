// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What holds for every pair of bodies of R^2 and R^3: no memory of other pairs, bounds that only get better,
// planes that separate, flat bodies in a common plane.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/queries/pair_batch.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/truncated_cone.h"
#include "tests/engine/random_poses.h"

namespace raygauge::test_pair_promises {
namespace {

using SetPointer = std::shared_ptr<const ConvexSet>;
using Eigen::Vector2d;
using Eigen::Vector3d;
using testing::gaussian;
using testing::Random;

DistanceOptions options(double tolerance) {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  options.tolerance = tolerance;
  return options;
}

// A segment and a point beside it, which were "in contact" after two boxes had been solved.
struct SegmentAndPoint {
  Box one{Vector2d(-1, -1), Vector2d(1, 1)}, other{Vector2d(2, 2), Vector2d(3, 3)};
  Pose far{Eigen::Matrix2d::Identity(), Vector2d(100, 0)};
  Capsule segment{Vector2d(0.036937123349985113, -0.24224713534436512),
                  Vector2d(-0.35598201633707455, -0.20242372137475048), 0};
  Ball point{Vector2d(-0.10844295833423767, -0.22751247217571341), 0};
  Ball metric{Vector2d::Zero(), 1};
  static constexpr double kDistance = 1.06245e-13;
};

TEST(PairPromises, ASegmentAndAPointAreApartWhateverWasSolvedBefore) {
  const SegmentAndPoint pairs;
  ObjectDistanceSolver solver(options(1e-6));
  solver.solve({pairs.one, pairs.far}, {pairs.other, pairs.far}, pairs.metric, ObjectEffects::none, nullptr);
  const DistanceResult& r = solver.solve(pairs.segment, pairs.point, pairs.metric).distance;
  EXPECT_NEAR(r.distance, SegmentAndPoint::kDistance, 1e-18);
  EXPECT_EQ(r.status, DistanceStatus::optimal);
}

TEST(PairPromises, ABatchKeepsNothingOfOtherPairs) {
  const SegmentAndPoint pairs;
  PairBatch batch(options(1e-6));
  const std::vector<PosedPair> both = {{{pairs.one, pairs.far}, {pairs.other, pairs.far}},
                                       {Posed(pairs.segment), Posed(pairs.point)}};
  std::array<double, 2> distance{};
  BatchAnswers answers;
  answers.distance = distance;
  batch.distances(both, pairs.metric, answers);
  EXPECT_NEAR(distance[1], SegmentAndPoint::kDistance, 1e-18);
}

std::vector<SetPointer> bodies(Random& random) {
  const Vector3d up(0, 0, 0.6);
  Eigen::MatrixXd cloud(3, 20);
  for (int i = 0; i < 20; ++i) cloud.col(i) = gaussian(random).normalized();
  return {std::make_shared<Ball>(Vector3d(0.1, 0, 0), 0.8),
          std::make_shared<Box>(Vector3d(-0.6, -0.5, -0.4), Vector3d(0.6, 0.5, 0.4)),
          std::make_shared<Capsule>(Vector3d(-up), up, 0.4),
          std::make_shared<Capsule>(Vector3d(-up), up, 0),
          std::make_shared<Cylinder>(Vector3d(-up), up, 0.5),
          std::make_shared<Ellipsoid>(Vector3d(0, 0, 0), Eigen::Matrix3d(Vector3d(1, 0.6, 0.4).asDiagonal())),
          std::make_shared<PointSet>(cloud)};
}

// In coordinates of long double, R x + t.
using Long = Eigen::Matrix<long double, 3, 1>;
Long placed(const Pose& pose, const Vector3d& x) {
  return pose.rotation().cast<long double>() * x.cast<long double>() + pose.translation().cast<long double>();
}

Vector3d highest(const ConvexSet& S, const Pose& pose, const Vector3d& u) {
  const Vector3d v = pose.rotation().transpose() * u;
  Vector3d point;
  S.support_unchecked(v.data(), point.data());
  return point;
}

// The second body where a point of it is `gap` beyond one of the first along a random u.
struct NearPair {
  NearPair(const ConvexSet& S, const ConvexSet& T, Random& random, double gap, double defect)
      : first(turned(random, defect), gaussian(random)), second(3) {
    const Vector3d u = gaussian(random).normalized();
    const Pose turn(turned(random, defect), Vector3d::Zero());
    const Long a = placed(first, highest(S, first, u)), b = placed(turn, highest(T, turn, -u));
    second = Pose(turn.rotation(), Vector3d((a - b + gap * u.cast<long double>()).cast<double>()));
  }

  static Eigen::MatrixXd turned(Random& random, double defect) {
    Eigen::Matrix3d R =
        Eigen::AngleAxisd(gaussian(random).norm(), gaussian(random).normalized()).toRotationMatrix();
    for (int k = 0; k < 3; ++k) R.col(k) += defect * gaussian(random).normalized();
    return R;
  }

  Pose first, second;
};

TEST(PairPromises, ATighterToleranceNeverGivesWiderBounds) {
  Random random(71);
  const auto sets = bodies(random);
  const Ball metric(Vector3d::Zero(), 1);
  ObjectDistanceSolver loose(options(1e-6)), tight(options(1e-10));
  std::uniform_real_distribution<double> exponent(-16, 0);
  int certified = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    const ConvexSet &S = *sets[random() % sets.size()], &T = *sets[random() % sets.size()];
    const NearPair pair(S, T, random, std::pow(10.0, exponent(random)), 0);
    const DistanceResult one =
        loose.solve({S, pair.first}, {T, pair.second}, metric, ObjectEffects::none, nullptr).distance;
    const DistanceResult other =
        tight.solve({S, pair.first}, {T, pair.second}, metric, ObjectEffects::none, nullptr).distance;
    certified += one.status == DistanceStatus::optimal ? 1 : 0;
    EXPECT_LE(other.upper - other.lower, one.upper - one.lower) << trial;
    EXPECT_NE(other.status, DistanceStatus::iteration_limit) << trial;
  }
  EXPECT_GT(certified, 4000);
}

TEST(PairPromises, TheReportedPlaneSeparatesInPosesThatAreHardlyOrthonormal) {
  Random random(72);
  const auto sets = bodies(random);
  const Ball metric(Vector3d::Zero(), 1);
  ObjectDistanceSolver solver(options(1e-6));
  GrowthDistanceSolver growth(options(1e-6));
  std::uniform_real_distribution<double> exponent(-13.5, -3);
  int tried = 0;
  const auto expect_plane = [&](const ConvexSet& S, const ConvexSet& T, const NearPair& pair,
                                const Vector& n) {
    const Vector3d normal = n;
    const Long u = n.cast<long double>();
    const long double first = u.dot(placed(pair.first, highest(S, pair.first, -normal))),
                      second = u.dot(placed(pair.second, highest(T, pair.second, normal)));
    EXPECT_LT(second, first) << tried;
    ++tried;
  };
  for (int trial = 0; trial < 2000; ++trial) {
    const ConvexSet &S = *sets[random() % sets.size()], &T = *sets[random() % sets.size()];
    const NearPair pair(S, T, random, std::pow(10.0, exponent(random)), 1e-13);
    const DistanceResult& r =
        solver.solve({S, pair.first}, {T, pair.second}, metric, ObjectEffects::none, nullptr).distance;
    if (r.lower > 1e-14) expect_plane(S, T, pair, r.normal);
    const SeparationResult& s = growth.separation({S, pair.first}, {T, pair.second});
    if (s.outcome == Separation::separated && r.lower > 1e-14) expect_plane(S, T, pair, s.normal);
  }
  EXPECT_GT(tried, 3000);
}

void expect_growth(const ConvexSet& S, const ConvexSet& T, const Pose& pose, double sigma) {
  GrowthDistanceSolver solver(options(1e-6));
  ObjectDistanceSolver distance(options(1e-6));
  const DistanceResult& r = solver.solve_about_centers({S, pose}, {T, pose});
  EXPECT_EQ(r.status, DistanceStatus::optimal);
  EXPECT_NEAR(r.upper, sigma, 1e-6);
  EXPECT_LE(r.lower, sigma);
  const auto outcome = sigma < 1 ? Separation::intersecting : Separation::separated;
  EXPECT_EQ(solver.separation({S, pose}, {T, pose}).outcome, outcome);
  const Ball metric(Vector::Zero(S.dimension()), 1);
  const DistanceStatus status =
      distance.solve({S, pose}, {T, pose}, metric, ObjectEffects::none, nullptr).distance.status;
  EXPECT_EQ(status, sigma < 1 ? DistanceStatus::contains_origin : DistanceStatus::optimal);
}

TEST(PairPromises, FlatBodiesInACommonPlaneHaveGrowthDistances) {
  const Pose here(3),
      there(Eigen::AngleAxisd(0.7, Vector3d(1, 2, 2) / 3).toRotationMatrix(), Vector3d(4, 5, 6));
  for (const Pose& pose : {here, there}) {
    const Box box(Vector3d(-1, -1, 0), Vector3d(1, 1, 0));
    expect_growth(box, Box(Vector3d(0, -1, 0), Vector3d(2, 1, 0)), pose, 0.5);
    expect_growth(box, Box(Vector3d(2, -1, 0), Vector3d(4, 1, 0)), pose, 1.5);
    Eigen::Matrix3d one, other;  // triangles in the plane x + y + z = 3
    one << 3, 0, 0, 0, 3, 0, 0, 0, 3;
    other = one;
    other.row(0).array() += 1.5;
    other.row(1).array() -= 1.5;
    expect_growth(PointSet(one), PointSet(other), pose, 0.5);
    Eigen::MatrixXd segment(3, 2), longer(3, 2);
    segment << 0, 1, 0, 2, 0, 3;
    longer << 0.5, 2.5, 1, 5, 1.5, 7.5;
    expect_growth(PointSet(segment), PointSet(longer), pose, 2.0 / 3);
  }
  Eigen::MatrixXd line(2, 2), next(2, 2);
  line << 0, 2, 0, 1;
  next << 1, 5, 0.5, 2.5;
  expect_growth(PointSet(line), PointSet(next), Pose(2), 2.0 / 3);
}

// One square inside another, at quarter coordinates: each query was undecided where it was asked alone.
TEST(PairPromises, ABodyInsideAnotherOverlapsInEveryQuery) {
  Eigen::MatrixXd big(2, 4), small(2, 4);
  big << -1.5, -1.5, 0.5, 0.5, -0.5, 1.5, -0.5, 1.5;
  small << -0.75, -0.75, 0.25, 0.25, -0.25, 0.75, -0.25, 0.75;
  for (const double size : {1.0, 1e9, 1e-9}) {
    const PointSet outer(size * big), inner(size * small);
    EXPECT_EQ(GrowthDistanceSolver(options(1e-6)).separation(outer, inner).outcome, Separation::intersecting);
    EXPECT_NEAR(GrowthDistanceSolver(options(1e-6)).solve_about_centers(outer, inner).upper, 1.0 / 6, 1e-6);
    const Ball metric(Vector::Zero(2), 1);
    EXPECT_EQ(ObjectDistanceSolver(options(1e-6)).solve(outer, inner, metric).distance.status,
              DistanceStatus::contains_origin);
  }
}

TEST(PairPromises, ADifferenceOfOctahedraHoldsTheOrigin) {
  Eigen::MatrixXd octahedron(3, 6);
  octahedron << 1, -1, 0, 0, 0, 0, 0, 0, 1, -1, 0, 0, 0, 0, 0, 0, 1, -1;
  const auto one = std::make_shared<PointSet>(2 * octahedron),
             other = std::make_shared<PointSet>((3 * octahedron).colwise() + Vector3d(-0.5, -0.5, 0));
  const MinkowskiDifference difference(other, one);
  const Ball Q(Vector3d::Zero(), 1);
  for (const auto method :
       {DistanceMethod::newton, DistanceMethod::column_generation, DistanceMethod::zheng_yamane}) {
    DistanceOptions asked;
    asked.method = method;
    EXPECT_EQ(DistanceSolver(asked).solve(difference, Q).status, DistanceStatus::contains_origin);
  }
}

TEST(PairPromises, SumsOfUnlikeSetsHaveTheSameRelativeBoundsAtAnySize) {
  const MinkowskiSum rounded(std::make_shared<Ball>(Vector3d::Zero(), 1.0),
                             std::make_shared<Box>(Vector3d(-1, -1, -1), Vector3d(1, 1, 1)));
  DistanceSolver solver;
  const Vector3d point(3, -2, 5);
  const double at_1 = solver.solve(PointSet(point), rounded).distance;
  for (const double size : {1e-3, 1e-6, 1e-9, 1e-12, 1e-100, 1e6, 1e12}) {
    const DistanceResult& r = solver.solve(PointSet(size * point), rounded);
    EXPECT_EQ(r.status, DistanceStatus::optimal) << size;
    EXPECT_NEAR(r.distance, size * at_1, 2e-6 * size * at_1);
  }
}

}  // namespace
}  // namespace raygauge::test_pair_promises
