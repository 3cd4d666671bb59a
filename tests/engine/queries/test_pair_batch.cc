// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/pair_batch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <memory>
#include <random>
#include <vector>

#include "raygauge/exceptions.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/prepared_set.h"

namespace raygauge::test_pair_batch {
namespace {

constexpr int kPairs = 300;

DistanceOptions options_for(int threads) {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  options.threads = threads;
  return options;
}

// Boxes, capsules and hulls at random places, some of them through each other.
struct Bodies {
  Bodies() {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    const auto vector = [&] { return Eigen::Vector3d(normal(random), normal(random), normal(random)); };
    Eigen::Matrix3Xd points(3, 40);
    for (double& x : points.reshaped()) x = normal(random);
    const Eigen::Vector3d half(0.5, 0.3, 0.2);
    sets.push_back(std::make_unique<Box>(Eigen::Vector3d(-half), half));
    sets.push_back(std::make_unique<Capsule>(Eigen::Vector3d(-half), half, 0.2));
    sets.push_back(std::make_unique<PreparedSet>(points));
    for (std::size_t i = 0; i < kPairs; ++i) {
      const Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
      const Pose& one = poses.emplace_back(q, vector());
      const Pose& two = poses.emplace_back(q.conjugate(), 2 * vector());
      pairs.push_back({{*sets[i % 3], one}, {*sets[i % 2], two}});
    }
  }

  std::vector<std::unique_ptr<const ConvexSet>> sets;
  std::deque<Pose> poses;
  std::vector<PosedPair> pairs;
};

struct Answers {
  std::vector<double> distance = std::vector<double>(kPairs), lower = distance, upper = distance;
  std::vector<double> normal = std::vector<double>(std::size_t{3} * kPairs), points_1 = normal,
                      points_2 = normal;
  std::vector<DistanceStatus> status = std::vector<DistanceStatus>(kPairs);

  BatchAnswers spans() { return {distance, lower, upper, status, normal, points_1, points_2}; }
};

const Ball& metric() {
  static const Ball ball(Eigen::Vector3d::Zero(), 1);
  return ball;
}

void expect_vector(const std::vector<double>& all, std::size_t i, const Vector& expected) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (expected.size() == 0) {
      EXPECT_TRUE(std::isnan(all[3 * i + k]));
    } else {
      EXPECT_EQ(all[3 * i + k], expected[static_cast<Eigen::Index>(k)]);
    }
  }
}

TEST(PairBatch, HasTheAnswersOfSingleQueriesOnAnyNumberOfThreads) {
  const Bodies bodies;
  ObjectDistanceSolver alone(options_for(1));
  for (const int threads : {1, 2, 5}) {
    PairBatch batch(options_for(threads));
    Answers answers;
    batch.distances(bodies.pairs, metric(), answers.spans());
    for (std::size_t i = 0; i < kPairs; ++i) {
      const ObjectDistance& r =
          alone.solve(bodies.pairs[i].first, bodies.pairs[i].second, metric(), ObjectEffects::closest_points);
      EXPECT_EQ(answers.distance[i], r.distance.distance);
      EXPECT_EQ(answers.lower[i], r.distance.lower);
      EXPECT_EQ(answers.upper[i], r.distance.upper);
      EXPECT_EQ(answers.status[i], r.distance.status);
      expect_vector(answers.normal, i, r.distance.normal);
      expect_vector(answers.points_1, i, r.closest_point_1);
      expect_vector(answers.points_2, i, r.closest_point_2);
    }
  }
}

TEST(PairBatch, HasGrowthDistancesWithWarmStartsOfItsCaller) {
  const Bodies bodies;
  GrowthDistanceSolver alone(options_for(1));
  PairBatch batch(options_for(2));
  std::vector<WarmStart> warm(kPairs);
  std::vector<double> lower(kPairs), upper(kPairs);
  BatchAnswers answers;
  answers.lower = lower;
  answers.upper = upper;
  for (int frame = 0; frame < 2; ++frame) {
    batch.growth_distances(bodies.pairs, answers, warm);
    for (std::size_t i = 0; i < kPairs; ++i) {
      EXPECT_EQ(warm[i].dimension, 3);
      const DistanceResult& r = alone.solve_about_centers(bodies.pairs[i].first, bodies.pairs[i].second);
      EXPECT_LE(lower[i], r.upper);
      EXPECT_GE(upper[i], r.lower);
      EXPECT_LE(upper[i] - lower[i], 1e-6 * upper[i]);
    }
  }
}

TEST(PairBatch, RefusesArraysOfAnotherSizeAndBodiesOfOtherSpaces) {
  const Bodies bodies;
  PairBatch batch(options_for(2));
  std::vector<double> few(kPairs - 1);
  BatchAnswers answers;
  answers.normal = few;
  EXPECT_THROW(batch.distances(bodies.pairs, metric(), answers), InvalidParameterError);
  std::vector<WarmStart> warm(3);
  EXPECT_THROW(batch.growth_distances(bodies.pairs, {}, warm), InvalidParameterError);
  const Ball disc(Eigen::Vector2d::Zero(), 1);
  EXPECT_THROW(batch.distances(bodies.pairs, disc, {}), DimensionMismatchError);
  EXPECT_THROW(PairBatch(options_for(0)), InvalidParameterError);
  batch.growth_distances({}, {});
}

}  // namespace
}  // namespace raygauge::test_pair_batch
