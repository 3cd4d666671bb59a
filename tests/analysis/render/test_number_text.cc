// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/number_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace raygauge::test_number_text {
namespace {

TEST(NumberText, IsAsShortAsItsDigitsAllow) {
  EXPECT_EQ(significant(0.25, 6), "0.25");
  EXPECT_EQ(significant(1e-6, 6), "1e-6");
  EXPECT_EQ(significant(1.5e-10, 6), "1.5e-10");
  EXPECT_EQ(significant(1e20, 6), "1e20");
  EXPECT_EQ(significant(2.0 / 3, 3), "0.667");
}

TEST(NumberText, PadsToItsDigits) {
  EXPECT_EQ(padded_significant(0.012, 3), "0.0120");
  EXPECT_EQ(padded_significant(1.36, 3), "1.36");
  EXPECT_EQ(padded_significant(9.996, 3), "10.0");
  EXPECT_EQ(padded_significant(123.4, 3), "123");
  EXPECT_EQ(padded_significant(1234.4, 3), "1234");
  EXPECT_EQ(padded_significant(1.2e-7, 2), "1.2e-7");
  EXPECT_EQ(padded_significant(0, 3), "0");
  EXPECT_EQ(padded_significant(-0.5, 2), "-0.50");
}

TEST(NumberText, NamesWhatIsNotFinite) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(significant(infinity, 3), "inf");
  EXPECT_EQ(padded_significant(-infinity, 3), "-inf");
  EXPECT_EQ(round_trip(std::nan("")), "nan");
}

TEST(NumberText, SurvivesARoundTrip) {
  for (const double value : {0.1, 1.0 / 3, 1e-300, 123456789.123456789})
    EXPECT_EQ(std::stod(round_trip(value)), value);
}

}  // namespace
}  // namespace raygauge::test_number_text
