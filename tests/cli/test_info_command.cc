// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "baselines/registry.h"
#include "results/run/results_file.h"
#include "tests/cli/program_fixture.h"

namespace raygauge::testing::test_info_command {
namespace {

using Json = nlohmann::ordered_json;

const std::string kExperiment =
    example2_experiment("name = \"small\"\ndescription = \"two cells\"\n",
                        "n = [3, 5]\nN = 20\nrepetitions = 2\n", "[run]\nthreads = 1\n");

class InfoCommand : public ProgramTest {
 protected:
  Json info(const std::vector<std::string>& words = {}) {
    std::vector<std::string> arguments = {"info", "--json"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    const ProgramResult result = run_raygauge(arguments);
    EXPECT_EQ(result.status, 0) << result.err;
    return Json::parse(result.out);
  }

  /// Sweeps two cells into small.h5.
  void run_experiment() {
    write("small.toml", kExperiment);
    const ProgramResult result = run_raygauge({"run", "small.toml", "-o", "small.h5", "--quiet"});
    ASSERT_EQ(result.status, 0) << result.err;
  }
};

std::vector<std::string> names_in(const Json& components) {
  std::vector<std::string> names;
  for (const Json& component : components) names.push_back(component["name"]);
  return names;
}

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

TEST_F(InfoCommand, TellsBuildMachineSolversMethodsAndGenerators) {
  const Json json = info();
  EXPECT_EQ(json["raygauge_version"], RAYGAUGE_VERSION);
  EXPECT_FALSE(json["git_commit"].get<std::string>().empty());
  EXPECT_GE(json["machine"]["cores"].get<int>(), 1);
  EXPECT_EQ(json["instruction_sets"][0], "baseline");
  EXPECT_TRUE(json["libraries"].contains("HDF5"));
  std::vector<std::string> solvers;
  for (const auto& item : json["solvers"].items()) solvers.push_back(item.key());
  std::vector<std::string> expected;
  for (const auto& [name, version] : solver_versions()) expected.push_back(name);
  EXPECT_EQ(solvers, expected);
  const std::vector<std::string> methods = names_in(json["methods"]);
  for (const char* name : {"column_generation", "zheng_yamane", "glpk_primal", "glpk_dual"})
    EXPECT_TRUE(has(methods, name)) << name;
  EXPECT_TRUE(has(names_in(json["generators"]), "example2"));
}

TEST_F(InfoCommand, TextNamesEveryMethodAndGeneratorToo) {
  const ProgramResult result = run_raygauge({"info"});
  EXPECT_EQ(result.status, 0);
  for (const char* word :
       {"compiler", "instruction sets", "HDF5", "zheng_yamane", "example2", "separation = 1.5"}) {
    EXPECT_NE(result.out.find(word), std::string::npos) << word;
  }
}

TEST_F(InfoCommand, TellsWhatAFinishedFileHolds) {
  run_experiment();
  const Json json = info({"small.h5"});
  EXPECT_EQ(json["experiment"], "small");
  EXPECT_EQ(json["description"], "two cells");
  EXPECT_EQ(json["finished"], true);
  EXPECT_EQ(json["cells_done"], 2);
  EXPECT_EQ(json["cells"], 2);
  EXPECT_EQ(json["records"], 8);
  EXPECT_EQ(json["methods"], Json({"column_generation", "zheng_yamane"}));
  EXPECT_EQ(json["n"], Json({3, 5}));
  EXPECT_EQ(json["N"], Json::array({20}));
  EXPECT_EQ(json["tolerance"][0], 1e-6);
  EXPECT_EQ(json["repetitions"], 2);
  EXPECT_EQ(json["statuses"]["optimal"], 8);
  EXPECT_EQ(json["disagreements"], 0);
  ASSERT_EQ(json["sessions"].size(), 1U);
  EXPECT_FALSE(json["sessions"][0]["finished_at"].get<std::string>().empty());
}

TEST_F(InfoCommand, CountsDisagreementsAndStatuses) {
  run_experiment();
  ResultsFile results = read_results(folder_.file("small.h5"));
  results.records[0].agrees = false;
  results.records[1].status = DistanceStatus::time_limit;
  write_results(folder_.file("small.h5"), results);
  const Json json = info({"small.h5"});
  EXPECT_EQ(json["disagreements"], 1);
  EXPECT_EQ(json["statuses"], Json({{"optimal", 7}, {"time_limit", 1}}));
  const ProgramResult text = run_raygauge({"info", "small.h5"});
  EXPECT_NE(text.out.find("optimal 7, time_limit 1"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("1 of 8 records"), std::string::npos) << text.out;
}

TEST_F(InfoCommand, TellsThatARunIsUnfinished) {
  run_experiment();
  ResultsFile results = read_results(folder_.file("small.h5"));
  std::erase_if(results.records, [](const Record& record) { return record.cell == 1; });
  write_results(folder_.file("small.h5"), results);
  EXPECT_EQ(info({"small.h5"})["finished"], false);
  const ProgramResult text = run_raygauge({"info", "small.h5"});
  EXPECT_NE(text.out.find("1 of 2 (unfinished"), std::string::npos) << text.out;
}

TEST_F(InfoCommand, AFileThatIsMissingOrDamagedIsNamed) {
  run_experiment();
  std::filesystem::resize_file(folder_.file("small.h5"),
                               std::filesystem::file_size(folder_.file("small.h5")) / 2);
  write("text.h5", "not HDF5");
  for (const char* name : {"nowhere.h5", "small.h5", "text.h5"}) {
    const ProgramResult result = run_raygauge({"info", name});
    EXPECT_EQ(result.status, 2) << name;
    EXPECT_EQ(result.out, "") << name;
    EXPECT_EQ(result.err.rfind(std::string("raygauge: ") + name + ": ", 0), 0U) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }
}

}  // namespace
}  // namespace raygauge::testing::test_info_command
