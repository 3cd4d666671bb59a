// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/libsvm_method.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "raygauge/exceptions.h"
#include "raygauge/queries/solver.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {
namespace {

using SetPointer = std::shared_ptr<const ConvexSet>;

std::unique_ptr<SolveMethod> libsvm(const Parameters& parameters = {}) {
  MethodRegistry registry("method");
  register_libsvm_methods(registry);
  return registry.make("libsvm_smo", parameters);
}

SetPointer cloud(int n, int N, double offset, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd points = Eigen::MatrixXd::NullaryExpr(n, N, [&] { return normal(random); });
  points.row(0).array() += offset;
  return std::make_shared<PointSet>(points);
}

Instance between(const SetPointer& A2, const SetPointer& A1, double radius) {
  Instance instance;
  instance.A = std::make_shared<MinkowskiDifference>(A2, A1);
  instance.Q = std::make_shared<Ball>(Vector::Zero(A2->dimension()), radius);
  return instance;
}

TEST(LibsvmMethod, AgreesWithTheEngineToItsTolerance) {
  for (const int n : {2, 5, 20}) {
    const Instance instance = between(cloud(n, 40, 9, 1), cloud(n, 30, 0, 2), 2);
    const auto method = libsvm();
    method->load(instance);
    method->solve({1e-7});
    const DistanceResult claim = method->result();
    const double truth = DistanceSolver().solve(*instance.A, *instance.Q).distance;
    EXPECT_EQ(claim.status, DistanceStatus::optimal) << n;
    EXPECT_NEAR(claim.distance, truth, 1e-5 * truth) << n;
    EXPECT_LE(claim.lower, truth * (1 + 1e-6)) << n;
    EXPECT_GE(claim.upper, truth * (1 - 1e-6)) << n;
    EXPECT_LT(claim.upper - claim.lower, 1e-5 * truth) << n;
  }
}

TEST(LibsvmMethod, ItsOwnToleranceGivesFewerDigits) {
  const Instance instance = between(cloud(10, 300, 9, 3), cloud(10, 300, 0, 4), 1);
  const auto loose = libsvm({{"eps", 0.1}});
  loose->load(instance);
  loose->solve({1e-7});
  const auto tight = libsvm();
  tight->load(instance);
  tight->solve({1e-7});
  EXPECT_GT(loose->result().upper - loose->result().lower,
            10 * (tight->result().upper - tight->result().lower));
}

TEST(LibsvmMethod, TakesOnePointSetToo) {
  Instance instance;
  Eigen::MatrixXd points(2, 3);
  points << 3, 3, 5, 1, -1, 0;
  instance.A = std::make_shared<PointSet>(points);
  instance.Q = std::make_shared<Ball>(Vector::Zero(2), 1.0);
  const auto method = libsvm();
  method->load(instance);
  method->solve({1e-8});
  EXPECT_NEAR(method->result().distance, 3, 1e-6);
}

TEST(LibsvmMethod, RefusesOtherSets) {
  const SetPointer points = cloud(2, 5, 9, 1);
  const auto box = std::make_shared<Box>(-Vector::Ones(2), Vector::Ones(2));
  Instance instance = between(points, points, 1);
  instance.Q = box;
  EXPECT_THROW(libsvm()->load(instance), InvalidParameterError);
  EXPECT_THROW(libsvm()->load(between(points, box, 1)), InvalidParameterError);
  EXPECT_THROW(libsvm()->solve({}), Error);
}

}  // namespace
}  // namespace raygauge
