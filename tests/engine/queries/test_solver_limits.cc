// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "raygauge/exceptions.h"
#include "raygauge/methods/options.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/polytopes.h"
#include "tests/engine/both_methods.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_solver_limits {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class Limits : public BothMethods {
 protected:
  Limits() {
    Random random(121);
    // So many that a sample is solved first: a set that is priced whole may be done before the clock is read.
    Eigen::MatrixXd a = sphere_points(10, 8000, random);
    a.row(0).array() += 3;
    A_ = std::make_unique<PointSet>(a);
    Q_ = std::make_unique<PointSet>(sphere_points(10, 8000, random));
    truth_ = DistanceSolver(options(1e-12)).solve(*A_, *Q_);
  }

  // The bounds of a solve that was cut short hold all the same.
  void expect_honest(const DistanceResult& result) const {
    EXPECT_LE(result.lower, truth_.upper);
    EXPECT_GE(result.upper, truth_.lower);
    EXPECT_LE(result.lower, result.distance);
    EXPECT_LE(result.distance, result.upper);
  }

  std::unique_ptr<PointSet> A_;
  std::unique_ptr<PointSet> Q_;
  DistanceResult truth_;
};
RAYGAUGE_BOTH_METHODS(Limits);

TEST_P(Limits, OnIterationsLeaveHonestBounds) {
  for (const std::int64_t limit : {1, 2, 5, 10, 15}) {
    DistanceOptions limited = options(1e-9);
    limited.max_iterations = limit;
    const DistanceResult result = DistanceSolver(limited).solve(*A_, *Q_);
    EXPECT_EQ(result.status, DistanceStatus::iteration_limit) << "limit " << limit;
    expect_honest(result);
  }
}

TEST_P(Limits, OnTimeLeaveHonestBounds) {
  for (const double limit : {0.0, 1e-9}) {
    DistanceOptions limited = options(1e-9);
    limited.time_limit = limit;
    const DistanceResult result = DistanceSolver(limited).solve(*A_, *Q_);
    EXPECT_EQ(result.status, DistanceStatus::time_limit);
    EXPECT_GE(result.seconds, 0);
    expect_honest(result);
  }
}

TEST_P(Limits, ThatAreNotReachedChangeNothing) {
  DistanceOptions generous = options(1e-12);
  generous.time_limit = 1e6;
  generous.max_iterations = 1000000;
  const DistanceResult result = DistanceSolver(generous).solve(*A_, *Q_);
  EXPECT_EQ(result.status, DistanceStatus::optimal);
  EXPECT_EQ(result.lower, truth_.lower);
  EXPECT_EQ(result.upper, truth_.upper);
  EXPECT_GT(result.seconds, 0);
  EXPECT_TRUE(std::isnan(truth_.seconds));  // the clock is not read unless a limit asks for it
}

// A point of A on the ray of one of Q: 3 times it, whatever the others are.
TEST(LimitsOfPointSets, LeaveTheUpperBoundOfACommonRay) {
  Random random(34);
  for (const int n : {16, 60}) {
    Eigen::MatrixXd a = integer_points(n, n + 2, 10, random);
    const Eigen::MatrixXd q = integer_points(n, n + 2, 10, random);
    a.col(5) = 3 * q.col(9);
    DistanceOptions options;
    options.method = DistanceMethod::column_generation;
    options.time_limit = 0;
    const DistanceResult result = DistanceSolver(options).solve(PointSet(a), PointSet(q));
    EXPECT_EQ(result.status, DistanceStatus::time_limit);
    EXPECT_LE(result.lower, 3) << n;
    EXPECT_EQ(result.upper, std::nextafter(3.0, 4.0)) << n;
  }
}

// A support query of an H-polytope is a linear program: the clock is looked at after each.
TEST(LimitsOfGeneralSets, EndRaysAfterEachDearSupportQuery) {
  Random random(7);
  Eigen::MatrixXd normals = gaussian_points(12, 40, random);
  normals.colwise().normalize();
  const Vector distances = Vector::Ones(40);
  const HPolytope Q(normals.transpose(), distances);
  const HPolytope A(normals.transpose(), distances + 6 * normals.row(0).transpose());
  DistanceOptions options;
  options.method = DistanceMethod::zheng_yamane;
  DistanceSolver solver(options);
  int asked = 0;
  solver.set_stop([&asked] { return ++asked > 5; });
  const DistanceResult& result = solver.solve(A, Q);
  EXPECT_EQ(result.status, DistanceStatus::time_limit);
  EXPECT_LE(result.counters.ray_iterations, 10);
}

