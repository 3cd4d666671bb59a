// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Runs one fuzz target over its seeds and over every input that once broke a promise: one test a file. The
// program replay_TARGET is this and fuzz_TARGET.cc.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/fuzz/harness.h"

namespace raygauge::fuzz {
namespace {

namespace fs = std::filesystem;

/// Of the program that runs: replay_TARGET.
std::string target;

/// The files of corpus/TARGET and found/TARGET.
std::vector<fs::path> frozen_inputs() {
  std::vector<fs::path> inputs;
  for (const char* kind : {"corpus", "found"}) {
    const fs::path folder = fs::path(RAYGAUGE_FUZZ_FOLDER) / kind / target;
    if (!fs::is_directory(folder)) continue;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) inputs.push_back(entry.path());
  }
  std::sort(inputs.begin(), inputs.end());
  return inputs;
}

std::string test_name(const testing::TestParamInfo<fs::path>& info) {
  std::string name = info.param.parent_path().parent_path().filename() / info.param.stem();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

class Input : public testing::TestWithParam<fs::path> {};

TEST_P(Input, BreaksNoPromise) {
  std::ifstream file(GetParam(), std::ios::binary);
  ASSERT_TRUE(file) << GetParam();
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NO_THROW(LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
}

INSTANTIATE_TEST_SUITE_P(FuzzRegressions, Input, testing::ValuesIn(frozen_inputs()), test_name);

}  // namespace
}  // namespace raygauge::fuzz

int main(int argc, char** argv) {
  const std::string program = std::filesystem::path(argv[0]).filename();
  raygauge::fuzz::target = program.substr(std::string("replay_").size());
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
