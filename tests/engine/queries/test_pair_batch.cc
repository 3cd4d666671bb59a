// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/pair_batch.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <deque>
#include <functional>
#include <memory>
#include <random>
#include <vector>

#include "raygauge/exceptions.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/queries/solver.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/point_set.h"
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

  BatchAnswers spans() {
    BatchAnswers answers;
    answers.distance = distance;
    answers.lower = lower;
    answers.upper = upper;
    answers.status = status;
    answers.normal = normal;
    answers.closest_points_1 = points_1;
    answers.closest_points_2 = points_2;
    return answers;
  }
};

const Ball& metric() {
  static const Ball kBall(Eigen::Vector3d::Zero(), 1);
  return kBall;
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

TEST(PairBatch, HasTheGradientsByPoseOfSingleQueries) {
  const Bodies bodies;
  ObjectDistanceSolver alone(options_for(1));
  PairBatch batch(options_for(2));
  std::vector<GradientKind> kinds(kPairs, GradientKind::undecided);
  std::vector<double> first(std::size_t{6} * kPairs), second = first;
  BatchAnswers answers;
  answers.gradient_kind = kinds;
  answers.pose_gradients_1 = first;
  answers.pose_gradients_2 = second;
  batch.distances(bodies.pairs, metric(), answers);
  std::size_t unique = 0;
  for (std::size_t i = 0; i < kPairs; ++i) {
    const PoseGradient& gradient =
        alone.solve(bodies.pairs[i].first, bodies.pairs[i].second, metric(), ObjectEffects::pose_gradient)
            .pose_gradient;
    EXPECT_EQ(kinds[i], gradient.kind);
    if (gradient.kind == GradientKind::none) {
      EXPECT_TRUE(std::isnan(first[6 * i]));
      continue;
    }
    unique += gradient.kind == GradientKind::unique ? 1 : 0;
    EXPECT_EQ(first[6 * i + 1], gradient.body_1.linear.y);
    EXPECT_EQ(first[6 * i + 5], gradient.body_1.angular.z);
    EXPECT_EQ(second[6 * i], gradient.body_2.linear.x);
    EXPECT_EQ(second[6 * i + 3], gradient.body_2.angular.x);
  }
  EXPECT_GT(unique, kPairs / 2);
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

TEST(PairBatch, GivesMinusTheDepthOfBodiesThatMeetWhereThatIsAskedFor) {
  const Bodies bodies;
  ObjectDistanceSolver alone(options_for(1));
  PairBatch batch(options_for(1), 3);
  Answers answers;
  const auto source = [&](std::size_t i, int /*thread*/) { return bodies.pairs[i]; };
  batch.distances(kPairs, source, metric(), answers.spans(), ObjectEffects::depth);
  int overlaps = 0;
  for (std::size_t i = 0; i < kPairs; ++i) {
    const ObjectDistance& r = alone.solve(bodies.pairs[i].first, bodies.pairs[i].second, metric(),
                                          ObjectEffects::closest_points | ObjectEffects::depth);
    const bool inside = r.depth.evaluations > 0;
    overlaps += inside ? 1 : 0;
    EXPECT_EQ(answers.distance[i], r.signed_distance());
    EXPECT_EQ(answers.lower[i], inside ? -r.depth.upper : r.distance.lower);
    EXPECT_EQ(answers.upper[i], inside ? -r.depth.lower : r.distance.upper);
    EXPECT_EQ(answers.status[i], inside ? r.depth.status : r.distance.status);
    expect_vector(answers.normal, i, inside ? r.depth.normal : r.distance.normal);
    expect_vector(answers.points_1, i, inside ? r.depth.point_1 : r.closest_point_1);
  }
  EXPECT_GT(overlaps, 10);
}

// Sets made for their problem, which a thread keeps until it asks for the next.
struct Problems {
  explicit Problems(int threads) : places(static_cast<std::size_t>(threads)) {}

  PosedPair operator()(std::size_t i, int thread) {
    std::mt19937_64 random(i);
    std::normal_distribution<double> normal;
    Eigen::Matrix3Xd A(3, 12), Q(3, 12);
    for (double& x : A.reshaped()) x = 0.1 * normal(random);
    for (double& x : Q.reshaped()) x = normal(random);
    A.row(0).array() += 2 + 0.01 * static_cast<double>(i);
    Place& place = places[static_cast<std::size_t>(thread)];
    place.A = std::make_unique<PointSet>(A);
    place.Q = std::make_unique<PointSet>(Q);
    return {Posed(*place.A), Posed(*place.Q)};
  }

  struct Place {
    std::unique_ptr<const PointSet> A, Q;
  };
  std::vector<Place> places;
};

TEST(PairBatch, HasGaugeDistancesOfSetsThatAreMadeWhereTheyAreSolved) {
  DistanceSolver alone(options_for(1));
  Problems one(1);
  for (const int threads : {1, 2, 5}) {
    PairBatch batch(options_for(1), threads);
    Problems problems(threads);
    Answers answers;
    std::vector<double> contacts(answers.normal.size());
    std::vector<std::int64_t> pivots(kPairs);
    BatchAnswers spans = answers.spans();
    spans.closest_points_1 = spans.closest_points_2 = {};
    spans.contact_points = contacts;
    spans.pivots = pivots;
    batch.gauge_distances(kPairs, std::ref(problems), 3, spans);
    for (std::size_t i = 0; i < kPairs; ++i) {
      const PosedPair pair = one(i, 0);
      const DistanceResult& r = alone.solve(pair.first, pair.second, Effects::witness);
      EXPECT_EQ(answers.lower[i], r.lower);
      EXPECT_EQ(answers.upper[i], r.upper);
      EXPECT_EQ(answers.status[i], r.status);
      EXPECT_EQ(pivots[i], r.counters.pivots);
      expect_vector(answers.normal, i, r.normal);
      expect_vector(contacts, i, r.contact_point);
    }
  }
}

TEST(PairBatch, GivesTheSameAnswersAlongAPathOnAnyNumberOfThreads) {
  const Ball ball(Eigen::Vector3d::Zero(), 1);
  std::deque<Pose> poses;
  for (int i = 0; i < kPairs; ++i)
    poses.emplace_back(Eigen::Quaterniond(1, 0.01 * i, 0, 0), Eigen::Vector3d(3, 0.01 * i, 0));
  const Box box(Eigen::Vector3d(-0.5, -0.3, -0.2), Eigen::Vector3d(0.5, 0.3, 0.2));
  const auto source = [&](std::size_t i, int /*thread*/) { return PosedPair{{box, poses[i]}, Posed(ball)}; };
  std::vector<double> expected(kPairs), upper(kPairs);
  for (const int threads : {1, 2, 4}) {
    PairBatch batch(options_for(1), threads);
    BatchAnswers answers;
    std::vector<double> lower(kPairs);
    answers.lower = threads == 1 ? expected : lower;
    answers.upper = upper;
    batch.gauge_distances(kPairs, source, 3, answers, true);
    if (threads > 1) {
      EXPECT_EQ(lower, expected);
    }
    for (std::size_t i = 0; i < kPairs; ++i) EXPECT_LE(upper[i] - expected[i], 1e-6 * upper[i]);
  }
}

TEST(PairBatch, NamesThePairOfAnErrorAndEndsWithIt) {
  const Bodies bodies;
  for (const int threads : {1, 3}) {
    PairBatch batch(options_for(1), threads);
    const auto source = [&](std::size_t i, int /*thread*/) -> PosedPair {
      if (i == 70) throw NonFiniteError("no number");
      return bodies.pairs[i];
    };
    try {
      batch.distances(kPairs, source, metric(), {});
      ADD_FAILURE() << "nothing was thrown";
    } catch (const NonFiniteError& error) {
      EXPECT_STREQ(error.what(), "problem 70: no number");
    }
  }
}

TEST(PairBatch, BeginsNoPairAfterItIsStopped) {
  const Bodies bodies;
  for (const int threads : {1, 3}) {
    PairBatch batch(options_for(1), threads);
    std::atomic<int> asked = 0;
    std::atomic<bool> stop = false;
    batch.set_stop([&stop] { return stop.load(); });
    const auto source = [&](std::size_t i, int /*thread*/) {
      if (++asked == 20) stop = true;
      return bodies.pairs[i];
    };
    batch.distances(kPairs, source, metric(), {});
    EXPECT_GE(asked, 20);
    EXPECT_LT(asked, 20 + threads);
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
  EXPECT_THROW(PairBatch(options_for(1), -1), InvalidParameterError);
  EXPECT_THROW(PairBatch(options_for(1), kMostBatchThreads + 1), InvalidParameterError);
  batch.growth_distances({}, {});
}

}  // namespace
}  // namespace raygauge::test_pair_batch
