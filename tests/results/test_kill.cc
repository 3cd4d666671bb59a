// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A run that is killed at any moment and resumed holds every cell exactly once, as if nothing had happened.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <numeric>
#include <random>
#include <thread>

#include "results/run/results_file.h"
#include "results/run/run_writer.h"
#include "tests/results/support.h"

namespace raygauge::test_kill {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the helpers of this room's tests
using Clock = std::chrono::steady_clock;

constexpr int kCells = 12;
constexpr int kKills = 20;

/// Resumes the run at `path` with what is left to do, in a random order, and finishes it.
void run_to_the_end(const std::string& path, const Experiment& experiment, int thread_count, unsigned seed) {
  RunWriter run(path, experiment, RunMode::resume, sample_session());
  std::vector<std::uint64_t> cells(experiment.N.size());
  std::iota(cells.begin(), cells.end(), std::uint64_t{0});
  std::erase_if(cells, [&run](std::uint64_t cell) { return run.done().count(cell) != 0; });
  std::shuffle(cells.begin(), cells.end(), std::mt19937(seed));
  std::vector<std::thread> threads;
  for (int t = 0; t < thread_count; ++t) {
    threads.emplace_back([&, t] {
      for (std::size_t i = t; i < cells.size(); i += thread_count)
        run.store(cell_result(experiment, cells[i]));
    });
  }
  for (std::thread& thread : threads) thread.join();
  run.finish();
}

/// Starts run_to_the_end as a process of its own and kills it after `delay`. Whether the kill came in time.
bool run_and_kill(const std::string& path, const Experiment& experiment, int thread_count, unsigned seed,
                  Clock::duration delay) {
  const pid_t child = fork();
  if (child == 0) {
    run_to_the_end(path, experiment, thread_count, seed);
    _exit(0);
  }
  std::this_thread::sleep_for(delay);
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status);
}

class Kill : public ::testing::TestWithParam<int> {
 protected:
  Clock::duration time_of_a_run() const {
    const TemporaryFolder folder;
    const Clock::time_point begin = Clock::now();
    run_to_the_end(folder.file("x.h5"), experiment_, GetParam(), 0);
    return Clock::now() - begin;
  }

  Experiment experiment_ = small_experiment(kCells);
  std::vector<std::string> expected_ = fingerprints(sample_results(experiment_).records);
  std::mt19937 random_{42};
};

TEST_P(Kill, OnceAndResumedGivesTheSameRecords) {
  const Clock::duration whole = time_of_a_run();
  int killed = 0;
  for (unsigned i = 0; i < kKills; ++i) {
    const TemporaryFolder folder;
    const std::string path = folder.file("x.h5");
    const auto delay = whole * std::uniform_real_distribution<>(0, 1)(random_);
    killed +=
        run_and_kill(path, experiment_, GetParam(), i, std::chrono::duration_cast<Clock::duration>(delay));
    run_to_the_end(path, experiment_, GetParam(), kKills + i);
    ASSERT_EQ(fingerprints(read_results(path).records), expected_) << "kill " << i;
    ASSERT_EQ(entries_of(folder.path()), std::vector<std::string>{"x.h5"}) << "kill " << i;
  }
  EXPECT_GT(killed, 0);
}

TEST_P(Kill, AgainAndAgainInOneRunGivesTheSameRecords) {
  const Clock::duration step = time_of_a_run() / 4;
  const TemporaryFolder folder;
  const std::string path = folder.file("x.h5");
  for (unsigned i = 0; i < kKills; ++i) {
    const auto delay = step * std::uniform_real_distribution<>(0, 1)(random_);
    run_and_kill(path, experiment_, GetParam(), i, std::chrono::duration_cast<Clock::duration>(delay));
  }
  run_to_the_end(path, experiment_, GetParam(), kKills);
  EXPECT_EQ(fingerprints(read_results(path).records), expected_);
  EXPECT_EQ(entries_of(folder.path()), std::vector<std::string>{"x.h5"});
}

INSTANTIATE_TEST_SUITE_P(Threads, Kill, ::testing::Values(1, 2), ::testing::PrintToStringParamName());

}  // namespace
}  // namespace raygauge::test_kill
