// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/hdf5/trial.h"

#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>

namespace raygauge::test_trial {
namespace {

TEST(Trial, ToldApartWorkThatEndsFromWorkThatDoesNot) {
  EXPECT_TRUE(hdf5::survives([] {}, 1));
  EXPECT_TRUE(hdf5::survives([] { throw std::runtime_error("an error is an end"); }, 1));
  EXPECT_FALSE(hdf5::survives([] { std::raise(SIGSEGV); }, 1));
  EXPECT_FALSE(hdf5::survives([] { std::raise(SIGABRT); }, 1));
}

TEST(Trial, EndsWorkThatTakesTooLong) {
  volatile bool never = false;
  EXPECT_FALSE(hdf5::survives(
      [&never] {
        while (!never) continue;
      },
      1));
}

TEST(Trial, ChangesNothingHere) {
  int value = 1;
  EXPECT_TRUE(hdf5::survives([&value] { value = 2; }, 1));
  EXPECT_EQ(value, 1);
}

}  // namespace
}  // namespace raygauge::test_trial
