// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Example 1 as a user runs it: general sets from the experiment to the paper's tables.
#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <string>

#include "tests/cli/program_fixture.h"

namespace raygauge::test_example1_experiment {
namespace {

class Example1Experiment : public testing::ProgramTest {
 protected:
  static std::string smoke() { return std::string(RAYGAUGE_EXPERIMENTS) + "/example1_smoke.toml"; }
};

std::vector<std::string> fields_of_line(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> fields;
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  return fields;
}

/// Lines of CSV without quotes, the values by the names of the header.
std::vector<std::map<std::string, std::string>> lines_of(const std::string& csv) {
  std::istringstream stream(csv);
  std::string line;
  std::getline(stream, line);
  const std::vector<std::string> names = fields_of_line(line);
  std::vector<std::map<std::string, std::string>> lines;
  while (std::getline(stream, line)) {
    const std::vector<std::string> fields = fields_of_line(line);
    auto& values = lines.emplace_back();
    for (std::size_t i = 0; i < fields.size(); ++i) values[names.at(i)] = fields[i];
  }
  return lines;
}

TEST_F(Example1Experiment, GoesFromTheRunToThePapersTables) {
  const auto run = run_raygauge({"run", smoke(), "--quiet", "-o", "e.h5"});
  ASSERT_EQ(run.status, 0) << run.err;
  for (const char* name : {"table1", "table2"}) {
    const auto table = run_raygauge({"table", "e.h5", "--paper", name, "--format", "csv"});
    ASSERT_EQ(table.status, 0) << table.err;
    int ours = 0;
    for (auto line : lines_of(table.out)) {
      EXPECT_EQ(line["beyond_gap"], "0") << line["method"] << " at " << line["tolerance"];
      if (line["method"].starts_with("nlopt")) continue;
      ++ours;
      EXPECT_LE(std::stod(line["error"]), std::stod(line["tolerance"])) << line["method"];
      EXPECT_EQ(line["wrong"], "0") << line["method"] << " at " << line["tolerance"];
      EXPECT_GT(std::stod(line["paper_N_rs"]), 0) << line["tolerance"];
    }
    EXPECT_GE(ours, 9) << "three methods at three tolerances";
  }
  const auto accuracy = run_raygauge({"table", "e.h5", "--accuracy"});
  EXPECT_EQ(accuracy.status, 0) << accuracy.err;
  EXPECT_NE(accuracy.out.find("Where each method stops getting better"), std::string::npos);
  for (const char* figure : {"fig5", "fig7", "work_precision"}) {
    const auto plot = run_raygauge({"plot", "e.h5", "--figure", figure, "-o", "p.svg"});
    EXPECT_EQ(plot.status, 0) << plot.err;
  }
}

TEST_F(Example1Experiment, EndsWithOneLineWhereAMethodTakesPointSetsOnly) {
  write("e.toml",
        "[sweep]\nn = 3\nN = 1\nrepetitions = 1\n[[generator]]\nname = 'example1'\n[[method]]\nname = "
        "'glpk_dual'\n");
  const auto run = run_raygauge({"run", "e.toml", "--quiet", "-o", "e.h5"});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err, "raygauge: method 'glpk_dual' takes point sets only, and A is not a point set\n");
}

}  // namespace
}  // namespace raygauge::test_example1_experiment
