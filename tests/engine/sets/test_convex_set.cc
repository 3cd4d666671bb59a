// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/convex_set.h"

#include <gtest/gtest.h>

#include <limits>

#include "raygauge/exceptions.h"

namespace raygauge::test_convex_set {
namespace {

// {x : |x| <= radius}.
class Ball final : public ConvexSet {
 public:
  Ball(int dimension, double radius) : ConvexSet(dimension), radius_(radius) {}

 private:
  double do_support(const double* u, double* point) const override {
    const double length = Eigen::Map<const Eigen::VectorXd>(u, dimension()).norm();
    for (int k = 0; k < dimension(); ++k) point[k] = length > 0 ? radius_ / length * u[k] : 0.0;
    return radius_ * length;
  }
  void do_center(double* point) const override { Vector::Map(point, dimension()).setZero(); }

  double radius_;
};

TEST(ConvexSet, IsDefinedByItsSupportAndItsCenter) {
  const Ball ball(2, 5);
  const Vector u = (Vector(2) << 3, 4).finished();
  EXPECT_EQ(ball.support_function(u), 25);
  EXPECT_EQ(ball.support_mapping(u), u);
  EXPECT_EQ(ball.center(), Vector::Zero(2));
  EXPECT_EQ(ball.support_function(Vector::Zero(2)), 0);
}

TEST(ConvexSet, RefusesADirectionOfAnotherDimension) {
  const Ball ball(3, 1);
  EXPECT_THROW(ball.support_function(Vector::Ones(2)), DimensionMismatchError);
  EXPECT_THROW(ball.support_mapping(Vector::Ones(4)), DimensionMismatchError);
}

TEST(ConvexSet, RefusesADirectionThatIsNotFinite) {
  const Ball ball(2, 1);
  Vector u = Vector::Ones(2);
  u[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(ball.support_function(u), NonFiniteError);
  u[1] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(ball.support_mapping(u), NonFiniteError);
}

TEST(ConvexSet, RefusesToLiveInNoDimension) { EXPECT_THROW(Ball(0, 1), InvalidParameterError); }

}  // namespace
}  // namespace raygauge::test_convex_set
