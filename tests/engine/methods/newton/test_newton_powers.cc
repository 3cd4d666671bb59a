// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// The method `newton` on balls of p-norms, whose support points answer to u as powers do: no two alike, and
// with other smooth sets. Every bound is recomputed from the definitions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "raygauge/queries/solver.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/p_norm_ball.h"
#include "raygauge/sets/point_set.h"
#include "tests/engine/point_clouds.h"
#include "tests/linear_algebra.h"

namespace raygauge::test_newton_powers {
namespace {

constexpr double kTolerance = 1e-12;
constexpr int kPairs = 12;

/// A set about `center`, and ‖x - center‖ in the norm whose unit ball it is there, where that is a formula.
struct Body {
  std::shared_ptr<const ConvexSet> set;
  std::function<long double(const Vector& x)> norm;
};

struct Kind {
  std::string name;
  std::function<Body(const Vector& center, Random&)> make;
};

std::ostream& operator<<(std::ostream& out, const Kind& kind) { return out << kind.name; }

double uniform(double a, double b, Random& random) {
  return std::uniform_real_distribution<double>(a, b)(random);
}

long double p_norm(const Vector& x, const Vector& center, const Vector& semi_axes, long double p) {
  long double largest = 0, sum = 0;
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    largest = std::max(largest, std::fabs((static_cast<long double>(x[k]) - center[k]) / semi_axes[k]));
  }
  if (!(largest > 0)) return 0;
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    sum += std::pow(std::fabs((static_cast<long double>(x[k]) - center[k]) / semi_axes[k]) / largest, p);
  }
  return largest * std::pow(sum, 1 / p);
}

Kind ball_of(const std::string& name, double p) {
  return {name, [p](const Vector& center, Random& random) {
            Vector semi_axes(center.size());
            for (double& semi_axis : semi_axes) semi_axis = uniform(0.5, 2, random);
            return Body{std::make_shared<PNormBall>(center, semi_axes, p), [=](const Vector& x) {
                          return p_norm(x, center, semi_axes, static_cast<long double>(p));
                        }};
          }};
}

Kind point() {
  return {"point", [](const Vector& center, Random&) {
            return Body{std::make_shared<PointSet>(center),
                        [=](const Vector& x) { return 1e12L * (x - center).norm(); }};
          }};
}

Kind ball() {
  return {"ball", [](const Vector& center, Random& random) {
            const double radius = uniform(3, 6, random);
            return Body{std::make_shared<Ball>(center, radius),
                        [=](const Vector& x) { return (x - center).norm() / radius; }};
          }};
}

Kind ellipsoid() {
  return {"ellipsoid", [](const Vector& center, Random& random) {
            const auto n = static_cast<int>(center.size());
            Vector semi_axes(n);
            for (double& semi_axis : semi_axes) semi_axis = uniform(0.5, 2, random);
            const Eigen::MatrixXd R = orthogonal_factor(gaussian_points(n, n, random));
            return Body{std::make_shared<Ellipsoid>(center, R * semi_axes.asDiagonal()),
                        [=](const Vector& x) {
                          return (R.transpose() * (x - center)).cwiseQuotient(semi_axes).norm();
                        }};
          }};
}

/// Has several pieces: its ends and what is between.
Kind capsule() {
  return {"capsule", [](const Vector& center, Random& random) {
            const Vector along = gaussian_points(static_cast<int>(center.size()), 1, random);
            const double radius = uniform(0.5, 2, random);
            return Body{std::make_shared<Capsule>(center - along, center + along, radius),
                        [=](const Vector& x) {
                          const double t = along.dot(x - center) / along.squaredNorm();
                          return (x - center - std::min(1.0, std::max(-1.0, t)) * along).norm() / radius;
                        }};
          }};
}

