// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "tests/engine/both_methods.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_solver_threads {
namespace {

using Threads = BothMethods;
RAYGAUGE_BOTH_METHODS(Threads);

TEST_P(Threads, SharingTheSameSetsGetTheBitsOfASerialRun) {
  Random random(111);
  std::vector<std::unique_ptr<PointSet>> sets;
  for (int pair = 0; pair < 12; ++pair) {
    const int n = 2 + pair % 6;
    const int N = pair % 3 == 0 ? 3000 : 150;
    Eigen::MatrixXd a = sphere_points(n, N, random);
    a.row(0).array() += 3;
    sets.push_back(std::make_unique<PointSet>(a));
    sets.push_back(std::make_unique<PointSet>(sphere_points(n, N, random)));
  }
  const auto solve_all = [&](std::vector<DistanceResult>& results) {
    DistanceSolver solver(options(1e-9));
    for (std::size_t i = 0; i < sets.size(); i += 2) {
      results.push_back(solver.solve(*sets[i], *sets[i + 1], Effects::witness));
    }
  };

  std::vector<DistanceResult> serial;
  solve_all(serial);
  std::array<std::vector<DistanceResult>, 2> parallel;
  std::thread first(solve_all, std::ref(parallel[0]));
  std::thread second(solve_all, std::ref(parallel[1]));
  first.join();
  second.join();

  for (const auto& results : parallel) {
    ASSERT_EQ(results.size(), serial.size());
    for (std::size_t i = 0; i < serial.size(); ++i) expect_same_bits(results[i], serial[i]);
  }
}

}  // namespace
}  // namespace raygauge::test_solver_threads
