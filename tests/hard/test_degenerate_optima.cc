// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Optima on faces of low dimension, where most basic weights are zero: proven, and without the exact simplex.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "raygauge/queries/solver.h"
#include "tests/generators/points_of.h"

namespace raygauge::test_degenerate_optima {
namespace {

struct Family {
  std::string generator;
  Parameters parameters;
};

std::vector<Family> families() {
  std::vector<Family> all = {{"hard_planted_ties", {{"ties", 0.05}}}};
  for (const std::int64_t entry : {1, 30, 1000}) {
    const Parameters sheared = {{"ties", 0.05}, {"entry", entry}};
    Parameters inside = sheared;
    inside["place"] = std::string("interior");
    all.push_back({"hard_planted_unimodular", sheared});
    all.push_back({"hard_planted_origin", sheared});
    all.push_back({"hard_planted_origin", inside});
    all.push_back({"hard_planted_unreachable", sheared});
  }
  return all;
}

DistanceStatus promised(double distance) {
  if (distance == 0) return DistanceStatus::contains_origin;
  return std::isinf(distance) ? DistanceStatus::unreachable : DistanceStatus::optimal;
}

TEST(DegenerateOptima, AreProvenWithoutTheExactSimplex) {
  DistanceSolver solver;
  for (const auto& [generator, parameters] : families()) {
    for (const int n : {16, 30, 60}) {
      for (const int N : {n + 2, 3 * n / 2, 2 * n}) {
        for (int repetition = 0; repetition < 2; ++repetition) {
          const Instance instance = generate(generator, {1, n, N, repetition}, parameters);
          const double truth = instance.exact_distance.value();
          const DistanceResult& result = solver.solve(*instance.A, *instance.Q);
          EXPECT_EQ(result.status, promised(truth))
              << generator << " " << to_string(parameters) << ", n = " << n << ", N = " << N;
          EXPECT_LE(result.lower, truth);
          EXPECT_GE(result.upper, truth);
          EXPECT_EQ(result.counters.exact_pivots, 0)
              << generator << " " << to_string(parameters) << ", n = " << n << ", N = " << N;
        }
      }
    }
  }
}

// Where the interior-point method fails on sheared points and the simplex finds no margin: by the plane of
// the first phase's direction. It was open after 60 s of exact arithmetic.
TEST(DegenerateOptima, OfShearedPointsThatCannotBeReachedTakeNoExactArithmetic) {
  DistanceOptions options;
  options.time_limit = 20;
  DistanceSolver solver(options);
  const Parameters sheared = {{"ties", 0.05}, {"entry", std::int64_t{1000}}};
  // Of the third some products are as small as the rounding errors of doubles.
  const std::vector<InstanceKey> keys = {
      {1, 300, 450, 0}, {1, 300, 450, 2}, {1, 300, 600, 1}, {1, 500, 750, 0}};
  for (const InstanceKey& key : keys) {
    const Instance instance = generate("hard_planted_unreachable", key, sheared);
    const DistanceResult& result = solver.solve(*instance.A, *instance.Q);
    EXPECT_EQ(result.status, DistanceStatus::unreachable);
    EXPECT_EQ(result.counters.exact_pivots, 0);
  }
}

// A basis of which weights of 1e-4 are rounding: proven by the columns above that, not by a simplex in
// double-double arithmetic, which takes 20 times as long.
TEST(DegenerateOptima, AreFoundAmongWeightsThatAreRounding) {
  const Parameters sheared = {{"ties", 0.05}, {"entry", std::int64_t{1000}}};
  const Instance instance = generate("hard_planted_origin", {1, 100, 200, 0}, sheared);
  DistanceSolver solver;
  const DistanceResult& result = solver.solve(*instance.A, *instance.Q);
  EXPECT_EQ(result.status, DistanceStatus::contains_origin);
  EXPECT_EQ(result.origin_weights.size(), 10U);
  EXPECT_LT(result.counters.pivots, 2400);  // 2431 with those of the other simplex
}

// The weights that prove the origin in A combine to it.
TEST(DegenerateOptima, LeaveWeightsThatCombineToTheOrigin) {
  DistanceSolver solver;
  for (const char* place : {"face", "interior"}) {
    for (int repetition = 0; repetition < 3; ++repetition) {
      const Parameters parameters = {{"place", std::string(place)}, {"ties", 0.1}};
      const Instance instance = generate("hard_planted_origin", {2, 40, 60, repetition}, parameters);
      const auto& A = dynamic_cast<const PointSet&>(*instance.A);
      const DistanceResult& result = solver.solve(A, *instance.Q);
      ASSERT_EQ(result.status, DistanceStatus::contains_origin);
      Vector sum = Vector::Zero(40);
      double weights = 0, largest = 0;
      for (const auto& [index, weight] : result.origin_weights) {
        EXPECT_GT(weight, 0);
        weights += weight;
        sum += weight * A.point(index);
        largest = std::max(largest, A.point(index).cwiseAbs().maxCoeff());
      }
      EXPECT_NEAR(weights, 1, 1e-14);
      EXPECT_LE(sum.cwiseAbs().maxCoeff(), 1e-14 * largest);
    }
  }
}

// One basis change proves nothing. No clock is involved: the limit is the same on every machine.
// Where A is around 0, rounding decides in a few instances whether one change shows a ray that meets A.
TEST(DegenerateOptima, AreBoundedFromAboveWhereALimitEndsTheSimplexAtOnce) {
  DistanceOptions options;
  options.max_iterations = 1;
  DistanceSolver solver(options);
  int around_origin[2] = {0, 0};  // with an upper bound, and without
  for (const auto& [generator, parameters] : families()) {
    for (const int n : {30, 60, 120}) {
      for (const int N : {n + 2, 3 * n / 2, 2 * n}) {
        const Instance instance = generate(generator, {1, n, N, 0}, parameters);
        const double truth = instance.exact_distance.value();
        const DistanceResult& result = solver.solve(*instance.A, *instance.Q);
        EXPECT_LE(result.lower, truth);
        EXPECT_GE(result.upper, truth);
        if (truth == 0) {
          around_origin[std::isinf(result.upper) ? 1 : 0] += 1;
          continue;
        }
        EXPECT_EQ(std::isinf(result.upper), std::isinf(truth))
            << generator << " " << to_string(parameters) << ", n = " << n << ", N = " << N;
      }
    }
  }
  EXPECT_GT(around_origin[0], 20 * around_origin[1]);
}

// So many columns carry weight at 0 that a face of dependent points is found first, and some are left out.
TEST(DegenerateOptima, TheOriginInsideManyPointsIsProvenByTheInteriorPointMethod) {
  DistanceSolver solver;
  for (const std::int64_t entry : {1, 1000}) {
    const Parameters inside = {{"ties", 0.05}, {"entry", entry}, {"place", std::string("interior")}};
    for (const int N : {262, 390, 450}) {
      const Instance instance = generate("hard_planted_origin", {1, 260, N, 0}, inside);
      const DistanceResult& result = solver.solve(*instance.A, *instance.Q);
      EXPECT_EQ(result.status, DistanceStatus::contains_origin);
      EXPECT_EQ(result.counters.pivots, 0);
      EXPECT_LE(result.origin_weights.size(), 261u);
      double sum = 0;
      for (const PointWeight& weight : result.origin_weights) {
        EXPECT_GT(weight.weight, 0);
        sum += weight.weight;
      }
      EXPECT_NEAR(sum, 1, 1e-14);
    }
  }
}

// A direction that has not come close enough to the plane that holds 37 points of Q: they are those below the
// widest gap. It was open after 16000 basis changes.
TEST(DegenerateOptima, PlanesOfPointsThatCannotBeReachedAreFoundByTheWidestGap) {
  DistanceOptions options;
  options.time_limit = 20;
  DistanceSolver solver(options);
  for (const std::int64_t entry : {1, 1000}) {
    const Instance instance =
        generate("hard_planted_unreachable", {1, 500, 750, 5}, {{"ties", 0.05}, {"entry", entry}});
    const DistanceResult& result = solver.solve(*instance.A, *instance.Q);
    EXPECT_EQ(result.status, DistanceStatus::unreachable) << entry;
    EXPECT_EQ(result.counters.pivots, 0) << entry;
  }
}

// As many digits lost in the inverse of a basis as in 1e11: it took the simplex 20000 basis changes, or never
// ended.
TEST(DegenerateOptima, TheOriginInsideShearedPointsOfR500IsProvenWithoutBasisChanges) {
  DistanceOptions options;
  options.time_limit = 20;
  DistanceSolver solver(options);
  const Parameters inside = {
      {"ties", 0.05}, {"entry", std::int64_t{1000}}, {"place", std::string("interior")}};
  const std::vector<InstanceKey> keys = {
      {1, 500, 502, 0}, {1, 500, 502, 1}, {1, 500, 502, 3}, {1, 500, 750, 2}, {1, 500, 750, 6}};
  for (const InstanceKey& key : keys) {
    const Instance instance = generate("hard_planted_origin", key, inside);
    const DistanceResult& result = solver.solve(*instance.A, *instance.Q);
    EXPECT_EQ(result.status, DistanceStatus::contains_origin) << key.N << ", " << key.repetition;
    EXPECT_EQ(result.counters.pivots, 0) << key.N << ", " << key.repetition;
    EXPECT_LE(result.origin_weights.size(), 501u);
  }
}

}  // namespace
}  // namespace raygauge::test_degenerate_optima
