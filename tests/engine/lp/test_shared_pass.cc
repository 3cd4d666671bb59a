// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/shared_pass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "raygauge/exceptions.h"
#include "raygauge/queries/solver.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_shared_pass {
namespace {

struct Pass {
  double value = 0;
  std::vector<std::pair<std::int64_t, double>> found;
  double threshold = 0;
};

Pass make_pass(const PointSet& S, const Vector& u, double threshold, std::size_t capacity, int threads) {
  std::vector<std::int64_t> index(capacity);
  std::vector<double> value(capacity);
  Collection collection{index.data(), value.data(), static_cast<std::ptrdiff_t>(capacity), 0, threshold};
  Pass pass;
  ChunkTeam team;
  pass.value = shared_pass(best_kernels(), S, u.data(), collection, threads, team);
  for (std::ptrdiff_t i = 0; i < collection.count; ++i) pass.found.emplace_back(index[i], value[i]);
  return pass;
}

// 30011 points of R^5: more than 2^17 coordinates, and no number of threads divides the blocks evenly.
class SharedPass : public ::testing::TestWithParam<int> {
 protected:
  SharedPass()
      : random_(7),
        points_(gaussian_points(5, 30011, random_)),
        S_(points_),
        u_(sphere_points(5, 1, random_)) {}

  Random random_;
  Eigen::MatrixXd points_;
  PointSet S_;
  Vector u_;
};

INSTANTIATE_TEST_SUITE_P(Threads, SharedPass, ::testing::Values(1, 2, 3, 7, kMostThreads));

TEST_P(SharedPass, FindsTheMaximumAndEveryPointAboveTheThreshold) {
  const Pass pass = make_pass(S_, u_, 2.5, 4096, GetParam());
  const Vector products = points_.transpose() * u_;
  EXPECT_NEAR(pass.value, products.maxCoeff(), 1e-13);
  std::vector<std::int64_t> expected;
  for (std::int64_t i = 0; i < products.size(); ++i) {
    if (products[i] > 2.5) expected.push_back(i);
  }
  ASSERT_GT(expected.size(), 100u);
  std::vector<std::int64_t> found;
  for (const auto& entry : pass.found) {
    // The last block is filled up with copies of the last point.
    if (entry.first < S_.size()) found.push_back(entry.first);
  }
  EXPECT_EQ(found, expected);
}

TEST_P(SharedPass, KeepsWithinTheBuffersAndKeepsTheBest) {
  const Pass pass = make_pass(S_, u_, 0.0, 256, GetParam());
  EXPECT_LE(pass.found.size(), 256u);
  const bool has_best = std::any_of(pass.found.begin(), pass.found.end(),
                                    [&](const auto& entry) { return entry.second == pass.value; });
  EXPECT_TRUE(has_best);
}

// Even where shares of the buffers run full. One thread alone has all of the buffers.
TEST_P(SharedPass, FindsWhatTwoThreadsFindHoweverManyShareIt) {
  const int threads = std::max(GetParam(), 2);
  for (const double threshold : {0.0, 2.5}) {
    EXPECT_EQ(make_pass(S_, u_, threshold, 256, threads).found, make_pass(S_, u_, threshold, 256, 2).found);
  }
}

TEST_P(SharedPass, MaximumIsTheOneOfASingleThread) {
  EXPECT_EQ(make_pass(S_, u_, 1e9, 64, GetParam()).value, make_pass(S_, u_, 1e9, 64, 1).value);
}

TEST_P(SharedPass, SolvesAreCertifiedAndAgreeWithASingleThreads) {
  Eigen::MatrixXd a = sphere_points(5, 30011, random_);
  a.row(0).array() += 3;
  const PointSet A(a), Q(sphere_points(5, 30011, random_));
  DistanceOptions options;
  options.tolerance = 1e-12;
  const DistanceResult serial = DistanceSolver(options).solve(A, Q);
  options.threads = GetParam();
  const DistanceResult shared = DistanceSolver(options).solve(A, Q);
  EXPECT_EQ(shared.status, DistanceStatus::optimal);
  EXPECT_LE(shared.lower, serial.upper);
  EXPECT_GE(shared.upper, serial.lower);
}

TEST(SharedPassOptions, ThreadsOutsideTheirRangeAreRejected) {
  for (const int threads : {0, -1, kMostThreads + 1}) {
    DistanceOptions options;
    options.threads = threads;
    EXPECT_THROW(DistanceSolver{options}, InvalidParameterError) << threads;
  }
}

}  // namespace
}  // namespace raygauge::test_shared_pass
