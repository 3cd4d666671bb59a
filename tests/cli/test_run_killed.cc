// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// The program, killed by the system at any moment and resumed, leaves what an undisturbed run leaves.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstring>
#include <map>
#include <random>
#include <thread>
#include <tuple>

#include "results/run/results_file.h"
#include "tests/cli/program_fixture.h"

namespace raygauge::test_run_killed {
namespace {

constexpr int kKills = 20;

/// Longer than a start, shorter than the sweep, so that kills fall into every phase: reading back,
/// calibration, solving, storing, merging.
constexpr double kLongestLifeSeconds = 0.25;

/// 24 cells. A sample of 2 ms makes the sweep long enough to be hit.
const std::string kExperiment = testing::example2_experiment(
    "name = \"killed\"\n", "n = [3, 4, 6, 8]\nN = [20, 50, 100]\ntolerance = [1e-3, 1e-6]\nrepetitions = 3\n",
    "[run]\nmin_seconds = 2e-3\n");

using RecordKey = std::tuple<std::uint64_t, int, std::string>;

/// The bits of a double, so that equal means identical, for NaN too.
std::uint64_t bits(double value) {
  std::uint64_t result = 0;
  std::memcpy(&result, &value, sizeof result);
  return result;
}

using Outcome = std::tuple<std::uint64_t, std::uint64_t, std::uint64_t, DistanceStatus, bool, std::int64_t,
                           std::int64_t, std::int64_t, std::int64_t>;

/// What may not depend on threads, order or kills, of each record; a record stored twice fails the test.
std::map<RecordKey, Outcome> outcomes(const ResultsFile& results) {
  std::map<RecordKey, Outcome> result;
  for (const Record& r : results.records) {
    const Outcome outcome = {bits(r.distance),
                             bits(r.lower),
                             bits(r.upper),
                             r.status,
                             r.agrees,
                             r.counters.outer_iterations,
                             r.counters.ray_iterations,
                             r.counters.pivots,
                             r.counters.support_queries};
    EXPECT_TRUE(result.emplace(RecordKey{r.cell, r.repetition, r.method}, outcome).second)
        << "stored twice: cell " << r.cell << ", repetition " << r.repetition << ", " << r.method;
  }
  return result;
}

class KilledRun : public ::testing::Test {
 protected:
  void SetUp() override { testing::write_bytes(folder_.file("killed.toml"), kExperiment); }

  std::vector<std::string> arguments(const std::string& output, int threads, bool shuffle) const {
    return {"run",       "killed.toml",
            "-o",        output,
            "--threads", std::to_string(threads),
            "--set",     shuffle ? "run.shuffle=true" : "run.shuffle=false",
            "--quiet",   "--resume"};
  }

  std::map<RecordKey, Outcome> undisturbed() const {
    const testing::ProgramResult result =
        testing::run_program(folder_.path(), arguments("reference.h5", 1, false));
    EXPECT_EQ(result.status, 0) << result.err;
    return outcomes(read_results(folder_.file("reference.h5")));
  }

  /// Runs and kills until the run has survived, as a new one every time it gets done; at least kKills kills.
  void expect_survival(int threads, bool shuffle) {
    const std::map<RecordKey, Outcome> expected = undisturbed();
    EXPECT_EQ(expected.size(), 24u * 3 * 2);
    std::uniform_real_distribution<double> life(0, kLongestLifeSeconds);
    int finished_runs = 0;
    for (int kills = 0; kills < kKills || finished_runs == 0;) {
      const std::string output = "killed-" + std::to_string(finished_runs) + ".h5";
      testing::Program program(folder_.path(), arguments(output, threads, shuffle));
      if (kills < kKills) {
        std::this_thread::sleep_for(std::chrono::duration<double>(life(random_)));
        program.signal(SIGKILL);
      }
      const testing::ProgramResult result = program.wait();
      if (result.status == 128 + SIGKILL) {
        ++kills;
        continue;
      }
      ASSERT_EQ(result.status, 0) << result.err;
      EXPECT_EQ(outcomes(read_results(folder_.file(output))), expected);
      ++finished_runs;
    }
  }

  testing::TemporaryFolder folder_;
  std::mt19937_64 random_{20};
};

TEST_F(KilledRun, OnOneThreadGivesTheSameRecordsEachOnce) { expect_survival(1, false); }

TEST_F(KilledRun, OnTwoThreadsGivesTheSameRecordsEachOnce) { expect_survival(2, false); }

TEST_F(KilledRun, InShuffledOrderGivesTheSameRecordsEachOnce) { expect_survival(2, true); }

}  // namespace
}  // namespace raygauge::test_run_killed
