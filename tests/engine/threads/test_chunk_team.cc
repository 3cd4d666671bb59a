// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/threads/chunk_team.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace raygauge::test_chunk_team {
namespace {

TEST(ChunkTeam, DoesEveryChunkOnceInEachOfManyRuns) {
  for (const int threads : {1, 2, 5}) {
    ChunkTeam team;
    team.resize(threads);
    for (int run = 0; run < 2000; ++run) {
      const int chunks = run % 40;
      std::vector<std::atomic<int>> done(40);
      team.run(chunks, run % 3 == 0, [&](int chunk) { ++done[static_cast<std::size_t>(chunk)]; });
      for (int chunk = 0; chunk < 40; ++chunk)
        ASSERT_EQ(done[static_cast<std::size_t>(chunk)], chunk < chunks ? 1 : 0) << threads << ' ' << run;
    }
  }
}

TEST(ChunkTeam, LendsItsHelpers) {
  ChunkTeam team;
  team.resize(2);
  std::atomic<bool> helped{false};
  const std::thread::id caller = std::this_thread::get_id();
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!helped && std::chrono::steady_clock::now() < until) {
    team.run(2, true, [&](int) {
      if (std::this_thread::get_id() != caller) helped = true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    });
  }
  EXPECT_TRUE(helped);
}

TEST(ChunkTeam, ReturnsOnlyWhenTheLastChunkIsDone) {
  ChunkTeam team;
  team.resize(3);
  for (int run = 0; run < 50; ++run) {
    std::atomic<int> done{0};
    team.run(3, true, [&](int) {
      std::this_thread::sleep_for(std::chrono::microseconds(300));
      ++done;
    });
    ASSERT_EQ(done, 3);
  }
}

TEST(ChunkTeam, ChangesItsSize) {
  ChunkTeam team;
  for (const int threads : {3, 1, 2, 2, 4}) {
    team.resize(threads);
    std::atomic<int> sum{0};
    team.run(10, true, [&](int chunk) { sum += chunk; });
    EXPECT_EQ(sum, 45);
  }
}

}  // namespace
}  // namespace raygauge::test_chunk_team
