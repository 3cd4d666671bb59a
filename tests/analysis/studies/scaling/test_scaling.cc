// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/scaling/scaling.h"

#include <gtest/gtest.h>

#include "tests/analysis/records.h"

namespace raygauge::test_scaling {
namespace {

using raygauge::testing::add_records;

/// 2 N n² microseconds, one outlier in each cell.
std::vector<Record> known_law() {
  std::vector<Record> records;
  for (const int n : {2, 4, 8}) {
    for (const int N : {100, 200, 400}) {
      const double ms = 2e-3 * N * n * n;
      add_records(records, "column_generation", n, N,
                  {ms, 1.01 * ms, 0.99 * ms, ms, 1.005 * ms, 0.995 * ms, 50 * ms});
    }
  }
  return records;
}

TEST(Scaling, RecoversTheExponentsOfAKnownLaw) {
  const std::vector<ScalingCurve> against_N = scaling_curves(known_law(), SizeAxis::N);
  ASSERT_EQ(against_N.size(), 3U);
  EXPECT_EQ(against_N[1].cell.n, 4);
  EXPECT_EQ(against_N[1].sizes, (std::vector<double>{100, 200, 400}));
  for (const ScalingCurve& curve : against_N) EXPECT_NEAR(fit_scaling(curve).exponent, 1, 1e-9);
  for (const ScalingCurve& curve : scaling_curves(known_law(), SizeAxis::n))
    EXPECT_NEAR(fit_scaling(curve).exponent, 2, 1e-9);
}

TEST(Scaling, FlagsOutliersWithoutDroppingThem) {
  const ScalingCurve curve = scaling_curves(known_law(), SizeAxis::N).front();
  EXPECT_EQ(curve.outliers.front(), 1U);
  EXPECT_EQ(curve.counts.front(), 7U);
}

TEST(Scaling, NeedsTwoSizesWithAFiniteMedian) {
  std::vector<Record> records = known_law();
  for (Record& record : records)
    if (record.N > 100) record.status = DistanceStatus::time_limit;
  EXPECT_TRUE(scaling_curves(records, SizeAxis::N).empty());
  EXPECT_EQ(scaling_curves(records, SizeAxis::n).size(), 1U);
}

}  // namespace
}  // namespace raygauge::test_scaling
