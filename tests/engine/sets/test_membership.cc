// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/membership.h"

#include <gtest/gtest.h>

#include <cmath>

#include "raygauge/exceptions.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/cylinder.h"
#include "raygauge/sets/ellipsoid.h"
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

INSTANTIATE_TEST_SUITE_P(Sets, MembershipOfEverySet, ::testing::ValuesIn(set_cases()),
                         [](const auto& tested) { return tested.param.name + std::to_string(tested.index); });

TEST(Membership, IsDecidedAwayFromTheBoundary) {
  const Ball ball(Vector::Constant(3, 2), 1);
  EXPECT_EQ(contains(ball, Vector::Constant(3, 2.5)), Membership::inside);
  EXPECT_EQ(contains(ball, Vector::Constant(3, 2.6)), Membership::outside);
  EXPECT_EQ(contains(ball, Vector::Constant(3, 2)), Membership::inside) << "the centre";
  EXPECT_EQ(contains(ball, Vector{{3, 2, 2}}), Membership::undecided) << "on the boundary";
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
