// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "raygauge/scene/edge_checker.h"
#include "tests/counted_allocations.h"
#include "tests/scene/planning/random_robots.h"

namespace raygauge::test_edge_allocations {
namespace {

#if RAYGAUGE_COUNTS_ALLOCATIONS
TEST(EdgeChecker, ARepeatedEdgeAllocatesNothing) {
  using namespace random_robots;
  Random random(7);
  int contacts = 0, edges = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const RobotModel model = robot(random);
    EdgeChecker checker(model, obstacles(random, 4, 3));
    std::vector<std::vector<double>> q;
    for (int k = 0; k < 6; ++k) q.push_back(configuration(random, model, 1));
    const auto walk = [&] {
      for (std::size_t k = 0; k + 1 < q.size(); ++k) {
        if (checker.edge(q[k], q[k + 1]).outcome == EdgeOutcome::contact) ++contacts;
        checker.configuration(q[k], 0.5);
        ++edges;
      }
    };
    walk();
    walk();
    const long before = allocations;
    walk();
    EXPECT_EQ(allocations - before, 0) << trial;
  }
  EXPECT_GT(contacts, 50);
  EXPECT_LT(contacts, edges - 50);
}
#endif

}  // namespace
}  // namespace raygauge::test_edge_allocations
