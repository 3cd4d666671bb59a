// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/text/number_words.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace raygauge::test_number_words {
namespace {

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
  EXPECT_EQ(padded_significant(-infinity, 3), "-inf");
  EXPECT_EQ(padded_significant(std::nan(""), 3), "nan");
}

}  // namespace
}  // namespace raygauge::test_number_words
