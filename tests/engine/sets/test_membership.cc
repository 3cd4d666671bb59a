// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/membership.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "raygauge/exceptions.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/truncated_cone.h"
#include "tests/engine/sets/set_cases.h"

namespace raygauge::test_membership {
namespace {

class MembershipOfEverySet : public ::testing::TestWithParam<SetCase> {};

// Points of the set are never outside, and points that are provably farther away than rounding never inside.
// A sample is a point of the set but for its own rounding, and is drawn inside by more than that.
TEST_P(MembershipOfEverySet, ContainsItsPointsAndNothingElse) {
  const SetCase& tested = GetParam();
  Random random(3);
  const Vector center = tested.set->center();
  for (int i = 0; i < 5; ++i) {
    const Vector x = center + (1 - 1e-13) * (tested.sample(random) - center);
    EXPECT_NE(contains(*tested.set, x), Membership::outside);
    const Vector away = center + 3 * (x - center) + Vector::Constant(x.size(), 0.1);
    if (tested.excess(away) > 1e-6) {
      EXPECT_NE(contains(*tested.set, away), Membership::inside);
    }
  }
}

// Many points at once, on one thread and on three: what single calls say, but that more may be decided.
TEST_P(MembershipOfEverySet, OfManyPointsIsThatOfEach) {
  const SetCase& tested = GetParam();
  const int n = tested.set->dimension();
  Random random(4);
  const Vector center = tested.set->center();
  Eigen::MatrixXd X(n, as_point_set(*tested.set) != nullptr ? 6 * n : 13);
  for (Eigen::Index i = 0; i < X.cols(); ++i)
    X.col(i) = center + 0.3 * static_cast<double>(1 + i % 6) * (tested.sample(random) - center);
  const PointsOptions three{1e-6, 3, {}};
  const std::vector<Membership> found = memberships(*tested.set, X);
  EXPECT_EQ(memberships(*tested.set, X, three), found);
  const std::vector<GaugeBounds> bounds = gauges(*tested.set, X, three);
  for (Eigen::Index i = 0; i < X.cols(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Membership alone = contains(*tested.set, X.col(i));
    if (alone != Membership::undecided) {
      EXPECT_EQ(found[at], alone) << i;
    }
    const GaugeBounds single = gauge(*tested.set, X.col(i));
    EXPECT_LE(bounds[at].lower, single.upper);
    EXPECT_GE(bounds[at].upper, single.lower);
  }
}

INSTANTIATE_TEST_SUITE_P(Sets, MembershipOfEverySet, ::testing::ValuesIn(set_cases()),
                         [](const auto& tested) { return tested.param.name + std::to_string(tested.index); });

TEST(Membership, IsDecidedAwayFromTheBoundary) {
  const Ball ball(Vector::Constant(3, 2), 1);
  EXPECT_EQ(contains(ball, Vector::Constant(3, 2.5)), Membership::inside);
  EXPECT_EQ(contains(ball, Vector::Constant(3, 2.6)), Membership::outside);
  EXPECT_EQ(contains(ball, Vector::Constant(3, 2)), Membership::inside) << "the centre";
  EXPECT_EQ(contains(ball, Vector{{3, 2, 2}}), Membership::undecided) << "on the boundary";
}

// Points of a lattice around a cube of integers that is far from the origin: on the faces, just inside and
// just outside. The cube's coordinates are exact, and so is the question.
TEST(Memberships, AreRightNextToTheFacesOfACube) {
  for (const double place : {0.0, 1e3, 0x1p40}) {
    Eigen::MatrixXd corners(3, 8);
    for (int j = 0; j < 8; ++j)
      corners.col(j) = Vector{{place + (j & 1), place + (j >> 1 & 1), (j >> 2) / 3.0}};
    const PointSet cube(corners);
    const double ulp = std::nextafter(place + 1, 1e300) - (place + 1);
    const std::vector<double> levels = {place - 1,   place - ulp,     place,
                                        place + ulp, place + 0.5,     place + 1 - ulp,
                                        place + 1,   place + 1 + ulp, place + 2};
    Eigen::MatrixXd X(3, 81 * 5);
    std::vector<bool> is_in(81 * 5);
    for (int i = 0; i < 81 * 5; ++i) {
      X.col(i) = Vector{{levels[static_cast<std::size_t>(i % 9)], levels[static_cast<std::size_t>(i / 9 % 9)],
                         (i / 81 - 1) / 9.0}};
      const auto within = [&](int k) { return X(k, i) >= place && X(k, i) <= place + 1; };
      is_in[static_cast<std::size_t>(i)] = within(0) && within(1) && X(2, i) >= 0;
    }
    const std::vector<Membership> found = memberships(cube, X);
    int decided = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      decided += found[i] == Membership::undecided ? 0 : 1;
      EXPECT_NE(found[i], is_in[i] ? Membership::outside : Membership::inside)
          << place << ": " << X.col(static_cast<Eigen::Index>(i)).transpose();
    }
    EXPECT_GE(decided, 150);  // those away from all faces, at least
  }
}

// Many points, of which a sample may or may not have the corners: the hull is a cube, in numbers without
// rounding.
TEST(Memberships, OfAHullOfManyPointsAreRightOnAnyNumberOfThreads) {
  Random random(8);
  const auto eighths = [&](int from, int to) {
    return 0.125 *
           static_cast<double>(from + static_cast<int>(random() % static_cast<unsigned>(to - from + 1)));
  };
  for (const bool corners_first : {true, false}) {
    Eigen::MatrixXd P(3, 608), X(3, 3000);
    for (double& x : P.reshaped()) x = eighths(0, 16);
    for (Eigen::Index j = 0; j < 8; ++j)
      P.col(corners_first ? 4 * j : 600 + j) =
          2 * Vector{{double(j & 1), double(j >> 1 & 1), double(j >> 2)}};
    for (double& x : X.reshaped()) x = eighths(-6, 22);
    const PointSet cube(P);
    const std::vector<Membership> found = memberships(cube, X);
    int inside = 0, decided = 0;
    for (Eigen::Index i = 0; i < X.cols(); ++i) {
      const Membership answer = found[static_cast<std::size_t>(i)];
      const bool is_in = X.col(i).minCoeff() >= 0 && X.col(i).maxCoeff() <= 2;
      const bool at_face = is_in && (X.col(i).minCoeff() == 0 || X.col(i).maxCoeff() == 2);
      EXPECT_NE(answer, is_in ? Membership::outside : Membership::inside) << X.col(i).transpose();
      EXPECT_TRUE(answer != Membership::undecided || at_face) << X.col(i).transpose();
      inside += is_in ? 1 : 0;
      decided += answer != Membership::undecided ? 1 : 0;
    }
    EXPECT_GT(inside, 300);
    EXPECT_LT(inside, 2700);
    EXPECT_GT(decided, 2500);
    EXPECT_EQ(memberships(cube, X, {1e-6, 3, {}}), found);
  }
}

TEST(Memberships, EndWhenAskedTo) {
  const Eigen::MatrixXd X = Eigen::MatrixXd::Random(3, 100);
  const std::vector<Membership> found =
      memberships(Ball(Vector::Zero(3), 1), X, {1e-6, 2, [] { return true; }});
  EXPECT_EQ(std::count(found.begin(), found.end(), Membership::undecided), 100);
  EXPECT_THROW(gauges(Ball(Vector::Zero(2), 1), X), DimensionMismatchError);
  EXPECT_THROW(gauges(Ball(Vector::Zero(3), 1), X, {2.0, 1, {}}), InvalidParameterError);
}

TEST(Gauge, HasTheClosedFormWithinItsBounds) {
  const Vector x{{3, 4, 0}};
  const GaugeBounds of_ball = gauge(Ball(Vector::Zero(3), 2), x);
  EXPECT_LE(of_ball.lower, 2.5);
  EXPECT_GE(of_ball.upper, 2.5);
  EXPECT_LE(of_ball.upper - of_ball.lower, 1e-9 * of_ball.upper);
  const Cylinder cylinder(Vector{{-1, 0, 0}}, Vector{{2, 0, 0}}, 0.5);
  const GaugeBounds by_side = gauge(cylinder, Vector{{1, 2, 0}}),
                    by_disc = gauge(cylinder, Vector{{6, 1, 0}});
  EXPECT_NEAR(by_side.lower, 4, 4e-9);
  EXPECT_NEAR(by_side.upper, 4, 4e-9);
  EXPECT_NEAR(by_disc.upper, 3, 3e-9);
}

TEST(Gauge, IsInfiniteWhereNoMultipleReaches) {
  const GaugeBounds bounds = gauge(Ball(Vector{{2, 0}}, 1), Vector{{-1, 0}});
  EXPECT_TRUE(std::isinf(bounds.lower));
  EXPECT_TRUE(std::isinf(bounds.upper));
}

TEST(Gauge, RefusesWhatIsNoPointOfTheSpace) {
  const Ball ball(Vector::Zero(3), 1);
  EXPECT_THROW(gauge(ball, Vector::Zero(2)), DimensionMismatchError);
  EXPECT_THROW(contains(ball, Vector::Constant(3, std::nan(""))), NonFiniteError);
  EXPECT_THROW(gauge(ball, Vector::Ones(3), 0), InvalidParameterError);
}

}  // namespace
}  // namespace raygauge::test_membership
