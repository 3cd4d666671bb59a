// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/numerics/number_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "raygauge/sweep/registry.h"

namespace raygauge::test_number_text {
namespace {

TEST(NumberText, IsAsShortAsItsDigitsAllow) {
  EXPECT_EQ(rounded_text(0.25, 6), "0.25");
  EXPECT_EQ(rounded_text(1e-6, 6), "1e-6");
  EXPECT_EQ(rounded_text(1.5e-10, 6), "1.5e-10");
  EXPECT_EQ(rounded_text(1e20, 6), "1e20");
  EXPECT_EQ(rounded_text(2.0 / 3, 3), "0.667");
}

TEST(NumberText, HasAnExponentBelowAHundredth) {
  EXPECT_EQ(rounded_text(0.01, 6), "0.01");
  EXPECT_EQ(rounded_text(0.001, 6), "1e-3");
  EXPECT_EQ(rounded_text(-0.0012, 6), "-1.2e-3");
  EXPECT_EQ(rounded_text(0.009996, 3), "0.01");
  EXPECT_EQ(rounded_text(0.00995, 1), "0.01");
  EXPECT_EQ(rounded_text(0, 6), "0");
}

TEST(NumberText, IsTheSameWithAllDigitsAsWithSix) {
  for (const double value : {1e-300, 1e-8, 2.5e-5, 1e-4, 1e-3, 5e-3, 0.01, 0.1, 1.5, 100.0, 1e5, 1e6, 1e20})
    EXPECT_EQ(shortest_text(value), rounded_text(value, 6));
  EXPECT_EQ(shortest_text(-std::numeric_limits<double>::infinity()), "-inf");
  EXPECT_EQ(shortest_text(std::nan("")), "nan");
}

TEST(NumberText, SurvivesARoundTrip) {
  for (const double value : {0.1, 1.0 / 3, 1e-3 / 3, 1e-300, 5e-324, 123456789.123456789, 1.2e5, 1.7e308})
    EXPECT_EQ(std::strtod(shortest_text(value).c_str(), nullptr), value);
}

}  // namespace
}  // namespace raygauge::test_number_text
