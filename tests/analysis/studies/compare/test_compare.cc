// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/compare/compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "analysis/statistics/rank_tests.h"
#include "analysis/studies/compare/compare_circumstances.h"
#include "analysis/studies/compare/compare_tables.h"
#include "raygauge/exceptions.h"
#include "tests/analysis/records.h"

namespace raygauge::test_compare {
namespace {

using raygauge::testing::add_records;

/// How long the instances of a grid take: instances differ by a factor of 1.3 (one standard deviation), which
/// both runs share; each measurement by 5 %, and each cell of each run by `drift` (of the machine).
class SimulatedMachine {
 public:
  explicit SimulatedMachine(std::uint64_t seed, double drift = 0.01) : bits_(seed), drift_(drift) {
    for (double& x : instances_) x = std::exp(0.26 * normal_(bits_));
  }

  /// A run in which `slow_method` takes `factor` times as long.
  std::vector<Record> run(const std::string& slow_method = "", double factor = 1) {
    std::vector<Record> records;
    for (const std::string method : {"column_generation", "zheng_yamane", "glpk_dual"}) {
      for (int cell = 0; cell < kCells; ++cell) {
        const double drift = std::exp(drift_ * normal_(bits_)) * (method == slow_method ? factor : 1);
        std::vector<double> times;
        for (int i = 0; i < kRepetitions; ++i)
          times.push_back(instances_[cell * kRepetitions + i] * drift * std::exp(0.05 * normal_(bits_)));
        add_records(records, method, 3 + cell % 4, 200 * (1 + cell / 4), times);
      }
    }
    return records;
  }

