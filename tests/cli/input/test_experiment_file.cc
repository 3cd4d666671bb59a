// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/experiment_file.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "tests/engine/fake_components.h"

namespace raygauge::cli::test_experiment_file {
namespace {

constexpr const char* kGeneratorAndMethod = R"(
[[generator]]
name = "ray"
[[method]]
name = "ray"
)";

class ExperimentFile : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    path_ = ::testing::TempDir() + "experiment_file_" + info->name() + ".toml";
  }
  void TearDown() override { std::filesystem::remove(path_); }

  Experiment read(const std::string& text, const std::vector<std::string>& overrides = {}) {
    std::ofstream(path_) << text;
    return read_experiment(path_, overrides, generators_, methods_);
  }

  /// The error that `text` gives, without the folder of the file; "" if there is none.
  std::string error(const std::string& text, const std::vector<std::string>& overrides = {}) {
    try {
      read(text, overrides);
    } catch (const Error& caught) {
      const std::string message = caught.what();
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      return message.starts_with(path_) ? "x.toml" + message.substr(path_.size()) : message;
    }
    return "";
  }

  std::string path_;
  testing::CallLog log_;
  GeneratorRegistry generators_ = testing::fake_generators();
  MethodRegistry methods_ = testing::fake_methods(log_);
};

TEST_F(ExperimentFile, EveryKeyIsRead) {
  const Experiment e = read(R"(
name = "all"
description = "every key"
[sweep]
n = [3, 4]
N = [200, 400]
tolerance = [1e-3, 1e-6]
grid = "paired"
repetitions = 50
min_repetitions = 8
stop_when_within = 0.05
seed = 42
[[generator]]
name = "ray"
shift = 1.5
[[method]]
name = "ray"
label = "wrong"
error = 0.25
[run]
threads = 3
timing = "serial"
pin_threads = false
warmup = 2
min_seconds = 1e-3
time_limit = 9
shuffle = false
)");
  EXPECT_EQ(e.name, "all");
  EXPECT_EQ(e.description, "every key");
  EXPECT_EQ(e.n, (std::vector<int>{3, 4}));
  EXPECT_EQ(e.N, (std::vector<int>{200, 400}));
  EXPECT_EQ(e.tolerance, (std::vector<double>{1e-3, 1e-6}));
  EXPECT_EQ(e.grid, GridMode::paired);
  EXPECT_EQ(e.repetitions, 50);
  EXPECT_EQ(e.min_repetitions, 8);
  EXPECT_EQ(e.stop_when_within, 0.05);
  EXPECT_EQ(e.seed, 42u);
  ASSERT_EQ(e.generators.size(), 1u);
  EXPECT_EQ(e.generators[0].name, "ray");
  EXPECT_EQ(to_string(e.generators[0].parameters), "shift=1.5");
  ASSERT_EQ(e.methods.size(), 1u);
  EXPECT_EQ(e.methods[0].label, "wrong");
  EXPECT_EQ(to_string(e.methods[0].parameters), "error=0.25");
  EXPECT_EQ(e.threads, 3);
  EXPECT_EQ(e.timing, TimingMode::serial);
  EXPECT_FALSE(e.pin_threads);
  EXPECT_EQ(e.warmup, 2);
  EXPECT_EQ(e.min_seconds, 1e-3);
  EXPECT_EQ(e.time_limit, 9);
  EXPECT_FALSE(e.shuffle);
}

TEST_F(ExperimentFile, AbsentKeysLeaveTheDefaults) {
  const Experiment defaults;
  const Experiment e = read(kGeneratorAndMethod);
  EXPECT_EQ(e.name, defaults.name);
  EXPECT_EQ(e.n, defaults.n);
  EXPECT_EQ(e.N, defaults.N);
  EXPECT_EQ(e.tolerance, defaults.tolerance);
  EXPECT_EQ(e.repetitions, defaults.repetitions);
  EXPECT_EQ(e.time_limit, defaults.time_limit);
  EXPECT_EQ(e.methods[0].label, "ray");
  EXPECT_EQ(e.text, kGeneratorAndMethod);
}

