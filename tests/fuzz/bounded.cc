// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Every reader on seeds that were changed at random, in a process of little memory and with little time for
// each input: what a header claims must not be believed. RAYGAUGE_FUZZ_INPUTS says how many inputs a target
// gets.
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/fuzz/harness.h"
#include "tests/fuzz/limits.h"
#include "tests/fuzz/mutator.h"
#include "tests/fuzz/targets.h"

namespace raygauge::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr rlim_t kMostMemory = rlim_t{256} << 20;
constexpr int kMostSeconds = kSlower;  // of processor time, for one input
constexpr int kFewInputs = 250;

/// The input that the child is at, where its parent sees it.
struct Shared {
  std::size_t size;
  std::array<char, kLongestInput> bytes;
  std::array<char, 256> complaint;
};

/// Sends SIGPROF, which ends the process, after so much processor time.
void limit_time() {
  const itimerval time{{0, 0}, {kMostSeconds, 0}};
  ::setitimer(ITIMER_PROF, &time, nullptr);
}

[[noreturn]] void feed(const Target& target, const std::vector<std::string>& seeds, Shared& shared) {
  limit_memory(kMostMemory);
  Mutator mutator(1);
  int findings = 0;
  for (int i = inputs_wanted(kFewInputs); i > 0 && findings == 0; --i) {
    const std::string input = mutator.changed(seeds);
    shared.size = input.size();
    std::copy(input.begin(), input.end(), shared.bytes.begin());
    limit_time();
    try {
      target.check(input);
    } catch (const std::exception& finding) {
      std::strncpy(shared.complaint.data(), finding.what(), shared.complaint.size() - 1);
      ++findings;
    }
  }
  ::_exit(findings == 0 ? 0 : 1);
}

/// Where an input that broke a promise is kept for found/TARGET.
std::string kept(const Target& target, const Shared& shared) {
  const fs::path path = fs::temp_directory_path() / ("raygauge-fuzz-found-" + target.name);
  std::ofstream(path, std::ios::binary).write(shared.bytes.data(), static_cast<std::streamsize>(shared.size));
  return path.string();
}

/// Scratch files of a process that had no time to remove them.
void remove_scratch_of(pid_t process) {
  const std::string prefix = "raygauge-fuzz-" + std::to_string(process);
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(fs::temp_directory_path())) {
    if (entry.path().filename().string().starts_with(prefix)) fs::remove(entry.path(), ignored);
  }
}

std::vector<Target> readers() {
  std::vector<Target> readers;
  for (const Target& target : targets()) {
    if (target.is_reader) readers.push_back(target);
  }
  return readers;
}

class EveryReader : public testing::TestWithParam<Target> {};

TEST_P(EveryReader, StaysWithinMemoryAndTime) {
  const Target& target = GetParam();
  const std::vector<std::string> seeds = seeds_of(target.name);
  ASSERT_FALSE(seeds.empty());
  void* memory = ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(memory, MAP_FAILED);
  Shared& shared = *static_cast<Shared*>(memory);
  const pid_t child = ::fork();
  if (child == 0) feed(target, seeds, shared);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  remove_scratch_of(child);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    ADD_FAILURE() << (WIFSIGNALED(status) ? ::strsignal(WTERMSIG(status)) : shared.complaint.data())
                  << "; the input is kept in " << kept(target, shared);
  }
  ::munmap(memory, sizeof(Shared));
}

std::string name_of(const testing::TestParamInfo<Target>& of) { return of.param.name; }

INSTANTIATE_TEST_SUITE_P(Fuzz, EveryReader, testing::ValuesIn(readers()), name_of);

}  // namespace
}  // namespace raygauge::fuzz
