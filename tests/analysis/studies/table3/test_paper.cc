// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/table3/paper.h"

#include <gtest/gtest.h>

#include <cmath>

namespace raygauge::test_paper {
namespace {

// Transcriptions are checked by what a typing slip would break: spot values read off the paper, sums, and the
// order that the paper describes.

TEST(PaperTable3, HoldsItsCornersAndSomeOfItsMiddle) {
  const auto cell = [](int n, int N) { return paper::table3_cell(n, N).value(); };
  EXPECT_EQ(cell(3, 200).milliseconds, 1.36);
  EXPECT_EQ(cell(3, 200).ratio, 0.19);
  EXPECT_EQ(cell(3, 2000).ratio, 0.06);
  EXPECT_EQ(cell(10, 200).ratio, 0.99);
  EXPECT_EQ(cell(10, 2000).milliseconds, 30.04);
  EXPECT_EQ(cell(7, 1600).milliseconds, 11.64);
  EXPECT_EQ(cell(8, 1800).ratio, 0.22);
  EXPECT_FALSE(paper::table3_cell(2, 200));
  EXPECT_FALSE(paper::table3_cell(3, 300));
}

TEST(PaperTable3, RisesWithTheDimensionAndTheRatioFallsWithThePoints) {
  for (const int n : paper::kTable3Dimensions) {
    for (const int N : paper::kTable3Points) {
      const auto cell = paper::table3_cell(n, N).value();
      if (n > 3) {
        const auto flatter = paper::table3_cell(n - 1, N).value();
        EXPECT_GT(cell.milliseconds, flatter.milliseconds) << n << " " << N;
        EXPECT_GT(cell.ratio, flatter.ratio) << n << " " << N;
      }
      if (N > 200) {
        const auto smaller = paper::table3_cell(n, N - 200).value();
        EXPECT_GT(cell.milliseconds, smaller.milliseconds) << n << " " << N;
        EXPECT_LE(cell.ratio, smaller.ratio) << n << " " << N;
      }
    }
  }
}

TEST(PaperTable1And2, HaveErrorsBelowTheToleranceAndCostsThatRise) {
  for (const auto* table : {&paper::table1(), &paper::table2()}) {
    for (std::size_t i = 0; i < table->size(); ++i) {
      const paper::AccuracyRow& row = (*table)[i];
      EXPECT_NEAR(std::log10(row.tolerance), -2.0 - static_cast<double>(i), 1e-12);
      EXPECT_GT(row.error, 0.1 * row.tolerance);
      EXPECT_LT(row.error, 0.2 * row.tolerance);
      if (i == 0) continue;
      EXPECT_GT(row.milliseconds, (*table)[i - 1].milliseconds);
      EXPECT_GT(row.K, (*table)[i - 1].K);
      EXPECT_GT(row.N_rs, (*table)[i - 1].N_rs);
    }
  }
  EXPECT_EQ(paper::table1()[4].N_rs, 42.67);
  EXPECT_EQ(paper::table1()[8].active_set_error, 7.67e-12);
  EXPECT_EQ(paper::table2()[8].milliseconds, 6.76);
  EXPECT_EQ(paper::table2()[3].active_set_milliseconds, 20.20);
}

}  // namespace
}  // namespace raygauge::test_paper
