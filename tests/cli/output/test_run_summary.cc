// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/output/run_summary.h"

#include <gtest/gtest.h>

#include <limits>

namespace raygauge::cli::test_run_summary {
namespace {

Record record(const std::string& method, int repetition, DistanceStatus status, bool agrees) {
  Record result;
  result.method = method;
  result.repetition = repetition;
  result.status = status;
  result.agrees = agrees;
  return result;
}

Experiment two_methods() {
  Experiment experiment;
  experiment.methods = {{"column_generation", "", {}}, {"glpk_dual", "presolved", {}}};
  return experiment;
}

TEST(RunSummary, CountsDisagreementsByInstanceAndFailuresByMethod) {
  const RunSummary summary =
      summarise(two_methods(), {record("column_generation", 0, DistanceStatus::optimal, false),
                                record("presolved", 0, DistanceStatus::optimal, false),
                                record("column_generation", 1, DistanceStatus::optimal, true),
                                record("presolved", 1, DistanceStatus::time_limit, true)});
  EXPECT_EQ(summary.records, 4u);
  EXPECT_EQ(summary.disagreeing_instances, 1u);
  ASSERT_EQ(summary.methods.size(), 2u);
  EXPECT_EQ(summary.methods[0].disagreements, 1u);
  EXPECT_EQ(summary.methods[0].limits, 0u);
  EXPECT_EQ(summary.methods[1].limits, 1u);
  EXPECT_EQ(summary_text(summary, {}),
            "  agreement  1 instance with DISAGREEMENTS (records: column_generation 1, presolved 1)\n"
            "  unsolved   presolved 1\n");
}

TEST(RunSummary, ProvenAnswersAreNoFailures) {
  const RunSummary summary =
      summarise(two_methods(), {record("column_generation", 0, DistanceStatus::contains_origin, true),
                                record("presolved", 0, DistanceStatus::contains_origin, true),
                                record("column_generation", 1, DistanceStatus::unreachable, true)});
  EXPECT_EQ(summary_text(summary, {2, {{"column_generation", 1, 1.5, 1.5}, {"presolved", 1, 1, 1.0009}}}),
            "  agreement  all methods agree on every instance\n"
            "  unsolved   none\n"
            "  slowdown   of single solves on 2 threads: column_generation 1.500, presolved 1.001\n");
}

TEST(RunSummary, ASlowdownThatIsNoiseIsNotPrinted) {
  const RunSummary summary =
      summarise(two_methods(), {record("column_generation", 0, DistanceStatus::optimal, true)});
  const std::string line = "  slowdown   of single solves on 2 threads: ";
  const auto ends_with = [&](const Calibration& calibration, const std::string& end) {
    return summary_text(summary, calibration).ends_with(line + end + "\n");
  };
  EXPECT_TRUE(
      ends_with({2, {{"column_generation", 1, 1.5, 1.5, 1.2, 1.7}, {"presolved", 1, 1, 1.01, 0.9, 1.1}}},
                "column_generation 1.500"));
  EXPECT_TRUE(ends_with({2, {{"column_generation", 1, 1.5, 1.5, 0, std::numeric_limits<double>::infinity()}}},
                        "none that differs from noise"));
}

TEST(RunSummary, AnAdaptiveRunTellsHowOftenItRepeated) {
  Experiment experiment = two_methods();
  experiment.stop_when_within = 0.1;
  experiment.repetitions = 3;
  std::vector<Record> records;
  for (const int repetition : {0, 1, 2}) {
    records.push_back(record("column_generation", repetition, DistanceStatus::optimal, true));
  }
  records.push_back(record("column_generation", 1, DistanceStatus::optimal, true));
  records.back().cell = 1;
  const RunSummary summary = summarise(experiment, records);
  EXPECT_EQ(summary_text(summary, {}),
            "  agreement  all methods agree on every instance\n"
            "  unsolved   none\n"
            "  repeated   2 to 3 times a cell; 1 of 2 cells ran to the limit\n");
}

}  // namespace
}  // namespace raygauge::cli::test_run_summary
