// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/output/terminal.h"

#include <gtest/gtest.h>

#include <memory>

namespace raygauge::cli::test_terminal {
namespace {

TEST(DurationText, SaysItAsOneWould) {
  EXPECT_EQ(duration_text(0.04), "0.0 s");
  EXPECT_EQ(duration_text(9.94), "9.9 s");
  EXPECT_EQ(duration_text(9.96), "10 s");
  EXPECT_EQ(duration_text(59.4), "59 s");
  EXPECT_EQ(duration_text(59.6), "1 min 00 s");
  EXPECT_EQ(duration_text(200), "3 min 20 s");
  EXPECT_EQ(duration_text(3900), "1 h 05 min");
}

TEST(Terminal, AFileIsNoneAndGetsNoColour) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), &std::fclose);
  EXPECT_FALSE(is_terminal(file.get()));
  EXPECT_EQ(alarming("wrong", file.get()), "wrong");
}

}  // namespace
}  // namespace raygauge::cli::test_terminal
