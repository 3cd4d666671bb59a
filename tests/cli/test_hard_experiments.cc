// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// The experiments over the hard families that ship, and what the small one finds.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "cli/experiment_file.h"
#include "cli/registries.h"
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

class HardExperiments : public testing::ProgramTest {};

TEST_F(HardExperiments, HaveEveryHardFamily) {
  const GeneratorRegistry generators = cli::all_generators();
  const MethodRegistry methods = cli::all_methods();
  for (const char* file : {"hard.toml", "hard_smoke.toml"}) {
    std::set<std::string> swept;
    for (const GeneratorSpec& generator :
         cli::read_experiment(shipped(file), {}, generators, methods).generators)
      swept.insert(generator.name);
    EXPECT_EQ(swept, hard_families()) << file;
  }
}

/// The fields of one line of CSV without quotes.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  return fields;
}

TEST_F(HardExperiments, FindNoWrongAnswerOfOursAndKnowEveryTruth) {
  const auto run = run_raygauge({"run", shipped("hard_smoke.toml"), "--quiet", "-o", "hard.h5"});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto table = run_raygauge({"table", "hard.h5", "--stability", "--format", "csv"});
  ASSERT_EQ(table.status, 0) << table.err;
  std::istringstream lines(table.out);
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> header = fields_of(line);
  const auto column = [&](const char* name) {
    return static_cast<std::size_t>(std::find(header.begin(), header.end(), name) - header.begin());
  };
  std::size_t ours = 0;
  while (std::getline(lines, line)) {
    const std::vector<std::string> fields = fields_of(line);
    ASSERT_EQ(fields.size(), header.size());
    EXPECT_EQ(fields[column("truth_known")], fields[column("solves")]) << line;
    const std::string& method = fields[column("method")];
    if (method != "direct" && method != "zheng_yamane" && method != "exact") continue;
    EXPECT_EQ(fields[column("wrong")], "0") << line;
    ++ours;
  }
  const std::size_t families = hard_families().size();
  EXPECT_EQ(ours, 3 * (families + 1)) << "three methods; each family and all of them";
}

}  // namespace
}  // namespace raygauge::test_hard_experiments