class Powers : public ::testing::TestWithParam<std::tuple<std::pair<Kind, Kind>, int>> {
 protected:
  struct Pair {
    Body A, Q;
  };
  /// A far to one side of Q, but for the other coordinates, and Q off the origin.
  Pair pair(Random& random) const {
    const auto& [kinds, n] = GetParam();
    Vector center_A(n), center_Q(n);
    for (double& coordinate : center_A) coordinate = uniform(-9, 9, random);
    center_A[0] = 30;
    for (double& coordinate : center_Q) coordinate = uniform(-0.2, 0.2, random) / n;
    return {kinds.first.make(center_A, random), kinds.second.make(center_Q, random)};
  }
  static const DistanceResult& solve(DistanceSolver& solver, const Pair& pair) {
    return solver.solve(*pair.A.set, *pair.Q.set, Effects::witness);
  }
};

DistanceOptions options_of(DistanceMethod method) {
  DistanceOptions options;
  options.method = method;
  options.tolerance = kTolerance;
  return options;
}

// Weak duality from below; from above a point of A in the multiple of Q, by their norms.
TEST_P(Powers, AreCertifiedByBoundsThatHold) {
  Random random(81);
  for (int i = 0; i < kPairs; ++i) {
    SCOPED_TRACE("pair " + std::to_string(i));
    const Pair pair = this->pair(random);
    for (const DistanceMethod method : {DistanceMethod::newton, DistanceMethod::column_generation}) {
      DistanceSolver solver(options_of(method));
      const DistanceResult& result = solve(solver, pair);
      ASSERT_EQ(result.status, DistanceStatus::optimal)
          << to_string(method) << ": " << to_string(result.status);
      EXPECT_LE(result.upper - result.lower, kTolerance * result.upper);
      const double ratio =
          -pair.A.set->support_function(result.normal) / pair.Q.set->support_function(-result.normal);
      EXPECT_LE(result.lower, ratio * (1 + 1e-13)) << to_string(method);
      EXPECT_LE(pair.A.norm(result.contact_point), 1 + 1e-10L) << to_string(method);
      EXPECT_LE(pair.Q.norm(result.contact_point / result.upper), 1 + 1e-10L) << to_string(method);
    }
  }
}

const std::vector<std::pair<Kind, Kind>> kDifferent = {{ball_of("p1_1", 1.1), ball_of("p1_1", 1.1)},
                                                       {ball_of("p3", 3), ball_of("p3", 3)},
                                                       {ball_of("p10", 10), ball_of("p10", 10)},
                                                       {ball_of("p30", 30), ball_of("p30", 30)},
                                                       {ball_of("p100", 100), ball_of("p100", 100)},
                                                       {ball_of("p1000", 1e3), ball_of("p1000", 1e3)},
                                                       {ball_of("p1000000", 1e6), ball_of("p1000", 1e3)},
                                                       {ball_of("p1_1", 1.1), ball_of("p5", 5)},
                                                       {ball_of("p3", 3), ball_of("p1000000", 1e6)},
                                                       {ball_of("p1000000", 1e6), ball_of("p3", 3)},
                                                       {point(), ball_of("p10", 10)},
                                                       {point(), ball_of("p100", 100)},
                                                       {ball(), ball_of("p10", 10)},
                                                       {ball(), ball_of("p1000000", 1e6)},
                                                       {ball_of("p10", 10), ball()},
                                                       {ball_of("p1000000", 1e6), ball()},
                                                       {ball_of("p10", 10), ellipsoid()},
                                                       {ellipsoid(), ball_of("p30", 30)},
                                                       {capsule(), ball_of("p3", 3)}};

std::string name_of(const ::testing::TestParamInfo<Powers::ParamType>& instance) {
  const auto& [kinds, n] = instance.param;
  return kinds.first.name + "_of_" + kinds.second.name + "_n" + std::to_string(n);
}

INSTANTIATE_TEST_SUITE_P(Pairs, Powers,
                         ::testing::Combine(::testing::ValuesIn(kDifferent), ::testing::Values(3, 8, 20)),
                         name_of);

/// A p-norm ball against another, and how many support queries a pair may take on average.
struct Steps {
  double p_A, p_Q;
  int most;
};

