// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A caller's mistake is an exception of its own type whose message names the set, the parameter and the
// reason.
#include <gtest/gtest.h>

#include <limits>

#include "raygauge/exceptions.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/convex_set.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/p_norm_ball.h"
#include "raygauge/sets/polytopes.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::test_set_parameters {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const Vector kOrigin = Vector::Zero(2), kOne = Vector::Ones(2), kOrigin3 = Vector::Zero(3);
const Vector kBroken = (Vector(2) << 0, kNaN).finished();

std::shared_ptr<const ConvexSet> unit_ball(int n) { return std::make_shared<Ball>(Vector::Zero(n), 1); }

// The message of the Expected that `action` throws; whatever else it does fails the test.
template <class Expected, class Action>
std::string message_of(Action&& action) {
  try {
    action();
  } catch (const Expected& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

TEST(SetParameters, ANegativeRadiusIsRefusedByName) {
  using E = InvalidParameterError;
  EXPECT_EQ(message_of<E>([] { Ball(kOrigin, -1); }), "ball: radius must not be negative, got -1");
  EXPECT_EQ(message_of<E>([] { Capsule(kOrigin, kOne, -1); }),
            "capsule: radius must not be negative, got -1");
  EXPECT_EQ(message_of<E>([] { Cylinder(kOrigin, kOne, -2); }),
            "cylinder: radius must not be negative, got -2");
  EXPECT_EQ(message_of<E>([] { TruncatedCone(kOrigin, 1, kOne, -1); }),
            "truncated cone: top_radius must not be negative, got -1");
  EXPECT_EQ(message_of<E>([] { PNormBall(kOrigin, -kOne, 2); }),
            "p-norm ball: coordinate 0 of semi_axes must not be negative, got -1");
}

TEST(SetParameters, AnExponentBelowOneIsRefused) {
  EXPECT_EQ(message_of<InvalidParameterError>([] { PNormBall(kOrigin, kOne, 0.5); }),
            "p-norm ball: p must be at least 1, got 0.5");
  EXPECT_THROW(PNormBall(kOrigin, kOne, kNaN), NonFiniteError);
  EXPECT_NO_THROW(PNormBall(kOrigin, kOne, kInfinity));
}

TEST(SetParameters, ASingularMapIsRefusedAndAnIllScaledOneIsNot) {
  const auto image = [](const Eigen::MatrixXd& M) { AffineImage(unit_ball(2), M, kOrigin); };
  const Eigen::MatrixXd rank_1 = (Eigen::MatrixXd(2, 2) << 0.1, 0.2, 0.3, 0.6).finished();
  EXPECT_EQ(message_of<InvalidParameterError>([&] { image(rank_1); }),
            "affine image: M must be invertible, but it is singular");
  EXPECT_THROW(image(Eigen::MatrixXd::Zero(2, 2)), InvalidParameterError);
  const Vector apart = (Vector(2) << 1e150, 1e-150).finished();
  EXPECT_NO_THROW(image(apart.asDiagonal().toDenseMatrix()));
}

TEST(SetParameters, ARigidMotionMustBeARotation) {
  const auto rigid = [](const Eigen::MatrixXd& R) { AffineImage::rigid(unit_ball(2), R, kOrigin); };
  EXPECT_THROW(rigid(2 * Eigen::MatrixXd::Identity(2, 2)), InvalidParameterError);
  EXPECT_THROW(rigid((Eigen::MatrixXd(2, 2) << 1, 0, 0, -1).finished()), InvalidParameterError);
  EXPECT_NO_THROW(rigid((Eigen::MatrixXd(2, 2) << 0, -1, 1, 0).finished()));
}

TEST(SetParameters, AnAxisWithoutLengthIsRefused) {
  EXPECT_EQ(message_of<InvalidParameterError>([] { Cylinder(kOne, kOne, 1); }),
            "cylinder: the two ends of the axis must not coincide");
  EXPECT_THROW(TruncatedCone(kOne, 1, kOne, 0), InvalidParameterError);
}

TEST(SetParameters, CornersInTheWrongOrderAreRefused) {
  EXPECT_EQ(message_of<InvalidParameterError>([] { Box(kOne, kOrigin); }),
            "box: coordinate 0 of lower, 1, must not exceed that of upper, 0");
  EXPECT_EQ(
      message_of<InvalidParameterError>([] { Box(3e-9 * kOne, 2e-9 * kOne); }),  // small ones are legible
      "box: coordinate 0 of lower, 3e-9, must not exceed that of upper, 2e-9");
}

TEST(SetParameters, DimensionsMustAgree) {
  using E = DimensionMismatchError;
  EXPECT_EQ(message_of<E>([] { Box(kOrigin, kOrigin3); }),
            "box: upper has dimension 3, the set lives in R^2");
  EXPECT_THROW(Simplex(kOrigin, kOrigin3), E);
  EXPECT_THROW(Capsule(kOrigin, kOrigin3, 1), E);
  EXPECT_THROW(Cylinder(kOrigin, kOrigin3, 1), E);
  EXPECT_THROW(TruncatedCone(kOrigin, 1, kOrigin3, 1), E);
  EXPECT_THROW(PNormBall(kOrigin, kOrigin3, 2), E);
  EXPECT_THROW(Ellipsoid(kOrigin, Eigen::MatrixXd::Identity(3, 3)), E);
  EXPECT_THROW(AffineImage(unit_ball(2), Eigen::MatrixXd::Identity(3, 3), kOrigin), E);
  EXPECT_THROW(AffineImage(unit_ball(2), Eigen::MatrixXd::Identity(2, 2), kOrigin3), E);
  EXPECT_THROW(MinkowskiSum(unit_ball(2), unit_ball(3)), E);
  EXPECT_THROW(MinkowskiDifference(unit_ball(2), unit_ball(3)), E);
  EXPECT_THROW(UnionHull({unit_ball(2), unit_ball(3)}), E);
}

TEST(SetParameters, NothingButFiniteNumbersIsAccepted) {
  using E = NonFiniteError;
  EXPECT_EQ(message_of<E>([] { Ball(kBroken, 1); }),
            "ball: coordinate 1 of center must be a finite number, got nan");
  EXPECT_EQ(message_of<E>([] { Ball(kOrigin, kInfinity); }), "ball: radius must be a finite number, got inf");
  EXPECT_THROW(Box(kBroken, kOne), E);
  EXPECT_THROW(Simplex(kOrigin, kBroken), E);
  EXPECT_THROW(Capsule(kBroken, kOne, 1), E);
  EXPECT_THROW(Cylinder(kOrigin, kBroken, 1), E);
  EXPECT_THROW(TruncatedCone(kOrigin, kNaN, kOne, 1), E);
  EXPECT_THROW(PNormBall(kBroken, kOne, 2), E);
  EXPECT_THROW(Ellipsoid(kOrigin, kBroken), E);
  EXPECT_THROW(AffineImage(unit_ball(2), kNaN * Eigen::MatrixXd::Identity(2, 2), kOrigin), E);
}

TEST(SetParameters, NothingLivesInNoDimension) {
  const Vector none(0);
  EXPECT_THROW(Ball(none, 1), InvalidParameterError);
  EXPECT_THROW(Box(none, none), InvalidParameterError);
  EXPECT_THROW(Cylinder(none, none, 1), InvalidParameterError);
}

TEST(SetParameters, ACombinatorNeedsItsOperands) {
  EXPECT_EQ(message_of<InvalidParameterError>([] { MinkowskiSum(unit_ball(2), nullptr); }),
            "Minkowski sum: B must not be a null pointer");
  EXPECT_THROW(MinkowskiDifference(nullptr, unit_ball(2)), InvalidParameterError);
  EXPECT_THROW(AffineImage(nullptr, Eigen::MatrixXd::Identity(2, 2), kOrigin), InvalidParameterError);
  EXPECT_THROW(UnionHull({unit_ball(2), nullptr}), InvalidParameterError);
  EXPECT_THROW(UnionHull({}), EmptySetError);
}

TEST(SetParameters, AnEllipsoidNeedsAColumn) {
  EXPECT_THROW(Ellipsoid(kOrigin, Eigen::MatrixXd(2, 0)), InvalidParameterError);
}

TEST(SetParameters, GrossMistakesOfAMappingAreFoundAtOnce) {
  const auto origin = [](const double*, double* point) { std::fill_n(point, 2, 0.0); };
  const auto nowhere = [](const double*, double* point) { std::fill_n(point, 2, kNaN); };
  EXPECT_NO_THROW(SupportMappingSet(kOrigin, origin));
  EXPECT_THROW(SupportMappingSet(kOne, origin), InvalidParameterError);
  EXPECT_THROW(SupportMappingSet(kOrigin, nowhere), NonFiniteError);
  EXPECT_THROW(SupportMappingSet(kOrigin, nullptr), InvalidParameterError);
}

}  // namespace
}  // namespace raygauge::test_set_parameters
