// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Every exact_distance of the smooth hard families, held to the gauge of the very doubles that the sets are
// made of, in 100 digits.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "generators/hard/similarities.h"
#include "raygauge/exceptions.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "tests/generators/hard/smooth_truth.h"
#include "tests/generators/points_of.h"
#include "tests/hard/hard_cases.h"

namespace raygauge::test_smooth_distances {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class SmoothDistance : public testing::TestWithParam<HardCase> {};

TEST_P(SmoothDistance, IsTheGaugeOfTheEmittedDoubles) {
  constexpr int kRepetitions = 3, kLargestDimension = 50;
  const Real kDigits("1e-60");  // of the 100 that a few hundred operations leave
  const HardCase& tested = GetParam();
  for (const int n : dimensions_of(tested, kLargestDimension)) {
    for (int repetition = 0; repetition < kRepetitions; ++repetition) {
      SCOPED_TRACE("n = " + std::to_string(n) + ", repetition " + std::to_string(repetition));
      const Instance instance = generate(tested.generator, {5, n, 1, repetition}, tested.parameters);
      ASSERT_TRUE(instance.exact_distance.has_value());
      const double claimed = *instance.exact_distance;
      const Real truth = smooth_distance(*instance.A, *instance.Q);
      if (std::isinf(claimed) || claimed == 0) {
        EXPECT_EQ(truth, claimed);
      } else if (tested.rounded) {
        EXPECT_LT(truth, std::nextafter(claimed, kInfinity));
        EXPECT_GT(truth, std::nextafter(claimed, 0.0));
      } else {
        EXPECT_LT(abs(truth - claimed), kDigits * claimed) << claimed;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Families, SmoothDistance, testing::ValuesIn(smooth_hard_cases()),
                         [](const auto& test) { return label(test.param); });

TEST(IntegerSimilarity, IsAnIntegerMultipleOfAnOrthogonalMatrix) {
  for (const int n : {1, 2, 3, 7, 50}) {
    RandomStream stream({1, n, 1, 0}, "similarity", RandomPurpose::shape);
    const Eigen::MatrixXd M = integer_similarity(stream, n, 4);
    EXPECT_EQ(M, M.array().round().matrix());
    EXPECT_EQ(M.transpose() * M, 390625 * Eigen::MatrixXd::Identity(n, n));  // 25^4
  }
}

TEST(HalfPlane, HasTwoOrthogonalVectorsOfTheLengthItStates) {
  for (const int n : {2, 3, 8}) {
    RandomStream stream({1, n, 1, 0}, "half plane", RandomPurpose::shape);
    const HalfPlane plane = random_half_plane(stream, n, 3, 2);
    EXPECT_EQ(plane.unit, 3125);
    EXPECT_EQ(plane.along.squaredNorm(), plane.unit * plane.unit);
    EXPECT_EQ(plane.across.squaredNorm(), plane.unit * plane.unit);
    EXPECT_EQ(plane.along.dot(plane.across), 0);
  }
}

TEST(HardEllipsoid, IsTurnedAndHasTheAspectAskedFor) {
  const Instance instance = generate("hard_ellipsoid", {1, 8, 1, 0}, {{"aspect", 1e8}});
  const Eigen::MatrixXd& L = dynamic_cast<const Ellipsoid&>(*instance.Q).factor();
  const Vector axes = L.colwise().norm();
  EXPECT_DOUBLE_EQ(axes.maxCoeff() / axes.minCoeff(), 1e8);
  EXPECT_GT((L.array() != 0).count(), 16);
}

TEST(HardNearAxis, HasItsPointAsNearToTheAxisAsAskedFor) {
  const Instance instance = generate("hard_near_axis", {1, 5, 1, 0},
                                     {{"body", std::string("capsule")}, {"object", std::string("point")}});
  const auto& Q = dynamic_cast<const Capsule&>(*instance.Q);
  const Vector axis = Q.q() - Q.p(), point = points_of(instance.A);
  const Vector across = point - point.dot(axis) / axis.squaredNorm() * axis;
  EXPECT_NEAR(across.norm() / point.norm(), 0.5e-8, 0.3e-8);
}

TEST(HardTangentDisc, IsOutOfReachOnItsTangent) {
  const Instance instance = generate("hard_tangent_disc", {1, 3, 1, 0}, {{"epsilon", 0.0}});
  EXPECT_EQ(instance.exact_distance, kInfinity);
  EXPECT_EQ(points_of(instance.A).col(0).dot(instance.Q->center()), 0);
}

TEST(SmoothFamilies, RefuseALineAndExponentsThatAreNone) {
  for (const char* name : {"hard_tangent_disc", "hard_p_norm_ball", "hard_ellipsoid", "hard_truncated_cone",
                           "hard_capsule", "hard_near_axis"}) {
    EXPECT_THROW(generate(name, {1, 1, 1, 0}), InvalidParameterError) << name;
  }
  EXPECT_THROW(generate("hard_p_norm_ball", {1, 2, 1, 0}, {{"p", 0.5}}), InvalidParameterError);
  EXPECT_THROW(generate("hard_truncated_cone", {1, 2, 1, 0}, {{"shape", std::string("ball")}}),
               UnknownNameError);
}

}  // namespace
}  // namespace raygauge::test_smooth_distances