// Without steps along powers a pair of p = 10 took 1900 queries at n = 20, and was not certified; where steps
// into a face could not be taken back, one of p = 1e6 and p = 3 took 1800; and where a rising ratio did not
// count as progress, one of p = 1.05 took 330.
TEST(PowerSteps, AreFew) {
  for (const auto& [p_A, p_Q, most] : std::vector<Steps>{{1.05, 1.05, 110},
                                                         {1.1, 1.1, 70},
                                                         {1.5, 1.5, 30},
                                                         {3, 3, 30},
                                                         {10, 10, 30},
                                                         {100, 100, 30},
                                                         {1e6, 1e6, 30},
                                                         {1e6, 3, 40},
                                                         {1e6, 1.5, 50},
                                                         {3, 1e6, 30}}) {
    for (const int n : {3, 8, 20}) {
      Random random(82);
      std::int64_t queries = 0;
      for (int i = 0; i < kPairs; ++i) {
        Vector center = 9 * gaussian_points(n, 1, random);
        center[0] = 30;
        const Body A = ball_of("", p_A).make(center, random);
        const Body Q = ball_of("", p_Q).make(Vector::Constant(n, 0.1 / n), random);
        DistanceSolver solver(options_of(DistanceMethod::newton));
        const DistanceResult& result = solver.solve(*A.set, *Q.set);
        EXPECT_EQ(result.status, DistanceStatus::optimal);
        EXPECT_EQ(result.counters.points_priced, 0) << "handed over to column_generation";
        queries += result.counters.support_queries;
      }
      EXPECT_LE(queries, most * kPairs) << "p = " << p_A << ", " << p_Q << ", n = " << n;
    }
  }
}

// Of an ellipsoid and a ball of a p-norm the ball answers to u as a power, the ellipsoid in a straight line.
// Straight steps for both took 50 to 2000 queries and quadruple precision: 0.2 s at n = 50, 5 s at n = 100.
TEST(PowerSteps, AreFewForSumsWithBallsOfPNorms) {
  for (const double p : {1.5, 3.0, 10.0}) {
    for (const int n : {3, 20, 50}) {
      Random random(84);
      const auto sum_about = [&](const Vector& center) {
        const Eigen::MatrixXd factor =
            Eigen::MatrixXd::Identity(n, n) + 0.5 * gaussian_points(n, n, random) / std::sqrt(n);
        return std::make_shared<MinkowskiSum>(std::make_shared<Ellipsoid>(center, factor),
                                              ball_of("", p).make(Vector::Zero(n), random).set);
      };
      for (int i = 0; i < kPairs; ++i) {
        const auto A = sum_about(16 * sphere_points(n, 1, random).col(0));
        const auto Q = sum_about(Vector::Zero(n));
        DistanceOptions options = options_of(DistanceMethod::newton);
        options.tolerance = 1e-9;
        DistanceSolver solver(options);
        const DistanceResult& result = solver.solve(*A, *Q);
        EXPECT_EQ(result.status, DistanceStatus::optimal) << "p = " << p << ", n = " << n << ", pair " << i;
        EXPECT_LE(result.counters.support_queries, 30) << "p = " << p << ", n = " << n << ", pair " << i;
        EXPECT_EQ(result.counters.points_priced, 0) << "handed over";
      }
    }
  }
}

// Quadruple precision goes on where doubles ended, and what those did is not forgotten.
TEST(PowerSteps, AreCountedInWhateverPrecision) {
  for (const double p : {1.1, 10.0}) {
    Random random(83);
    for (int i = 0; i < kPairs; ++i) {
      Vector center = 9 * gaussian_points(20, 1, random);
      center[0] = 30;
      const Body A = ball_of("", p).make(center, random);
      const Body Q = ball_of("", p).make(Vector::Constant(20, 0.005), random);
      std::int64_t before = 0;
      for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-11, 1e-12, 1e-13, 1e-14}) {
        DistanceOptions options = options_of(DistanceMethod::newton);
        options.tolerance = tolerance;
        const std::int64_t queries = DistanceSolver(options).solve(*A.set, *Q.set).counters.support_queries;
        EXPECT_GE(queries, before) << "p = " << p << ", pair " << i << ", tolerance " << tolerance;
        before = queries;
      }
    }
  }
}

}  // namespace
}  // namespace raygauge::test_newton_powers
