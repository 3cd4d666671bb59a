// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/threads/thread_pin.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <algorithm>
#include <set>

namespace raygauge::test_thread_pin {
namespace {

std::set<int> current_mask() {
  cpu_set_t mask;
  CPU_ZERO(&mask);
  EXPECT_EQ(sched_getaffinity(0, sizeof mask, &mask), 0);
  std::set<int> cpus;
  for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
    if (CPU_ISSET(cpu, &mask)) cpus.insert(cpu);
  }
  return cpus;
}

TEST(ThreadPin, AllowedCpusAreThoseOfTheAffinityMask) {
  const std::vector<int> cpus = allowed_cpus();
  EXPECT_EQ(std::set<int>(cpus.begin(), cpus.end()), current_mask());
  EXPECT_EQ(cpus.size(), current_mask().size());
}

TEST(ThreadPin, HoldsTheThreadAndGivesTheMaskBack) {
  const std::set<int> before = current_mask();
  for (const int cpu : allowed_cpus()) {
    const ThreadPin pin(cpu);
    EXPECT_TRUE(pin.pinned());
    EXPECT_EQ(current_mask(), std::set<int>({cpu}));
    EXPECT_EQ(allowed_cpus(), std::vector<int>({cpu}));
  }
  EXPECT_EQ(current_mask(), before);
}

TEST(ThreadPin, TheCpuThatTheThreadRunsOnComesFirst) {
  constexpr int kTries = 1000;  // the system may move the thread meanwhile
  for (const int cpu : allowed_cpus()) {
    { const ThreadPin pin(cpu); }  // leaves the thread on that CPU, for a while
    for (int i = 0; i < kTries; ++i) {
      const int before = sched_getcpu();
      const std::vector<int> cpus = allowed_cpus_from_here();
      if (sched_getcpu() != before) continue;
      EXPECT_EQ(cpus.front(), before);
      EXPECT_EQ(std::set<int>(cpus.begin(), cpus.end()), current_mask());
      EXPECT_EQ(cpus.size(), current_mask().size());
      break;
    }
  }
}

TEST(ThreadPin, ACpuThatDoesNotExistLeavesTheThreadFree) {
  const std::set<int> before = current_mask();
  const ThreadPin pin(CPU_SETSIZE - 1);
  EXPECT_FALSE(pin.pinned());
  EXPECT_EQ(current_mask(), before);
}

}  // namespace
}  // namespace raygauge::test_thread_pin
