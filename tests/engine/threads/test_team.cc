// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/threads/team.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "engine/threads/thread_pin.h"

namespace raygauge::test_team {
namespace {

TEST(Team, EveryMemberWorksOnce) {
  std::mutex mutex;
  std::multiset<int> seen;
  run_team(3, {}, [&](int thread, int size) {
    const std::lock_guard lock(mutex);
    EXPECT_EQ(size, 3);
    seen.insert(thread);
  });
  EXPECT_EQ(seen, (std::multiset<int>{0, 1, 2}));
}

TEST(Team, TheFirstExceptionIsRethrownWhenAllHaveReturned) {
  std::atomic<int> returned{0};
  EXPECT_THROW(run_team(2, {},
                        [&](int thread, int) {
                          if (thread == 1) throw std::out_of_range("broken");
                          ++returned;
                        }),
               std::out_of_range);
  EXPECT_EQ(returned, 1);
}

TEST(Team, MembersArePinnedToTheirCpus) {
  const std::vector<int> cpus = allowed_cpus();
  run_team(static_cast<int>(cpus.size()), cpus, [&](int thread, int) {
    EXPECT_EQ(allowed_cpus(), std::vector<int>({cpus[static_cast<std::size_t>(thread)]}));
  });
  EXPECT_EQ(allowed_cpus(), cpus);
}

TEST(Team, NobodyIsPinnedWhereThreadsOutnumberCpus) {
  const std::vector<int> cpus = allowed_cpus();
  run_team(static_cast<int>(cpus.size()) + 1, cpus, [&](int, int) { EXPECT_EQ(allowed_cpus(), cpus); });
}

}  // namespace
}  // namespace raygauge::test_team
