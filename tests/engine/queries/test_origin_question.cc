// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Whether 0 lies in a set of points does not depend on the metric or the method asked.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "raygauge/queries/solver.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/p_norm_ball.h"
#include "raygauge/sets/point_set.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_origin_question {
namespace {

constexpr DistanceMethod kMethods[] = {DistanceMethod::automatic, DistanceMethod::column_generation,
                                       DistanceMethod::newton, DistanceMethod::zheng_yamane};

using Set = std::shared_ptr<const ConvexSet>;

std::vector<Set> metrics(int n) {
  std::vector<Set> all;
  all.push_back(std::make_shared<Ball>(Vector::Zero(n), 1.0));
  all.push_back(std::make_shared<PNormBall>(Vector::Zero(n), Vector::Ones(n), 3.0));
  Eigen::MatrixXd axes = Eigen::MatrixXd::Identity(n, n);
  axes(0, n - 1) += 0.5;
  all.push_back(std::make_shared<Ellipsoid>(Vector::Zero(n), axes));
  all.push_back(std::make_shared<PointSet>(cube_vertices(n)));
  all.push_back(std::make_shared<PointSet>(cross_polytope_vertices(n)));
  return all;
}

DistanceResult solve(const ConvexSet& A, const ConvexSet& Q, DistanceMethod method) {
  DistanceOptions options;
  options.method = method;
  return DistanceSolver(options).solve(A, Q);
}

void expect_origin_in(const ConvexSet& A) {
  for (const Set& Q : metrics(A.dimension())) {
    for (const DistanceMethod method : kMethods) {
      const DistanceResult result = solve(A, *Q, method);
      EXPECT_EQ(result.status, DistanceStatus::contains_origin)
          << "method " << static_cast<int>(method) << ", n = " << A.dimension();
      EXPECT_EQ(result.upper, 0);
    }
  }
}

// A user's data: three points of a plane through the origin.
TEST(OriginQuestion, IsAnsweredAlikeForEveryMetricAndMethod) {
  Eigen::Matrix3d points;
  points << 0, 0, 0, -3, 1, 0, 1, -2, 2;
  expect_origin_in(PointSet(points));
}

// Two octahedra, one in the other, as a difference of point sets.
TEST(OriginQuestion, IsAnsweredForDifferencesOfPointSets) {
  const Eigen::MatrixXd small = 2 * cross_polytope_vertices(3);
  Eigen::MatrixXd large = 3 * cross_polytope_vertices(3);
  large.colwise() += Eigen::Vector3d(-0.5, -0.5, 0);
  expect_origin_in(MinkowskiDifference(std::make_shared<PointSet>(large), std::make_shared<PointSet>(small)));
}

// Small integers: `dependent` of the points combine to the origin, which is inside of a face of any
// dimension.
Eigen::MatrixXd points_around_origin(int n, int dependent, int others, Random& random) {
  Eigen::MatrixXd points = integer_points(n, dependent + others, 3, random);
  points.row(0).head(dependent).setZero();
  points.row(0).tail(others) = points.row(0).tail(others).cwiseAbs().array() + 1;
  points.col(0) = -points.middleCols(1, dependent - 1).rowwise().sum();
  return points;
}

TEST(OriginQuestion, FindsItOnFacesOfEveryDimension) {
  Random random(5);
  for (const int n : {2, 3, 4, 6}) {
    for (int dependent = 2; dependent <= n; ++dependent) {
      expect_origin_in(PointSet(points_around_origin(n, dependent, 3, random)));
    }
  }
}

TEST(OriginQuestion, IsDeniedJustBesideTheFace) {
  Random random(6);
  for (const int n : {2, 3, 4, 6}) {
    Eigen::MatrixXd points = points_around_origin(n, n, 3, random);
    points.row(0).array() += 0x1p-44;
    for (const Set& Q : metrics(n)) {
      for (const DistanceMethod method : kMethods) {
        const DistanceResult result = solve(PointSet(points), *Q, method);
        EXPECT_NE(result.status, DistanceStatus::contains_origin) << "method " << static_cast<int>(method);
        EXPECT_GT(result.upper, 0) << "method " << static_cast<int>(method);
      }
    }
  }
}

// The weights with which three points of integers combine to 0, each rounded once.
std::vector<double> exact_weights(const Eigen::Matrix<double, 2, 3>& points) {
  const auto cross = [&](Eigen::Index i, Eigen::Index j) {
    const auto of = [&](Eigen::Index row, Eigen::Index k) {
      return static_cast<std::int64_t>(points(row, k));
    };
    return of(0, i) * of(1, j) - of(1, i) * of(0, j);
  };
  const std::int64_t areas[] = {cross(1, 2), cross(2, 0), cross(0, 1)};
  const std::int64_t all = areas[0] + areas[1] + areas[2];
  std::vector<double> weights;
  for (const std::int64_t area : areas)
    weights.push_back(static_cast<double>(area) / static_cast<double>(all));
  return weights;
}

// Fibonacci numbers: nearly parallel points, whose weights double precision has to eleven digits. Of the four
// points two triples contain 0; either is an answer.
TEST(OriginQuestion, LeavesWeightsRoundedAsTheRationalSolution) {
  Eigen::MatrixXd A(2, 4), Q(2, 7);
  A << 62364401, 20310734, -82675135, 42053667, 80448609, 26200247, -106648856, 54248362;
  Q << 62364401, 20310734, -82675135, 62364401, -62364401, 20310734, -20310734,  //
      80448609, 26200247, -106648856, 80448609, -80448609, 26200247, -26200247;
  for (const DistanceMethod method : kMethods) {
    const DistanceResult result = solve(PointSet(A), PointSet(Q), method);
    ASSERT_EQ(result.status, DistanceStatus::contains_origin);
    ASSERT_EQ(result.origin_weights.size(), 3U);
    Eigen::Matrix<double, 2, 3> points;
    for (Eigen::Index k = 0; k < 3; ++k)
      points.col(k) = A.col(result.origin_weights[static_cast<std::size_t>(k)].index);
    const std::vector<double> exact = exact_weights(points);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(result.origin_weights[k].weight, exact[k]);
  }
}

}  // namespace
}  // namespace raygauge::test_origin_question
