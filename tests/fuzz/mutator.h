// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace raygauge::fuzz {

constexpr std::size_t kLongestInput = 1 << 16;

/// What readers choke on: sizes, signs, words that are numbers to some.
constexpr std::array<const char*, 14> kTokens = {
    "1000000000", "4294967295", "-1", "9223372036854775807",       "1e308", "1e-320", "nan", "inf", "0", "[[",
    "\"",         "=",          "\n", "element vertex 999999999\n"};

/// Changes seeds at random: bits, bytes, numbers, words; cuts, pieces twice, and two seeds in one.
class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::string changed(const std::vector<std::string>& seeds) {
    std::string input = seeds[below(seeds.size())];
    for (std::size_t i = 1 + below(4); i > 0; --i) change(input, seeds);
    if (input.size() > kLongestInput) input.resize(kLongestInput);
    return input;
  }

  std::string flipped(const std::string& bytes) {
    std::string input = bytes;
    const std::size_t bit = below(8 * input.size());
    input[bit / 8] = static_cast<char>(input[bit / 8] ^ (1 << bit % 8));
    return input;
  }

 private:
  std::size_t below(std::size_t bound) { return bound == 0 ? 0 : random_() % bound; }

  void change(std::string& input, const std::vector<std::string>& seeds) {
    const std::size_t at = below(input.size() + 1);
    switch (below(8)) {
      case 0:
        if (at < input.size()) input[at] = static_cast<char>(below(256));
        return;
      case 1:
        input.erase(at, below(16));
        return;
      case 2:
        input.resize(at);
        return;
      case 3:
        input.insert(at, kTokens[below(kTokens.size())]);
        return;
      case 4:
        replace_number(input, at);
        return;
      case 5:
        if (!input.empty()) input = flipped(input);
        return;
      case 6:
        input.insert(at, line_from(input, at));
        return;
      default:
        const std::string& other = seeds[below(seeds.size())];
        input = input.substr(0, at) + other.substr(below(other.size() + 1));
    }
  }

  /// The rest of a line, and its end.
  static std::string line_from(const std::string& input, std::size_t at) {
    return input.substr(at, std::min(input.find('\n', at), input.size()) + 1 - at);
  }

  /// The number behind `at` becomes another one.
  void replace_number(std::string& input, std::size_t at) {
    constexpr const char* kDigits = "0123456789";
    const std::size_t begin = input.find_first_of(kDigits, at);
    if (begin == std::string::npos) return;
    const std::size_t end = std::min(input.find_first_not_of(kDigits, begin), input.size());
    input.replace(begin, end - begin, kTokens[below(9)]);
  }

  std::mt19937 random_;
};

/// The inputs that are kept in corpus/NAME and found/NAME, in the order of their paths.
inline std::vector<std::string> seeds_of(const std::string& name) {
  std::vector<std::filesystem::path> files;
  for (const char* kind : {"corpus", "found"}) {
    const std::filesystem::path folder = std::filesystem::path(RAYGAUGE_FUZZ_FOLDER) / kind / name;
    if (!std::filesystem::is_directory(folder)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> seeds;
  for (const std::filesystem::path& path : files) {
    std::ifstream file(path, std::ios::binary);
    seeds.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return seeds;
}

/// How many inputs each test is to try: RAYGAUGE_FUZZ_INPUTS, or `few`.
inline int inputs_wanted(int few) {
  const char* text = std::getenv("RAYGAUGE_FUZZ_INPUTS");
  return text == nullptr ? few : std::max(1, std::atoi(text));
}

}  // namespace raygauge::fuzz