// Quadruple precision in R^200 takes longer than that: it is not begun, and what doubles have proven stays.
TEST(LimitsOfGeneralSets, KeepWhatDoublesHaveProven) {
  Random random(8);
  const int n = 200;
  const Eigen::MatrixXd F = Eigen::MatrixXd::Identity(n, n) + gaussian_points(n, n, random) / 15;
  const Ellipsoid A(8 * Vector::Unit(n, 0) + 8 * Vector::Unit(n, 1), F);
  const Ellipsoid Q(Vector::Zero(n), Eigen::MatrixXd::Identity(n, n) + gaussian_points(n, n, random) / 20);
  DistanceOptions options;
  options.tolerance = 1e-15;
  options.time_limit = 0.2;
  const DistanceResult result = DistanceSolver(options).solve(A, Q);
  EXPECT_NE(result.status, DistanceStatus::optimal);
  EXPECT_LT(result.upper, kInfinity);
}

// No time for quadruple precision: what it has proven of the pair before says nothing.
TEST(LimitsOfGeneralSets, DoNotBringBackTheBoundsOfThePairBefore) {
  const int n = 60;
  const Ball Q(Vector::Zero(n), 1.0);
  DistanceOptions options;
  options.method = DistanceMethod::column_generation;
  options.tolerance = 1e-17;
  DistanceSolver solver(options);
  const double first = solver.solve(Ball(Vector::Ones(n), 0.3), Q).distance;
  options.time_limit = 0.03;
  solver.set_options(options);
  const DistanceResult& result = solver.solve(Ball(3 * Vector::Ones(n), 0.3), Q);
  EXPECT_GT(result.upper, 2 * first);
  EXPECT_LE(result.lower, 3 * std::sqrt(n) - 0.3 + 1e-12);
  EXPECT_GE(result.upper, 3 * std::sqrt(n) - 0.3 - 1e-12);
}

TEST(DistanceSolverOptions, OutsideTheirRangeAreRefused) {
  const auto refuses = [](const auto& change) {
    DistanceOptions options;
    change(options);
    EXPECT_THROW(DistanceSolver{options}, InvalidParameterError);
    DistanceSolver solver;
    EXPECT_THROW(solver.set_options(options), InvalidParameterError);
  };
  for (const double tolerance : {0.0, -1e-6, 1.0, kInfinity, std::nan("")}) {
    refuses([&](DistanceOptions& options) { options.tolerance = tolerance; });
  }
  for (const double limit : {-1.0, -kInfinity, std::nan("")}) {
    refuses([&](DistanceOptions& options) { options.time_limit = limit; });
  }
  refuses([](DistanceOptions& options) { options.max_iterations = -1; });
  refuses([](DistanceOptions& options) { options.stop_rule = StopRule::published_sigma; });
}

TEST(DistanceSolverOptions, SayInOneLineWhatIsWrong) {
  EXPECT_EQ(validate(DistanceOptions{}), "");
  const auto problem = [](const auto& change) {
    DistanceOptions options;
    change(options);
    return validate(options);
  };
  EXPECT_EQ(problem([](auto& options) { options.tolerance = -1e-9; }),
            "tolerance must lie in (0, 1), got -1e-9");
  EXPECT_EQ(problem([](auto& options) { options.tolerance = std::nan(""); }),
            "tolerance must lie in (0, 1), got nan");
  EXPECT_EQ(problem([](auto& options) { options.max_iterations = -2; }),
            "max_iterations must not be negative, got -2");
  EXPECT_EQ(problem([](auto& options) { options.time_limit = -0.5; }),
            "time_limit must not be negative, got -0.5");
  EXPECT_EQ(problem([](auto& options) { options.threads = 65; }), "threads must lie in 1 … 64, got 65");
  EXPECT_EQ(problem([](auto& options) { options.stop_rule = StopRule::published_sigma; }),
            "stop_rule published_sigma belongs to method zheng_yamane");
  try {
    DistanceOptions options;
    options.tolerance = 2;
    DistanceSolver solver(options);
    FAIL() << "not refused";
  } catch (const InvalidParameterError& error) {
    EXPECT_STREQ(error.what(), "tolerance must lie in (0, 1), got 2");
  }
}

TEST(DistanceSolverOptions, ThatAreRefusedLeaveTheSolverAsItWas) {
  DistanceSolver solver;
  DistanceOptions bad;
  bad.tolerance = 2;
  EXPECT_THROW(solver.set_options(bad), InvalidParameterError);
  EXPECT_EQ(solver.options().tolerance, DistanceOptions{}.tolerance);
  EXPECT_EQ(solver.solve(PointSet(Vector::Ones(2)), PointSet(cube_vertices(2))).status,
            DistanceStatus::optimal);
}

}  // namespace
}  // namespace raygauge::test_solver_limits
