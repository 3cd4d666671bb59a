// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/queries/part_order.h"

#include <gtest/gtest.h>

#include <limits>

#include "scene/queries/pair_solver.h"
#include "tests/scene/random_scenes.h"

namespace raygauge::test_part_order {
namespace {

using namespace random_scenes;

const SceneMetric kEuclidean;

/// Parts of the same few shapes anywhere in a cube; without a tree, if so is asked.
Body scattered(Random& random, int n, int parts, double size, bool with_tree = true) {
  std::vector<SetPointer> sets;
  for (int i = 0; i < parts; ++i) {
    const Vector c = uniform_vector(random, n, size);
    if (i % 3 == 0) {
      sets.push_back(std::make_shared<Ball>(c, uniform(random, 0, 0.2)));
    } else {
      sets.push_back(std::make_shared<Box>(c, c + Vector::Constant(n, uniform(random, 0.01, 0.3))));
    }
  }
  Body body = make_body("scattered", sets, std::make_shared<StaticMotion>(Placement::identity(n)));
  if (!with_tree) body.tree = nullptr;
  return body;
}

Body without_tree(Body body) {
  body.tree = nullptr;
  return body;
}

TEST(PartOrder, TreesKeepTheOrderOfAllPairs) {
  Random random(7);
  for (const int n : {2, 3}) {
    for (const auto& [parts_a, parts_b] : {std::pair(40, 30), {200, 1}, {1, 90}, {100, 5}}) {
      const Body a = scattered(random, n, parts_a, 2), b = scattered(random, n, parts_b, 2);
      const Body flat_a = without_tree(a), flat_b = without_tree(b);
      EXPECT_EQ(a.tree != nullptr, parts_a >= 8);
      PlacedPair placed(n);
      placed.bind(a, b, kEuclidean);
      placed.place(placement(random, n, 3), placement(random, n, 3), nullptr);
      PartOrder order, all;
      order.bind(a, b);
      all.bind(flat_a, flat_b);
      std::int64_t tests = 0, tests_of_all = 0;
      order.begin(placed, tests);
      all.begin(placed, tests_of_all);
      for (int k = 0; k < parts_a * parts_b; ++k) {
        const PartCandidate *one = order.next(), *other = all.next();
        ASSERT_NE(one, nullptr);
        ASSERT_NE(other, nullptr);
        EXPECT_EQ(one->ball_bound, other->ball_bound);
        EXPECT_EQ(one->parts.a, other->parts.a);
        EXPECT_EQ(one->parts.b, other->parts.b);
        if (k == 0 && parts_a > 50) {
          EXPECT_LT(4 * tests, tests_of_all);
        }
      }
      EXPECT_EQ(order.next(), nullptr);
      EXPECT_EQ(all.next(), nullptr);
    }
  }
}

// Every answer is the same to the last bit, and planes that are kept prove no less.
TEST(PartOrder, AnswersOfManyPartsAreThoseOfAllPairs) {
  Random random(8);
  for (int trial = 0; trial < 40; ++trial) {
    const int n = trial % 2 == 0 ? 3 : 2;
    const Body a = scattered(random, n, 50, 1), b = scattered(random, n, 40, 1);
    const Body flat_a = without_tree(a), flat_b = without_tree(b);
    PairSolver solver(n), flat(n);
    solver.bind(a, b, kEuclidean);
    flat.bind(flat_a, flat_b, kEuclidean);
    PairMemory memory, memory_of_flat;
    Placement where = placement(random, n, trial % 4 < 2 ? 5 : 1);
    for (int frame = 0; frame < 4; ++frame) {
      solver.place(Placement::identity(n), where);
      flat.place(Placement::identity(n), where);
      double rate = 0, rate_of_flat = 0;
      EXPECT_EQ(solver.plane_bound(memory, rate), flat.plane_bound(memory_of_flat, rate_of_flat));
      const PairAnswer& one = solver.distance(memory, std::numeric_limits<double>::infinity(), true, false);
      const PairAnswer& other =
          flat.distance(memory_of_flat, std::numeric_limits<double>::infinity(), true, false);
      EXPECT_EQ(one.lower, other.lower);
      EXPECT_EQ(one.upper, other.upper);
      EXPECT_EQ(one.part_a, other.part_a);
      EXPECT_EQ(one.part_b, other.part_b);
      EXPECT_EQ(solver.separation(memory), flat.separation(memory_of_flat));
      if (trial < 10) {
        EXPECT_EQ(
            solver.signed_distance(memory, std::numeric_limits<double>::infinity()).signed_value(),
            flat.signed_distance(memory_of_flat, std::numeric_limits<double>::infinity()).signed_value());
      }
      where.t[0] += 0.01;
    }
    EXPECT_LT(solver.counters().ball_tests, flat.counters().ball_tests);
    EXPECT_EQ(solver.counters().distance_solves, flat.counters().distance_solves);
  }
}

}  // namespace
}  // namespace raygauge::test_part_order
