// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/commands/dry_run.h"

#include <gtest/gtest.h>

namespace raygauge::cli::test_dry_run {
namespace {

std::string generator_part(const std::vector<GeneratorSpec>& generators) {
  Experiment experiment;
  experiment.generators = generators;
  experiment.methods = {{"column_generation", "", {}}};
  const std::string text = dry_run_text(experiment, {});
  const std::size_t first = text.find("  generators");
  return text.substr(first, text.find("  methods") - first);
}

GeneratorSpec spec(const std::string& name, const Parameters& parameters, const std::vector<int>& n = {}) {
  return {{name, "", parameters}, n, {}};
}

TEST(DryRun, WritesALineForEachGenerator) {
  EXPECT_EQ(generator_part({spec("example2", {}), spec("needle", {{"aspect", 10.0}}, {2, 3})}),
            "  generators   example2\n"
            "               needle {aspect=10} n = 2 3\n");
}

TEST(DryRun, GathersAllCombinationsOfParameters) {
  std::vector<GeneratorSpec> generators;
  for (const char* body : {"cube", "ball"}) {
    for (const double scale : {1.0, 3.0, 2.0}) {
      generators.push_back(spec("vertex", {{"body", std::string(body)}, {"scale", scale}}));
    }
  }
  generators.push_back(spec("vertex", {{"body", std::string("cube")}, {"scale", 1.0}}, {5}));
  EXPECT_EQ(generator_part(generators),
            "  generators   vertex {body=cube,ball scale=1,3,2}\n"
            "               vertex {body=cube scale=1} n = 5\n");
}

TEST(DryRun, ClaimsNoCombinationThatIsNotThere) {
  EXPECT_EQ(generator_part({spec("v", {{"a", 1.0}, {"b", 1.0}}), spec("v", {{"a", 1.0}, {"b", 2.0}}),
                            spec("v", {{"a", 2.0}, {"b", 1.0}})}),
            "  generators   v {a=1 b=1,2}\n"
            "               v {a=2 b=1}\n");
}

TEST(DryRun, WritesRanges) {
  Experiment experiment;
  experiment.generators = {spec("example2", {})};
  experiment.methods = {{"column_generation", "", {}}};
  experiment.n = {2, 3, 4, 5, 7, 9, 11, 13, 20};
  experiment.N = {200, 400, 600, 800, 1000};
  const std::string text = dry_run_text(experiment, {});
  EXPECT_NE(text.find("  n            2 … 5 7 … 13 (step 2) 20\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  N            200 … 1000 (step 200)\n"), std::string::npos) << text;
}

TEST(DryRun, SaysWhatMemoryTheLargestCellNeeds) {
  Experiment experiment;
  experiment.generators = {spec("example2", {})};
  experiment.methods = {{"column_generation", "", {}}};
  SweepEstimate estimate;
  estimate.threads = 4;
  estimate.largest = {0, 0, 100, 30000, 1e-6};
  estimate.largest_bytes = 3.0 * (1 << 29);
  EXPECT_NE(dry_run_text(experiment, estimate)
                .find("  memory       about 1.5 GiB for the largest cell (n = 100, N = 30000), 6 GiB for 4 "
                      "at once\n"),
            std::string::npos);
  estimate.largest_bytes = 0;
  EXPECT_EQ(dry_run_text(experiment, estimate).find("memory"), std::string::npos);
}

TEST(DryRun, ShortensListsWithoutAPattern) {
  Experiment experiment;
  experiment.generators = {spec("example2", {})};
  experiment.methods = {{"column_generation", "", {}}};
  experiment.n.clear();
  for (int i = 0; i < 1000; ++i) experiment.n.push_back(2 + i * i);
  EXPECT_NE(
      dry_run_text(experiment, {}).find("n            2 3 6 11 18 27 38 51 66 83 102 … (1000 values)\n"),
      std::string::npos);
}

TEST(DryRun, WritesManyMethodsOnSeveralLines) {
  Experiment experiment;
  experiment.generators = {spec("example2", {})};
  for (const char* label : {"first", "second", "third"}) {
    experiment.methods.push_back({"glpk_dual", label, {{"basis", std::string("advanced")}}});
  }
  const std::string text = dry_run_text(experiment, {});
  EXPECT_NE(
      text.find("  methods      first = glpk_dual {basis=advanced}, second = glpk_dual {basis=advanced},\n"
                "               third = glpk_dual {basis=advanced}\n"),
      std::string::npos)
      << text;
}

}  // namespace
}  // namespace raygauge::cli::test_dry_run
