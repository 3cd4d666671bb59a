// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/program_fixture.h"

namespace raygauge::testing::test_usage {
namespace {

class Usage : public ProgramTest {
 protected:
  std::string help(const std::string& command) {
    const ProgramResult outcome = run_raygauge({command, "--help"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  }
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(Usage, VersionNamesCommitAndBuildType) {
  const ProgramResult outcome = run_raygauge({"--version"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out.rfind("raygauge " RAYGAUGE_VERSION " (commit ", 0), 0U) << outcome.out;
  EXPECT_TRUE(contains(outcome.out, RAYGAUGE_BUILD_TYPE ")\n")) << outcome.out;
}

TEST_F(Usage, TheCurrentFolderIsNotSearchedForLibraries) {
  write("libtomlplusplus.so.3", "whatever a stranger has put here");
  const ProgramResult outcome = run_raygauge({"--version"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST_F(Usage, HelpOfTheProgramListsTheCommands) {
  const ProgramResult outcome = run_raygauge({"--help"});
  EXPECT_EQ(outcome.status, 0);
  for (const char* command : {"run", "distance", "info"})
    EXPECT_TRUE(contains(outcome.out, command)) << command;
}

TEST_F(Usage, HelpOfDistanceShowsEveryDefault) {
  const std::string text = help("distance");
  for (const char* part :
       {"--tolerance EPS=1e-6", "--method NAME=automatic", "--max-iterations K=0", "--time-limit SECONDS=inf",
        "--stop-rule RULE=certified_gap", "--instruction-set NAME=automatic", "--threads K=1",
        "Examples:", "Exit status:"}) {
    EXPECT_TRUE(contains(text, part)) << part << " is not in\n" << text;
  }
}

TEST_F(Usage, HelpOfInfoHasExamples) { EXPECT_TRUE(contains(help("info"), "Examples:")); }

TEST_F(Usage, ACommandIsNeeded) {
  expect_complaint(run_raygauge({}), "raygauge: a command is needed (raygauge --help)");
}

TEST_F(Usage, AnUnknownCommandSuggestsTheNearest) {
  expect_complaint(run_raygauge({"distanse", "A", "Q"}),
                   "raygauge: unknown command 'distanse'; did you mean 'distance'? (raygauge --help)");
  expect_complaint(run_raygauge({"tabel", "-o", "x"}),
                   "raygauge: unknown command 'tabel'; did you mean 'table'? (raygauge --help)");
}

TEST_F(Usage, AnUnknownOptionSuggestsTheNearest) {
  expect_complaint(
      run_raygauge({"distance", "A", "Q", "--tolerence=1e-3"}),
      "raygauge distance: unknown option '--tolerence'; did you mean '--tolerance'? (raygauge distance "
      "--help)");
  expect_complaint(run_raygauge({"--versoin"}),
                   "raygauge: unknown option '--versoin'; did you mean '--version'? (raygauge --help)");
}

TEST_F(Usage, MissingAndSuperfluousArgumentsAreNamed) {
  expect_complaint(run_raygauge({"distance", "A"}),
                   "raygauge distance: Q is required (raygauge distance --help)");
  expect_complaint(run_raygauge({"distance", "A", "Q", "R"}),
                   "raygauge distance: unexpected argument 'R' (raygauge distance --help)");
}

TEST_F(Usage, AnOptionOfTheWrongTypeIsNamed) {
  const ProgramResult outcome = run_raygauge({"distance", "A", "Q", "--tolerance", "small"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_TRUE(contains(outcome.err, "--tolerance")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "small")) << outcome.err;
}

}  // namespace
}  // namespace raygauge::testing::test_usage
