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

#include "tests/fuzz/harness.h"

namespace raygauge::fuzz {
namespace {

namespace fs = std::filesystem;

struct Target {
  std::string name;
  void (*check)(std::string_view input);
};

const std::vector<Target>& targets() {
  static const std::vector<Target> all = {
      {"point_file", check_point_file},
      {"mesh_file", check_mesh_file},
      {"experiment_file", check_experiment_file},
      {"set_file", check_set_file},
      {"set_pair", check_set_pair},
      {"override", check_override},
      {"results_file", check_results_file},
      {"cell_journal", check_cell_journal},
      {"csv_rows", check_csv_rows},
      {"dataset", check_dataset},
      {"filter", check_filter},
#ifdef RAYGAUGE_HAS_EXACT
      {"solver", check_solver},
#endif
  };
  return all;
}

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