TEST_F(ExperimentFile, RangesAreSpelledOut) {
  const Experiment e = read(std::string(R"(
[sweep]
n = {from = 3, to = 10}
N = {from = 200, to = 2000, step = 200}
tolerance = {from = 1e-2, to = 1e-10, factor = 1e-2}
)") + kGeneratorAndMethod);
  EXPECT_EQ(e.n, (std::vector<int>{3, 4, 5, 6, 7, 8, 9, 10}));
  EXPECT_EQ(e.N, (std::vector<int>{200, 400, 600, 800, 1000, 1200, 1400, 1600, 1800, 2000}));
  ASSERT_EQ(e.tolerance.size(), 5u);
  EXPECT_EQ(e.tolerance.front(), 1e-2);
  EXPECT_NEAR(e.tolerance[2], 1e-6, 1e-18);
  EXPECT_EQ(e.tolerance.back(), 1e-10);
}

TEST_F(ExperimentFile, ARangeStopsBeforeAnEndItDoesNotMeet) {
  const Experiment e = read(std::string("[sweep]\nn = {from = 3, to = 10, step = 3}\n"
                                        "N = {from = 10, to = 100, factor = 2.5}\n") +
                            kGeneratorAndMethod);
  EXPECT_EQ(e.n, (std::vector<int>{3, 6, 9}));
  EXPECT_EQ(e.N, (std::vector<int>{10, 25, 63}));
}

TEST_F(ExperimentFile, ListsOfGeneratorParametersAreSwept) {
  const Experiment e =
      read("[[generator]]\nname = \"ray\"\nshift = [0, 1.5, 3]\n[[method]]\nname = \"ray\"\n");
  ASSERT_EQ(e.generators.size(), 3u);
  EXPECT_EQ(to_string(e.generators[1].parameters), "shift=1.5");
}

TEST_F(ExperimentFile, AGeneratorMayHaveAxesOfItsOwn) {
  const std::string text =
      "[[generator]]\nname = \"ray\"\nn = 2\nN = {from = 5, to = 7}\nshift = [0, 3]\n"
      "[[method]]\nname = \"ray\"\n";
  const Experiment e = read(text);
  ASSERT_EQ(e.generators.size(), 2u);
  for (const GeneratorSpec& generator : e.generators) {
    EXPECT_EQ(generator.n, std::vector<int>{2});
    EXPECT_EQ(generator.N, (std::vector<int>{5, 6, 7}));
  }
  EXPECT_EQ(grid_of(e).size(), 6u);
  EXPECT_EQ(grid_of(read(text, {"generator.ray.n=3,4"})).size(), 12u);
  EXPECT_THROW(read(text, {"generator.ray.n=0"}), InvalidParameterError);
}

TEST_F(ExperimentFile, OverridesTakeTomlOrBareLists) {
  const Experiment e =
      read(kGeneratorAndMethod, {"sweep.n=[5, 6]", "sweep.N=10,20,30", "sweep.grid=cartesian",
                                 "run.timing=\"serial\"", "name=quick", "sweep.tolerance=1e-3",
                                 "generator.shift=2", "run.pin_threads=false", "method.label=mine"});
  EXPECT_EQ(e.n, (std::vector<int>{5, 6}));
  EXPECT_EQ(e.N, (std::vector<int>{10, 20, 30}));
  EXPECT_EQ(e.timing, TimingMode::serial);
  EXPECT_EQ(e.name, "quick");
  EXPECT_EQ(e.tolerance, std::vector<double>{1e-3});
  EXPECT_EQ(to_string(e.generators[0].parameters), "shift=2");
  EXPECT_FALSE(e.pin_threads);
  EXPECT_EQ(e.methods[0].label, "mine");
}

TEST_F(ExperimentFile, OverridesChooseAmongEntriesByNameLabelOrPosition) {
  const std::string two =
      std::string(kGeneratorAndMethod) + "[[method]]\nname = \"ray\"\nlabel = \"second\"\n";
  const Experiment by_label = read(two, {"method.second.error=0.5"});
  EXPECT_EQ(to_string(by_label.methods[1].parameters), "error=0.5");
  EXPECT_TRUE(by_label.methods[0].parameters.empty());
  const Experiment by_position = read(two, {"method.1.error=0.5"});
  EXPECT_EQ(to_string(by_position.methods[1].parameters), "error=0.5");
  EXPECT_EQ(error(two, {"method.error=0.5"}),
            "--set method.error=0.5: 'error' is none of the 2 [[method]] entries (ray, second); write "
            "method.NAME.error=VALUE");
}

TEST_F(ExperimentFile, TheEffectiveTextGivesTheSameExperimentAgain) {
  const Experiment first = read(kGeneratorAndMethod, {"sweep.n=7,8", "sweep.tolerance=1e-7", "run.warmup=4"});
  const Experiment again = read(first.text);
  EXPECT_EQ(again.n, first.n);
  EXPECT_EQ(again.tolerance, first.tolerance);
  EXPECT_EQ(again.warmup, 4);
  EXPECT_NE(first.text.find("--set sweep.n=7,8"), std::string::npos);
}

TEST_F(ExperimentFile, UnknownKeysAreNamedWithTheNearestKnownOne) {
  EXPECT_EQ(error("nam = \"x\"\n"),
            "x.toml:1: unknown key 'nam'; did you mean 'name'? (known: name description sweep generator "
            "method run)");
  EXPECT_EQ(error("[sweep]\n\nrepetition = 3\n"),
            "x.toml:3: unknown [sweep] key 'repetition'; did you mean 'repetitions'? "
            "(known: n N tolerance grid repetitions min_repetitions stop_when_within seed)");
  EXPECT_EQ(error("[run]\nthread = 3\n"),
            "x.toml:2: unknown [run] key 'thread'; did you mean 'threads'? "
            "(known: threads timing pin_threads warmup min_seconds time_limit shuffle)");
  EXPECT_EQ(error("", {"sweep.tolerence=1e-3"}),
            "--set sweep.tolerence=1e-3: unknown [sweep] key 'tolerence'; did you mean 'tolerance'? "
            "(known: n N tolerance grid repetitions min_repetitions stop_when_within seed)");
}

TEST_F(ExperimentFile, UnknownComponentsListTheKnownOnes) {
  EXPECT_EQ(error("[[generator]]\nname = \"rya\"\n"),
            "x.toml:2: unknown generator 'rya'; did you mean 'ray'? (known: ray)");
  EXPECT_EQ(error("[[generator]]\nname = \"ray\"\n[[method]]\nname = \"simplex\"\n"),
            "x.toml:4: unknown method 'simplex' (known: ray)");
  EXPECT_EQ(
      error("[[generator]]\nname = \"ray\"\nshfit = 2\n"),
      "x.toml:3: unknown key of generator 'ray' 'shfit'; did you mean 'shift'? (known: name n N shift)");
}

TEST_F(ExperimentFile, MissingComponentsAreAskedFor) {
  EXPECT_EQ(error(""), "x.toml: expected at least one [[generator]] entry");
  EXPECT_EQ(error("[[generator]]\nname = \"ray\"\n"), "x.toml: expected at least one [[method]] entry");
  EXPECT_EQ(error("[generator]\nname = \"ray\"\n"), "x.toml:1: expected at least one [[generator]] entry");
  EXPECT_EQ(error("[[generator]]\nshift = 1\n"), "x.toml:1: a [[generator]] needs a name");
}

TEST_F(ExperimentFile, WrongTypesAndRangesAreNamedWithFileAndLine) {
  const std::vector<std::pair<std::string, std::string>> mistakes = {
      {"[sweep]\nn = \"three\"", "x.toml:2: sweep.n must be an integer, got 'three'"},
      {"[sweep]\nn = [3, 0]", "x.toml:2: sweep.n must lie in [1, 2147483647], got 0"},
      {"[sweep]\nn = []", "x.toml:2: sweep.n must be a nonempty list, got a list"},
      {"[sweep]\nN = 2.5", "x.toml:2: sweep.N must be an integer, got 2.5"},
      {"[sweep]\ntolerance = 1.0", "x.toml:2: sweep.tolerance must lie in (0, 1), got 1"},
      {"[sweep]\ntolerance = nan", "x.toml:2: sweep.tolerance must lie in (0, 1), got nan"},
      {"[sweep]\nseed = -1", "x.toml:2: sweep.seed must lie in [0, 9e18], got -1"},
      {"[sweep]\nmin_repetitions = 5", "x.toml:2: sweep.min_repetitions must lie in [6, 2147483647], got 5"},
      {"[sweep]\nstop_when_within = 5", "x.toml:2: sweep.stop_when_within must lie in [0, 1], got 5"},
      {"[sweep]\ngrid = \"pared\"",
       "x.toml:2: unknown sweep.grid 'pared'; did you mean 'paired'? (known: cartesian paired)"},
      {"[sweep]\nN = {from = 10, to = 5}", "x.toml:2: sweep.N does not lead from 10 to 5"},
      {"[sweep]\nN = {from = 10, to = 50, step = 0}", "x.toml:2: sweep.N does not lead from 10 to 50"},
      {"[sweep]\nN = {from = 10}",
       "x.toml:2: sweep.N must be a value, a list, {from, to, step} or {from, to, factor}"},
      {"[run]\nthreads = -1", "x.toml:2: run.threads must lie in [0, 2147483647], got -1"},
      {"[run]\npin_threads = 1", "x.toml:2: run.pin_threads must be true or false, got 1"},
      {"[run]\ntime_limit = 0", "x.toml:2: run.time_limit must lie in (0, inf), got 0"},
      {"run = 3", "x.toml:1: run must be a table, [run]"},
      {"name = \"a/b\"", "x.toml:1: name must be fit for a file name, got 'a/b'"},
      {"name = 3", "x.toml:1: name must be a string, got 3"},
  };
  for (const auto& [text, message] : mistakes) EXPECT_EQ(error(text), message);
}

TEST_F(ExperimentFile, ParametersOutsideTheirRangeAreNamedWithFileAndLine) {
  EXPECT_EQ(error("[[generator]]\nname = \"ray\"\nshift = [1, 101]\n"),
            "x.toml:3: generator 'ray': parameter 'shift' must lie in [0, 100], got 101");
  EXPECT_EQ(error("[[generator]]\nname = \"ray\"\n[[method]]\nname = \"ray\"\nthrow_at = 0.5\n"),
            "x.toml:5: method 'ray': parameter 'throw_at' must be an integer, got 0.5");
}

TEST_F(ExperimentFile, ContradictionsOfTheWholeAreRejected) {
  EXPECT_EQ(error(std::string("[sweep]\nn = [3, 4]\ngrid = \"paired\"\n") + kGeneratorAndMethod),
            "x.toml:1: a paired grid needs lists n and N of one length, got 2 and 1");
  EXPECT_EQ(error(std::string("[sweep]\nn = [3, 3]\n") + kGeneratorAndMethod),
            "x.toml:1: the cell n = 3, N = 200, tolerance = 1e-6 appears twice in the grid");
  EXPECT_EQ(error(std::string(kGeneratorAndMethod) + "[[method]]\nname = \"ray\"\n"),
            "x.toml:6: method label 'ray' appears twice; set another label");
  EXPECT_EQ(error("[[generator]]\nname = \"ray\"\n[[generator]]\nname = \"ray\"\nshift = 0\n"),
            "x.toml:3: generator 'ray' appears twice with shift=0");
}

TEST_F(ExperimentFile, ALimitOfRepetitionsBelowTheLeastOfAnAdaptiveRunIsRejected) {
  EXPECT_EQ(error(std::string("[sweep]\nrepetitions = 9\nstop_when_within = 0.1\n") + kGeneratorAndMethod),
            "x.toml:1: stop_when_within needs repetitions of at least min_repetitions, 10, got 9");
  EXPECT_EQ(error(std::string("[sweep]\nrepetitions = 9\n") + kGeneratorAndMethod), "");
}

TEST_F(ExperimentFile, RangesThatOnlyASlipCanMeanAreRejected) {
  EXPECT_EQ(error("[[generator]]\nname = \"ray\"\nshift = {from = 0.0, to = 100.0, step = 0.0005}\n"),
            "x.toml:3: more than 100000 combinations of parameters of generator 'ray'");
  EXPECT_TRUE(
      error("[[generator]]\nname = \"ray\"\nshift = {from = 9223372036854775807, to = 9223372036854775807}\n")
          .starts_with("x.toml:3: generator.shift.from must lie in [-9007199254740992, 9007199254740992]"));
  EXPECT_EQ(error(std::string("[sweep]\nn = {from = 1, to = 90000}\nN = {from = 1, to = 90000}\n") +
                  kGeneratorAndMethod),
            "x.toml:1: the grid has 8.1e9 cells, more than 1e6 are refused");
}

TEST_F(ExperimentFile, SyntaxErrorsAreNamedWithFileAndLine) {
  EXPECT_TRUE(error("name = \"x\"\n[sweep\n").starts_with("x.toml:2: "));
  EXPECT_TRUE(error("n = [1, 2\n").starts_with("x.toml:"));
}

TEST_F(ExperimentFile, MalformedOverridesAreRejected) {
  EXPECT_EQ(error(kGeneratorAndMethod, {"sweep.n"}), "--set sweep.n: expected KEY=VALUE, as in sweep.n=3,4");
  EXPECT_EQ(error(kGeneratorAndMethod, {"sweep.n="}), "--set sweep.n=: '' is no TOML value");
  EXPECT_EQ(error(kGeneratorAndMethod, {"sweep.n=3,%"}), "--set sweep.n=3,%: '%' is no TOML value");
  EXPECT_EQ(error("name = \"x\"\n", {"name.part=3"}),
            "--set name.part=3: 'name' is a value or a list of values, not a table");
}

TEST_F(ExperimentFile, FilesThatCannotBeReadAreNamed) {
  EXPECT_THROW(
      {
        try {
          read_experiment("no/such.toml", {}, generators_, methods_);
        } catch (const Error& caught) {
          EXPECT_STREQ(caught.what(), "no/such.toml: No such file or directory");
          throw;
        }
      },
      InvalidParameterError);
  EXPECT_THROW(read_experiment(::testing::TempDir(), {}, generators_, methods_), InvalidParameterError);
}

}  // namespace
}  // namespace raygauge::cli::test_experiment_file
