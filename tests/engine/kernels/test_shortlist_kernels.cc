// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "engine/kernels/kernel.h"
#include "engine/proof/certificate.h"
#include "raygauge/sets/point_set.h"
#include "tests/engine/instruction_sets.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_shortlist_kernels {
namespace {

class Shortlists : public ::testing::TestWithParam<InstructionSet> {
 protected:
  const Kernels& kernels() const { return kernels_for(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(Machine, Shortlists, ::testing::ValuesIn(instruction_sets_here()),
                         [](const auto& instance) { return std::string(to_string(instance.param)); });

PricedPoints priced(const PointSet& S, bool in_single) {
  return {S.data(), S.block_count(), in_single ? S.single_data() : nullptr,
          in_single ? S.single_block_count() : 0, S.size()};
}

// max u·p over the points of a lane, whose number is known modulo the number of lanes.
double best_of_lane(const Eigen::MatrixXd& points, const Vector& u, Eigen::Index lane, Eigen::Index lanes) {
  double best = -std::numeric_limits<double>::infinity();
  for (Eigen::Index i = lane; i < points.cols(); i += lanes) best = std::max(best, points.col(i).dot(u));
  return best;
}

TEST_P(Shortlists, HoldTheBestPointOfEveryLane) {
  Random random(21);
  for (const int n : {1, 2, 3, 6, 7, 10, 11, 20}) {
    for (const int N : {1, 7, 16, 17, 100, 333}) {
      const Eigen::MatrixXd points = gaussian_points(n, N, random);
      const Vector u = gaussian_points(n, 1, random);
      const PointSet S(points);
      for (const bool in_single : {false, true}) {
        const PricedPoints view = priced(S, in_single);
        std::vector<float> scratch(static_cast<std::size_t>(n));
        LaneList list;
        const double value = kernels().price_lanes(&view, n, u.data(), scratch.data(), &list);
        const double error = in_single ? 1e-5 * (1 + u.norm()) : dot_error(S, u.data());
        ASSERT_EQ(list.count, in_single ? 16 : 8);
        ASSERT_NEAR(value, (points.transpose() * u).maxCoeff(), error);
        ASSERT_NEAR(points.col(list.best).dot(u), value, 2 * error);
        for (int c = 0; c < list.count; ++c) {
          const Eigen::Index i = list.index[c];
          ASSERT_LT(i, N);
          if (i == N - 1) continue;  // which lanes of the last block repeat
          ASSERT_GE(points.col(i).dot(u), best_of_lane(points, u, i % list.count, list.count) - 2 * error)
              << "n = " << n << ", N = " << N << ", single " << in_single;
        }
      }
    }
  }
}

// Of a pair of lanes 8 apart the better one stands in the first half.
TEST_P(Shortlists, PutTheBetterOfTwoLanesFirst) {
  Random random(22);
  const Eigen::MatrixXd points = gaussian_points(5, 200, random);
  const Vector u = gaussian_points(5, 1, random);
  const PointSet S(points);
  const PricedPoints view = priced(S, true);
  std::vector<float> scratch(5);
  LaneList list;
  kernels().price_lanes(&view, 5, u.data(), scratch.data(), &list);
  std::set<std::int64_t> different(list.index, list.index + list.count);
  EXPECT_EQ(different.size(), 16U);
  for (int c = 0; c < 8; ++c) {
    EXPECT_GE(points.col(list.index[c]).dot(u), points.col(list.index[c + 8]).dot(u) - 1e-5);
  }
}

TEST_P(Shortlists, BestVerticesAreMadeOfTheBestPoints) {
  Random random(23);
  for (const int n : {2, 3, 6, 9, 10, 12, 17}) {
    const Eigen::MatrixXd a = gaussian_points(n, 75, random);
    const Eigen::MatrixXd q = gaussian_points(n, 31, random);
    const Vector u = gaussian_points(n, 1, random);
    const Vector center = gaussian_points(n, 1, random);
    const PointSet A(a);
    const PointSet Q(q);
    const PricedPoints view_A = priced(A, false);
    const PricedPoints view_Q = priced(Q, false);
    Vector point_A(n), point_Q(n), column(n);
    BestVertex best = {center.data(), 1.25, point_A.data(), point_Q.data(), column.data()};
    const double value = kernels().best_vertex(&view_A, &view_Q, n, u.data(), &best);
    Eigen::Index best_A = 0;
    Eigen::Index best_Q = 0;
    EXPECT_NEAR(best.value_A, (a.transpose() * u).maxCoeff(&best_A), 1e-13);
    EXPECT_NEAR(best.value_Q, (-q.transpose() * u).maxCoeff(&best_Q), 1e-13);
    EXPECT_EQ(point_A, a.col(best_A));
    EXPECT_EQ(point_Q, q.col(best_Q));
    EXPECT_LE((column - (point_A - center - 1.25 * point_Q)).norm(), 1e-14);
    EXPECT_NEAR(value, column.dot(u), 1e-13);
  }
}

}  // namespace
}  // namespace raygauge::test_shortlist_kernels