 private:
  static constexpr int kCells = 16;
  static constexpr int kRepetitions = 20;
  std::mt19937_64 bits_;
  double drift_;
  std::normal_distribution<double> normal_;
  std::vector<double> instances_ = std::vector<double>(kCells * kRepetitions);
};

constexpr int kTries = 20;
constexpr int kEnough = 19;

TEST(Compare, ReportsNoRegressionBetweenTwoRunsOfOneBuildIn19Of20Tries) {
  int silent = 0;
  for (int attempt = 0; attempt < kTries; ++attempt) {
    SimulatedMachine machine(100 + attempt);
    const std::vector<Record> base = machine.run();
    silent += compare_runs(base, machine.run()).regressed() ? 0 : 1;
  }
  EXPECT_GE(silent, kEnough);
}

TEST(Compare, KeepsTheFamilyWiseLevelWithoutAThreshold) {
  CompareOptions options;
  options.threshold = 0;
  int alarms = 0;
  constexpr int kMany = 100;
  for (int attempt = 0; attempt < kMany; ++attempt) {
    SimulatedMachine machine(1000 + attempt, 0);
    const std::vector<Record> base = machine.run();
    alarms += compare_runs(base, machine.run(), options).regressed() ? 1 : 0;
  }
  EXPECT_LE(alarms, kMany / 20 + 5);  // 5 % and two standard errors
}

/// Whether the method `column_generation`, and no other, has the change.
bool only_column_generation(const Comparison& comparison, Change change) {
  return std::all_of(comparison.methods.begin(), comparison.methods.end(), [&](const MethodChange& method) {
    return (method.change == change) == (method.method == "column_generation");
  });
}

TEST(Compare, SuspectsASlowdownOfTenPercentInOneRunASideAndRaisesNoAlarm) {
  int suspected = 0;
  for (int attempt = 0; attempt < kTries; ++attempt) {
    SimulatedMachine machine(200 + attempt);
    const std::vector<Record> base = machine.run();
    const Comparison comparison = compare_runs(base, machine.run("column_generation", 1.1));
    EXPECT_FALSE(comparison.regressed());
    suspected += only_column_generation(comparison, Change::suspected_slower) ? 1 : 0;
  }
  EXPECT_GE(suspected, kEnough);
}

/// `count` runs a side, in which `slow_method` of the new ones takes `factor` times as long.
std::pair<Runs, Runs> several_runs(SimulatedMachine& machine, int count, double factor) {
  Runs base;
  Runs fresh;
  for (int k = 0; k < count; ++k) {
    base.push_back(machine.run());
    fresh.push_back(machine.run("column_generation", factor));
  }
  return {base, fresh};
}

TEST(Compare, FindsASlowdownOfTenPercentInFivePairsIn19Of20Tries) {
  CompareOptions options;
  options.paired = true;
  int found = 0;
  for (int attempt = 0; attempt < kTries; ++attempt) {
    SimulatedMachine machine(300 + attempt, 0.04);
    const auto [base, fresh] = several_runs(machine, 5, 1.1);
    const Comparison comparison = compare_runs(base, fresh, options);
    found += comparison.regressed() && only_column_generation(comparison, Change::slower) ? 1 : 0;
  }
  EXPECT_GE(found, kEnough);
}

TEST(Compare, FindsASlowdownOfTenPercentInFourFilesASideIn19Of20Tries) {
  int found = 0;
  for (int attempt = 0; attempt < kTries; ++attempt) {
    SimulatedMachine machine(400 + attempt, 0.04);
    const auto [base, fresh] = several_runs(machine, 4, 1.1);
    const Comparison comparison = compare_runs(base, fresh);
    found += comparison.regressed() && only_column_generation(comparison, Change::slower) ? 1 : 0;
  }
  EXPECT_GE(found, kEnough);
}

/// Cells of a run drift by 15 % (one standard deviation): repetitions within runs know nothing of that.
TEST(Compare, RaisesNoAlarmWhereRunsOfOneBuildDifferMuch) {
  int alarms = 0;
  for (int attempt = 0; attempt < kTries; ++attempt) {
    SimulatedMachine machine(500 + attempt, 0.15);
    for (const int count : {1, 4, 5}) {
      CompareOptions options;
      options.paired = count == 5;
      const auto [base, fresh] = several_runs(machine, count, 1);
      alarms += compare_runs(base, fresh, options).regressed() ? 1 : 0;
    }
  }
  EXPECT_LE(alarms, 3 * kTries / 20 + 2);  // 5 % and a standard error
}

TEST(Compare, EstimatesTheSpreadBetweenRuns) {
  SimulatedMachine machine(600, 0.08);
  CompareOptions options;
  options.paired = true;
  const auto [base, fresh] = several_runs(machine, 12, 1);
  const Comparison paired = compare_runs(base, fresh, options);
  double sum = 0;
  for (const CellChange& cell : paired.cells) sum += cell.run_spread;
  EXPECT_NEAR(sum / static_cast<double>(paired.cells.size()), 0.08, 0.015);
  EXPECT_TRUE(std::isnan(compare_runs(base[0], fresh[0]).cells[0].run_spread));
}

TEST(Compare, IsSureOfOneRunASideWhereNoMachineDriftsSoMuch) {
  SimulatedMachine machine(601);
  const std::vector<Record> base = machine.run();
  EXPECT_TRUE(
      only_column_generation(compare_runs(base, machine.run("column_generation", 1.6)), Change::slower));
  EXPECT_TRUE(only_column_generation(compare_runs(base, machine.run("column_generation", 1.4)),
                                     Change::suspected_slower));
}

TEST(Compare, TellsFasterFromSlower) {
  SimulatedMachine machine(7);
  const std::vector<Record> base = machine.run();
  const Comparison comparison = compare_runs(base, machine.run("zheng_yamane", 0.4));
  EXPECT_FALSE(comparison.regressed());
  EXPECT_EQ(comparison.methods[1].change, Change::faster);
  EXPECT_NEAR(comparison.methods[1].ratio.ratio.ratio, 0.4, 0.03);
  EXPECT_NE(comparison_verdict(comparison)
                .find("no regression: of 48 cells 0 slower, 16 faster; zheng_yamane "
                      "faster over all cells"),
            std::string::npos)
      << comparison_verdict(comparison);
}

TEST(Compare, RegressesWhereAnInstanceIsNoLongerSolved) {
  SimulatedMachine machine(8);
  const std::vector<Record> base = machine.run();
  std::vector<Record> fresh = base;
  fresh[5].status = DistanceStatus::time_limit;
  const Comparison comparison = compare_runs(base, fresh);
  EXPECT_TRUE(comparison.regressed());
  EXPECT_EQ(comparison.cells[0].lost + comparison.methods[0].lost, 2U);
  EXPECT_FALSE(compare_runs(fresh, base).regressed());
}

TEST(Compare, RegressesWhereAnAnswerNewlyDisagrees) {
  SimulatedMachine machine(8);
  const std::vector<Record> base = machine.run();
  std::vector<Record> fresh = base;
  fresh[5].agrees = false;
  const Comparison comparison = compare_runs(base, fresh);
  EXPECT_TRUE(comparison.regressed());
  EXPECT_EQ(comparison.cells[0].lost, 1U);
  EXPECT_FALSE(compare_runs(fresh, base).regressed());

  for (Record& record : fresh)
    if (record.method == "column_generation" && record.n == 3 && record.N == 200) record.agrees = false;
  const Comparison whole_cell = compare_runs(base, fresh);
  EXPECT_TRUE(whole_cell.regressed());
  EXPECT_EQ(whole_cell.base_only, 0U);
  EXPECT_EQ(whole_cell.cells[0].lost, 20U);
}

TEST(Compare, LooksForContradictionsInDisagreeingRecordsToo) {
  SimulatedMachine machine(8);
  const std::vector<Record> base = machine.run();
  std::vector<Record> fresh = base;
  fresh[5].lower = fresh[5].distance = fresh[5].upper = 3;
  fresh[5].agrees = false;
  EXPECT_EQ(compare_runs(base, fresh).contradictions, 1U);
}

TEST(Compare, TellsTheParametersOfAGeneratorApart) {
  SimulatedMachine machine(10);
  const std::vector<Record> base = machine.run();
  std::vector<Record> fresh = base;
  for (Record& record : fresh)
    if (record.method == "column_generation") record.seconds *= 3;
  const std::vector<Table> tables = comparison_tables(compare_runs(base, fresh), {}, 1);
  EXPECT_EQ(tables[1].rows[0].cells[0].text, "example2 (separation=1.5)");
}

TEST(Compare, RegressesWhereBoundsContradict) {
  SimulatedMachine machine(8);
  const std::vector<Record> base = machine.run();
  std::vector<Record> fresh = base;
  fresh[5].lower = fresh[5].distance = fresh[5].upper = 3;
  EXPECT_EQ(compare_runs(base, fresh).contradictions, 1U);
  EXPECT_TRUE(compare_runs(base, fresh).regressed());
}

TEST(Compare, TakesIndependentSamplesWhereNoInstanceIsShared) {
  SimulatedMachine machine(9);
  const std::vector<Record> base = machine.run();
  std::vector<Record> fresh = base;
  const auto first_cell = [&](double factor) {
    for (std::size_t i = 0; i < base.size(); ++i) {
      fresh[i].seed = 2;
      fresh[i].seconds = factor * base[i].seconds;
    }
    return compare_runs(base, fresh).cells.front();
  };
  const CellChange same = first_cell(1);
  EXPECT_EQ(same.pairs, 0U);
  EXPECT_DOUBLE_EQ(same.ratio.ratio.ratio, 1);
  EXPECT_DOUBLE_EQ(same.ratio.p, 1);
  // The two samples are the same up to 1.5 (or 0.5) and the threshold that the test takes off.
  std::vector<double> times;
  std::vector<double> scaled;
  const auto p_at = [&](double factor) {
    times.clear();
    scaled.clear();
    for (int i = 0; i < 20; ++i) {
      times.push_back(base[i].seconds);
      scaled.push_back(factor * base[i].seconds);
    }
    return rank_sum_p(scaled, times);
  };
  const CellChange slower = first_cell(1.5);
  EXPECT_DOUBLE_EQ(slower.ratio.ratio.ratio, 1.5);
  EXPECT_DOUBLE_EQ(slower.ratio.p, p_at(1.5 / 1.05));
  EXPECT_LT(slower.ratio.p, 1e-2);
  const CellChange faster = first_cell(0.5);
  EXPECT_DOUBLE_EQ(faster.ratio.ratio.ratio, 0.5);
  EXPECT_DOUBLE_EQ(faster.ratio.p, p_at(0.5 * 1.05));
}

TEST(Compare, RefusesRunsWithNothingInCommon) {
  SimulatedMachine machine(9);
  const std::vector<Record> base = machine.run();
  CompareOptions options;
  options.filter = Filter("n==99");
  options.base_name = "a.h5";
  EXPECT_EQ(testing::message_of<EmptySetError>([&] { compare_runs(base, base, options); }),
            "no record of a.h5 passes the filter 'n==99'");
  options = {};
  std::vector<Record> other = base;
  for (Record& record : other) record.N += 1;
  EXPECT_EQ(testing::message_of<EmptySetError>([&] { compare_runs(base, other); }),
            "BASE and NEW have no cell (generator and its parameters, n, N, tolerance) and method in common");
  options.threshold = -1;
  EXPECT_EQ(testing::message_of<InvalidParameterError>([&] { compare_runs(base, base, options); }),
            "threshold is -1, must be a number from 0 on");
  options = {};
  options.paired = true;
  EXPECT_THROW(compare_runs(Runs{base, base}, Runs{base}, options), InvalidParameterError);
}

TEST(Compare, PutsTheLargestSlowdownFirstInItsTable) {
  SimulatedMachine machine(10);
  const std::vector<Record> base = machine.run();
  std::vector<Record> fresh = base;
  for (Record& record : fresh)
    if (record.method == "glpk_dual" && record.n == 4) record.seconds *= record.N == 400 ? 4 : 3;
  const std::vector<Table> tables = comparison_tables(compare_runs(base, fresh), {"processor: a; now b"}, 2);
  ASSERT_EQ(tables.size(), 2U);
  ASSERT_EQ(tables[1].rows.size(), 2U);
  EXPECT_EQ(tables[1].rows[0].cells[3].text, "400");
  EXPECT_EQ(tables[1].rows[0].cells[7].text, "4.00 [4.00, 4.00]");
  EXPECT_EQ(tables[1].notes.front(), "2 more; --all shows them");
  EXPECT_EQ(tables[1].notes.back(), "warning: processor: a; now b");
}

TEST(Circumstances, AreToldWhereTheyDiffer) {
  Provenance base;
  base.sessions.resize(1);
  base.sessions[0].machine.cpu_model = "fast";
  Provenance fresh = base;
  EXPECT_TRUE(circumstance_differences(base, fresh).empty());
  fresh.sessions[0].machine.cpu_model = "slow";
  fresh.sessions[0].build.build_type = "Debug";
  EXPECT_EQ(circumstance_differences(base, fresh),
            (std::vector<std::string>{"processor: fast; now slow", "build type: unknown; now Debug"}));
}

}  // namespace
}  // namespace raygauge::test_compare
