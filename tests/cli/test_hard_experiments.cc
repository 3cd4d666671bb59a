// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// The experiments over the hard families that ship, and what the small one finds.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "cli/input/experiment_file.h"
#include "cli/input/registries.h"
#include "tests/cli/program_fixture.h"

namespace raygauge::test_hard_experiments {
namespace {

std::string shipped(const std::string& name) { return std::string(RAYGAUGE_EXPERIMENTS) + "/" + name; }

std::set<std::string> hard_families() {
  std::set<std::string> families;
  for (const std::string& name : cli::all_generators().names()) {
    if (name.starts_with("hard_")) families.insert(name);
  }
  return families;
}

/// The families that an experiment sweeps.
std::set<std::string> families_in(const std::string& file) {
  std::set<std::string> swept;
  for (const GeneratorSpec& generator :
       cli::read_experiment(shipped(file), {}, cli::all_generators(), cli::all_methods()).generators)
    swept.insert(generator.name);
  return swept;
}

class HardExperiments : public testing::ProgramTest {};

TEST_F(HardExperiments, HaveEveryHardFamilyPointSetsAndOthersApart) {
  const std::set<std::string> points = families_in("hard.toml"), smooth = families_in("hard_smooth.toml"),
                              degenerate = families_in("hard_degenerate.toml");
  EXPECT_EQ(families_in("hard_smoke.toml"), points);
  std::set<std::string> all = points;
  all.insert(smooth.begin(), smooth.end());
  all.insert(degenerate.begin(), degenerate.end());
  EXPECT_EQ(all, hard_families());
  EXPECT_EQ(points.size() + smooth.size() + degenerate.size(), all.size());
}

/// The fields of one line of CSV without quotes.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  return fields;
}

/// The lines of `table --stability` by the names of its columns.
std::vector<std::map<std::string, std::string>> stability_lines(const std::string& csv) {
  std::istringstream stream(csv);
  std::string line;
  std::getline(stream, line);
  const std::vector<std::string> names = fields_of(line);
  std::vector<std::map<std::string, std::string>> lines;
  while (std::getline(stream, line)) {
    const std::vector<std::string> fields = fields_of(line);
    auto& values = lines.emplace_back();
    for (std::size_t i = 0; i < fields.size(); ++i) values[names.at(i)] = fields[i];
  }
  return lines;
}

TEST_F(HardExperiments, FindNoWrongAnswerOfOursAndKnowEveryTruth) {
  const std::set<std::string> kOurs = {"column_generation", "zheng_yamane", "newton", "exact"};
  const std::vector<std::string> kSmaller = {"--set", "sweep.n=3",          "--set", "sweep.tolerance=1e-6",
                                             "--set", "sweep.repetitions=1"};
  for (const std::string name : {"hard_smoke", "hard_smooth"}) {
    std::vector<std::string> arguments = {"run", shipped(name + ".toml"), "--quiet", "-o", name + ".h5"};
    if (name == "hard_smooth") arguments.insert(arguments.end(), kSmaller.begin(), kSmaller.end());
    const auto run = run_raygauge(arguments);
    ASSERT_EQ(run.status, 0) << run.err;
    const auto table = run_raygauge({"table", name + ".h5", "--stability", "--format", "csv"});
    ASSERT_EQ(table.status, 0) << table.err;
    std::size_t ours = 0;
    for (auto& line : stability_lines(table.out)) {
      EXPECT_EQ(line["truth_known"], line["solves"]) << name << ": " << line["family"];
      if (!kOurs.contains(line["method"])) continue;
      EXPECT_EQ(line["wrong"], "0") << name << ": " << line["family"] << ", " << line["method"];
      ++ours;
    }
    EXPECT_EQ(ours, 3 * (families_in(name + ".toml").size() + 1))
        << "three methods; each family and all of them";
  }
}

}  // namespace
}  // namespace raygauge::test_hard_experiments
