// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/streamed_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "engine/queries/streamed_hull.h"
#include "raygauge/exceptions.h"
#include "raygauge/sets/ball.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_streamed_distance {
namespace {

// The columns of a matrix, some at a time.
class MatrixStream final : public PointStream {
 public:
  MatrixStream(const Eigen::MatrixXd& points, std::ptrdiff_t together, bool single = false)
      : doubles_(points), floats_(points.cast<float>()), together_(together), single_(single) {}
  int dimension() const noexcept override { return static_cast<int>(doubles_.rows()); }
  std::ptrdiff_t size() const noexcept override { return doubles_.cols(); }
  void pass(const std::function<bool(const StreamedPoints&)>& visit) override {
    for (std::ptrdiff_t first = 0; first < size(); first += together_) {
      const std::ptrdiff_t count = std::min(together_, size() - first);
      const std::ptrdiff_t at = first * doubles_.rows();
      const StreamedPoints part = {single_ ? nullptr : doubles_.data() + at, floats_.data() + at, first,
                                   count};
      if (!visit(part)) return;
    }
  }

 private:
  Eigen::MatrixXd doubles_;
  Eigen::MatrixXf floats_;
  std::ptrdiff_t together_;
  bool single_;
};

std::shared_ptr<const PointSet> hull(const Eigen::MatrixXd& points) {
  return std::make_shared<const PointSet>(points);
}

Eigen::MatrixXd shifted(Eigen::MatrixXd points, double by) {
  points.row(0).array() += by;
  return points;
}

// The hull of the columns of a matrix, which it copies, `together` at a time.
StreamedHull streamed_hull(const Eigen::MatrixXd& points, std::ptrdiff_t together, bool single = false) {
  return StreamedHull([=] { return std::make_unique<MatrixStream>(points, together, single); });
}

void expect_same(const DistanceResult& streamed, const DistanceResult& whole) {
  EXPECT_EQ(streamed.status, whole.status);
  EXPECT_LE(streamed.lower, whole.upper);
  EXPECT_LE(whole.lower, streamed.upper);
  EXPECT_LE(streamed.upper - streamed.lower, 1e-6 * streamed.upper);
}

TEST(StreamedDistance, IsThatOfTheWholeSetsWhicheverIsAStream) {
  for (const int n : {2, 3, 10}) {
    Random random(static_cast<unsigned>(n));
    const Eigen::MatrixXd a = shifted(sphere_points(n, 20000, random), 3);
    const Eigen::MatrixXd q = sphere_points(n, 20000, random);
    DistanceSolver solver;
    const DistanceResult whole = solver.solve(*hull(a), *hull(q));
    for (const int streams : {1, 2, 3}) {
      const StreamedHull of_A = streamed_hull(a, 1500), of_Q = streamed_hull(q, 999);
      const PointSet whole_A(a), whole_Q(q);
      const ConvexSet& A = (streams & 1) != 0 ? static_cast<const ConvexSet&>(of_A) : whole_A;
      const ConvexSet& Q = (streams & 2) != 0 ? static_cast<const ConvexSet&>(of_Q) : whole_Q;
      StreamedDistance streamed(A, Q, {});
      expect_same(streamed.solve(), whole);
      EXPECT_LE(streamed.passes(), 4) << "n = " << n << ", streams " << streams;
    }
  }
}

// The best points come last, where no normal has been anywhere near them.
TEST(StreamedDistance, FindsPointsOfTheLastPartAndProvesThemByAnotherPass) {
  Random random(4);
  Eigen::MatrixXd a = shifted(sphere_points(4, 30000, random), 6);
  a.rightCols(100) = shifted(sphere_points(4, 100, random), 3);
  const auto Q = hull(sphere_points(4, 500, random));
  const StreamedHull stream = streamed_hull(a, 1000);
  StreamedDistance streamed(stream, *Q, {});
  DistanceSolver solver;
  expect_same(streamed.solve(), solver.solve(*hull(a), *Q));
  EXPECT_GE(streamed.passes(), 2);
}

TEST(StreamedDistance, TakesPointsInSinglePrecisionAsTheyAre) {
  Random random(5);
  const Eigen::MatrixXd a = shifted(sphere_points(5, 5000, random), 3);
  const auto Q = std::make_shared<const Ball>(Vector::Zero(5), 1.0);
  const StreamedHull stream = streamed_hull(a, 700, true);
  StreamedDistance streamed(stream, *Q, {});
  DistanceSolver solver;
  expect_same(streamed.solve(), solver.solve(*hull(a.cast<float>().cast<double>()), *Q));
}

TEST(StreamedDistance, ProvesTheOriginInsideByNumbersOfTheStream) {
  Random random(6);
  const Eigen::MatrixXd a = sphere_points(3, 4000, random);
  const auto Q = hull(sphere_points(3, 100, random));
  const StreamedHull stream = streamed_hull(a, 512);
  StreamedDistance streamed(stream, *Q, {});
  const DistanceResult& result = streamed.solve();
  ASSERT_EQ(result.status, DistanceStatus::contains_origin);
  Vector sum = Vector::Zero(3);
  for (const PointWeight& weight : result.origin_weights) sum += weight.weight * a.col(weight.index);
  EXPECT_LT(sum.norm(), 1e-12);
}

TEST(StreamedDistance, ProvesThatNoMultipleReachesOnlyOfAllPoints) {
  Random random(7);
  const Eigen::MatrixXd a = shifted(sphere_points(3, 4000, random), -4);
  Eigen::MatrixXd q = shifted(sphere_points(3, 4000, random), 4);
  for (const bool reaches : {false, true}) {
    if (reaches) q.rightCols(50) = shifted(sphere_points(3, 50, random), -1);
    const StreamedHull stream = streamed_hull(q, 500);
    const auto A = hull(a);
    StreamedDistance streamed(*A, stream, {});
    DistanceSolver solver;
    const DistanceResult whole = solver.solve(*hull(a), *hull(q));
    EXPECT_EQ(whole.status, reaches ? DistanceStatus::optimal : DistanceStatus::unreachable);
    EXPECT_EQ(streamed.solve().status, whole.status);
  }
}

TEST(StreamedDistance, IsWhatEverySolverAsksOfAStream) {
  Random random(10);
  const Eigen::MatrixXd a = shifted(sphere_points(6, 5000, random), 3), q = sphere_points(6, 3000, random);
  const StreamedHull A = streamed_hull(a, 700);
  const PointSet Q(q);
  DistanceSolver solver;
  const DistanceResult whole = solver.solve(PointSet(a), Q);
  for (const DistanceMethod method : {DistanceMethod::automatic, DistanceMethod::column_generation,
                                      DistanceMethod::zheng_yamane, DistanceMethod::newton}) {
    solver.set_options({.method = method});
    SCOPED_TRACE(to_string(method));
    expect_same(solver.solve(A, Q, Effects::witness), whole);
    EXPECT_GT(solver.solve(A, Q).counters.points_priced, a.cols() - 1);
  }
  // What needs its support points alone reads it once for each.
  const Pose pose(6);
  expect_same(solver.solve(Posed(A, pose), Posed(Q)), whole);
}

// Planes that hold points of Q leave no room for the rounding of a pass.
TEST(StreamedDistance, IsProvenAsInMemoryWhereTheFirstPointsAreAll) {
  Random random(12);
  const auto quarters = [](const Eigen::MatrixXd& points) { return (4 * points).array().round() / 4; };
  for (const int n : {2, 60, 60, 60, 100, 100, 100, 100, 200, 200, 200, 200, 200}) {
    Eigen::MatrixXd a = quarters(sphere_points(n, n + 2, random));
    a.row(0).array() += 3;
    const Eigen::MatrixXd q = quarters(2 * sphere_points(n, n + 2, random));
    DistanceSolver solver;
    const DistanceResult whole = solver.solve(PointSet(a), PointSet(q));
    const DistanceResult& result = solver.solve(streamed_hull(a, 1000), streamed_hull(q, 1000));
    EXPECT_EQ(result.status, whole.status) << n;
    EXPECT_LE(whole.lower, result.upper) << n;
    EXPECT_LE(result.lower, whole.upper) << n;
  }
}

TEST(StreamedHull, HasTheSupportPointsAndTheSizeOfAllPoints) {
  Random random(11);
  const Eigen::MatrixXd a = shifted(sphere_points(4, 3000, random), 2);
  const StreamedHull streamed = streamed_hull(a, 512);
  const PointSet whole(a);
  EXPECT_EQ(streamed.size(), 3000);
  EXPECT_EQ(as_streamed_hull(whole), nullptr);
  for (int i = 0; i < 10; ++i) {
    const Vector u = sphere_points(4, 1, random);
    EXPECT_DOUBLE_EQ(streamed.support_function(u), whole.support_function(u));
    EXPECT_EQ(streamed.support_mapping(u), whole.support_mapping(u));
  }
  Vector size(4), size_of_whole(4);
  streamed.magnitude_unchecked(size.data());
  whole.magnitude_unchecked(size_of_whole.data());
  EXPECT_EQ(size, size_of_whole);
  EXPECT_GE(whole.support_function(Vector::Unit(4, 0)), streamed.center()[0]);
}

TEST(StreamedDistance, RefusesWhatIsNoNumberWithItsPlace) {
  Random random(8);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) {
    Eigen::MatrixXd a = shifted(sphere_points(3, 3000, random), 3);
    a(1, 2500) = bad;
    const StreamedHull stream = streamed_hull(a, 500);
    const auto Q = hull(sphere_points(3, 50, random));
    StreamedDistance streamed(stream, *Q, {});
    try {
      streamed.solve();
      FAIL() << bad;
    } catch (const NonFiniteError& error) {
      EXPECT_NE(std::string(error.what()).find("at row 2500, column 1"), std::string::npos) << error.what();
    }
  }
}

TEST(StreamedDistance, EndsAtItsTimeLimitWithABoundFromAbove) {
  Random random(9);
  const Eigen::MatrixXd a = shifted(sphere_points(3, 3000, random), 3);
  const StreamedHull stream = streamed_hull(a, 500);
  DistanceOptions options;
  options.time_limit = 1e-9;
  const auto Q = hull(sphere_points(3, 50, random));
  StreamedDistance streamed(stream, *Q, options);
  const DistanceResult& result = streamed.solve();
  EXPECT_EQ(result.status, DistanceStatus::time_limit);
  EXPECT_EQ(result.lower, 0);
  DistanceSolver solver;
  EXPECT_GE(result.upper, solver.solve(*hull(a), *Q).lower);
}

}  // namespace
}  // namespace raygauge::test_streamed_distance
