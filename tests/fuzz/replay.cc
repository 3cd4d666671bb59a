// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Runs every fuzz target over its seeds (corpus/TARGET) and over every input that once broke a promise
// (found/TARGET): one test a file.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "tests/fuzz/targets.h"

namespace raygauge::fuzz {
namespace {

namespace fs = std::filesystem;

struct FrozenInput {
  Target target;
  fs::path file;
};

std::vector<FrozenInput> inputs_in(const std::string& kind) {
  std::vector<FrozenInput> inputs;
  for (const Target& target : targets()) {
    const fs::path folder = fs::path(RAYGAUGE_FUZZ_FOLDER) / kind / target.name;
    if (!fs::is_directory(folder)) continue;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
      inputs.push_back({target, entry.path()});
  }
  std::sort(inputs.begin(), inputs.end(), [](const auto& a, const auto& b) { return a.file < b.file; });
  return inputs;
}

std::string test_name(const testing::TestParamInfo<FrozenInput>& info) {
  std::string name = info.param.target.name + "_" + info.param.file.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

class Input : public testing::TestWithParam<FrozenInput> {};

TEST_P(Input, BreaksNoPromise) {
  std::ifstream file(GetParam().file, std::ios::binary);
  ASSERT_TRUE(file) << GetParam().file;
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NO_THROW(GetParam().target.check(bytes));
}

INSTANTIATE_TEST_SUITE_P(Seeds, Input, testing::ValuesIn(inputs_in("corpus")), test_name);
INSTANTIATE_TEST_SUITE_P(Found, Input, testing::ValuesIn(inputs_in("found")), test_name);

TEST(Targets, EachHasSeeds) {
  std::set<std::string> with_seeds;
  for (const FrozenInput& input : inputs_in("corpus")) with_seeds.insert(input.target.name);
  for (const Target& target : targets()) EXPECT_TRUE(with_seeds.contains(target.name)) << target.name;
}

}  // namespace
}  // namespace raygauge::fuzz
