// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/repetitions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <span>

#include "engine/sweep/order_statistics.h"

namespace raygauge::test_repetitions {
namespace {

Experiment adaptive(double within, int fewest, int most) {
  Experiment experiment;
  experiment.stop_when_within = within;
  experiment.min_repetitions = fewest;
  experiment.repetitions = most;
  return experiment;
}

Record solve(double seconds) {
  Record record;
  record.seconds = seconds;
  return record;
}

Record unsolved() {
  Record record;
  record.seconds = 1;
  record.status = DistanceStatus::time_limit;
  return record;
}

std::vector<Record> solves(const std::vector<double>& seconds) {
  std::vector<Record> records;
  for (const double each : seconds) records.push_back(solve(each));
  return records;
}

TEST(NextLook, IsTheEndWhereTheNumberIsFixed) { EXPECT_EQ(next_look(adaptive(0, 10, 25), 0), 25); }

TEST(NextLook, ComesAfterAQuarterMore) {
  const Experiment experiment = adaptive(0.1, 10, 40);
  std::vector<int> looks;
  for (int done = 0; done < 40; done = looks.back()) looks.push_back(next_look(experiment, done));
  EXPECT_EQ(looks, (std::vector<int>{10, 13, 17, 22, 28, 35, 40}));
  EXPECT_EQ(next_look(adaptive(0.1, 10, 2147483647), 2000000000), 2147483647);
}

TEST(MediansKnown, WhereTheIntervalIsNarrowAgainstTheMedian) {
  // Eight values: [x_(1), x_(8)] = [95, 105], 10 % of the median 100.
  const std::vector<Record> records = solves({95, 105, 99, 101, 98, 102, 97, 103});
  EXPECT_TRUE(medians_known(records, 1, 0.1));
  EXPECT_FALSE(medians_known(records, 1, 0.0999));
}

TEST(MediansKnown, NotWithFiveValuesHoweverEqual) {
  EXPECT_FALSE(medians_known(solves({1, 1, 1, 1, 1}), 1, 1));
  EXPECT_TRUE(medians_known(solves({1, 1, 1, 1, 1, 1}), 1, 1e-9));
}

TEST(MediansKnown, OfEveryMethodAndNotOfSome) {
  std::vector<Record> records;
  for (int repetition = 0; repetition < 6; ++repetition) {
    records.push_back(solve(1));
    records.push_back(solve(repetition + 1));
  }
  EXPECT_FALSE(medians_known(records, 2, 0.5));
  for (std::size_t i = 1; i < records.size(); i += 2) records[i].seconds = 1e-3;
  EXPECT_TRUE(medians_known(records, 2, 0.5));
}

TEST(MediansKnown, AMethodThatNeverSolvesIsKnownNotTo) {
  EXPECT_TRUE(medians_known(std::vector<Record>(8, unsolved()), 1, 0.05));
}

TEST(MediansKnown, AMethodThatSolvesNowAndThenIsNot) {
  std::vector<Record> records(8, unsolved());
  for (std::size_t i = 0; i < 4; ++i) records[i] = solve(1);
  EXPECT_FALSE(medians_known(records, 1, 0.5));
}

TEST(MediansKnown, FailuresBeyondTheIntervalDoNotKeepItOpen) {
  // 20 values: [x_(6), x_(15)]; five failures stand beyond it.
  std::vector<Record> records(20, solve(1));
  for (std::size_t i = 0; i < 5; ++i) records[i] = unsolved();
  EXPECT_TRUE(medians_known(records, 1, 0.05));
  records[5] = unsolved();
  EXPECT_FALSE(medians_known(records, 1, 0.05));
}

TEST(MediansKnown, TimesOfRecordsThatDisagreeDoNotCount) {
  std::vector<Record> records(9, solve(1));
  records.front() = solve(50);
  records.front().agrees = false;
  EXPECT_TRUE(medians_known(records, 1, 0.05));
  for (std::size_t i = 0; i < 4; ++i) records[i].agrees = false;
  EXPECT_FALSE(medians_known(records, 1, 0.05)) << "five are left";
}

/// The share of cells in which the interval at the look that ended them covers the true median, 1, of
/// lognormal times.
double coverage_at_the_end(const Experiment& experiment, double sigma, int cells) {
  std::mt19937_64 random(5);
  std::lognormal_distribution<double> seconds(0, sigma);
  std::vector<Record> records(static_cast<std::size_t>(experiment.repetitions), solve(1));
  int covered = 0;
  for (int cell = 0; cell < cells; ++cell) {
    std::span<Record> done;
    do {
      const auto look = static_cast<std::size_t>(next_look(experiment, static_cast<int>(done.size())));
      for (Record& record : std::span(records).subspan(done.size(), look - done.size())) {
        record.seconds = seconds(random);
      }
      done = std::span(records).first(look);
    } while (done.size() < records.size() && !medians_known(done, 1, experiment.stop_when_within));
    std::vector<double> times;
    for (const Record& record : done) times.push_back(record.seconds);
    const auto interval = order_statistic_interval(times);
    if (interval->lower <= 1 && 1 <= interval->upper) ++covered;
  }
  return static_cast<double>(covered) / cells;
}

TEST(MediansKnown, LookingAgainAndAgainCostsLittleOfTheConfidence) {
  // 2000 cells: the standard deviation of a share of 95 % is 0.5 %.
  for (const double sigma : {0.1, 0.3, 1.0}) {
    for (const double within : {0.05, 0.2}) {
      EXPECT_GE(coverage_at_the_end(adaptive(within, 10, 1000), sigma, 2000), 0.93)
          << sigma << ", " << within;
    }
  }
}

}  // namespace
}  // namespace raygauge::test_repetitions
