// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/cone_program.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <memory>
#include <random>

#include "raygauge/exceptions.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::test_cone_program {
namespace {

using Set = std::shared_ptr<const ConvexSet>;

Vector random_vector(std::mt19937_64& random, int n = 3) {
  std::uniform_real_distribution<double> coordinate(-1, 1);
  Vector x(n);
  for (double& value : x) value = coordinate(random);
  return x;
}

/// One of each kind that a ConeProgram knows, about the origin.
std::vector<Set> known_sets(std::mt19937_64& random) {
  Eigen::MatrixXd factor = Eigen::MatrixXd::Identity(3, 3);
  factor.col(0) += random_vector(random) / 2;
  const Vector axis = random_vector(random);
  const Vector half = axis.normalized();
  return {std::make_shared<Ellipsoid>(random_vector(random) / 4, factor),
          std::make_shared<Ball>(random_vector(random) / 4, 1.5),
          std::make_shared<Box>(Vector::Constant(3, -1), Vector::LinSpaced(3, 0.5, 2)),
          std::make_shared<TruncatedCone>(-half, 1.0, half, 0.25)};
}

/// Largest left-hand side.
double violation(ConeProgram& program, double lambda, const Vector& x) {
  Vector y(x.size() + 1);
  y << lambda, x;
  double worst = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < program.constraints(); ++i)
    worst = std::max(worst, program.value(i, y.data(), nullptr));
  return worst;
}

constexpr double kRounding = 1e-13;  // of sets of size 1
constexpr double kBeyond = 1e-3;     // relative to the centre

// s(u) is on the boundary: in the set, and outside when moved away from the centre.
RC_GTEST_PROP(ConeProgram, DescribesTheSetsByTheirSupportPoints, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<unsigned>());
  const Set large = std::make_shared<Ball>(Vector::Zero(3), 100.0);
  for (const Set& set : known_sets(random)) {
    const Vector point = set->support_mapping(random_vector(random));
    const Vector outside = point + kBeyond * (point - set->center());
    ConeProgram as_A({set, large, {}}, "test");
    RC_ASSERT(violation(as_A, 1, point) <= kRounding);
    RC_ASSERT(violation(as_A, 1, outside) > 0);
    ConeProgram as_Q({large, set, {}}, "test");
    for (const double lambda : {0.5, 1.0, 3.0}) {
      RC_ASSERT(violation(as_Q, lambda, lambda * point) <= 10 * kRounding);
      RC_ASSERT(violation(as_Q, lambda, lambda * outside) > 0);
    }
  }
}

RC_GTEST_PROP(ConeProgram, HasTheGradientOfItsConstraints, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<unsigned>());
  constexpr double kStep = 1e-6;
  constexpr double kDifferences = 1e-7;
  const std::vector<Set> sets = known_sets(random);
  for (const Set& A : sets) {
    ConeProgram program({A, sets.back(), {}}, "test");
    Vector y(4), gradient(4);
    y << 1.5, random_vector(random) + Vector::Constant(3, 2);
    for (int i = 0; i < program.constraints(); ++i) {
      program.value(i, y.data(), gradient.data());
      for (int k = 0; k < 4; ++k) {
        Vector above = y, below = y;
        above[k] += kStep;
        below[k] -= kStep;
        const double slope =
            (program.value(i, above.data(), nullptr) - program.value(i, below.data(), nullptr)) / (2 * kStep);
        RC_ASSERT(std::abs(slope - gradient[k]) <= kDifferences);
      }
    }
  }
}

// The nearest point of A is c - c/|c|, and its gauge 4.
TEST(ConeProgram, StartsAtThePointOfATowardsTheOriginWhereTheConstraintsHold) {
  const Vector center = (Vector(3) << 0, 3, 4).finished();
  ConeProgram program({std::make_shared<Ball>(center, 1.0), std::make_shared<Ball>(Vector::Zero(3), 1.0), {}},
                      "test");
  EXPECT_EQ(program.variables(), 4);
  EXPECT_EQ(program.constraints(), 2);
  const Vector start = program.start();
  EXPECT_LT((start.tail(3) - 0.8 * center).norm(), kRounding);
  EXPECT_NEAR(start[0], 4, 1e-5);
  EXPECT_LE(violation(program, start[0], start.tail(3)), kRounding);
}

TEST(ConeProgram, RefusesSetsThatItHasNoConstraintsFor) {
  const Set ball = std::make_shared<Ball>(Vector::Zero(3), 1.0);
  const Set capsule = std::make_shared<Capsule>(Vector::Zero(3), Vector::Ones(3), 1.0);
  const Set flat = std::make_shared<Ellipsoid>(Vector::Zero(3), Eigen::MatrixXd::Identity(3, 2));
  const auto refuses = [](const Set& A, const Set& Q) {
    EXPECT_THROW(ConeProgram({A, Q, {}}, "test"), InvalidParameterError);
  };
  refuses(capsule, ball);
  refuses(ball, capsule);
  refuses(flat, ball);
  refuses(std::make_shared<Ball>(Vector::Zero(3), 0.0), ball);
  EXPECT_THROW(ConeProgram({ball, std::make_shared<Ball>(Vector::Zero(2), 1.0), {}}, "test"),
               DimensionMismatchError);
}

}  // namespace
}  // namespace raygauge::test_cone_program
