// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/run/identity.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <map>
#include <sstream>
#include <type_traits>
#include <vector>

namespace raygauge {
namespace {

std::string text_of(double number) { return to_string(ParameterValue(number)); }
std::string text_of(int number) { return std::to_string(number); }

std::string text_of(const ComponentSpec& component) {
  std::string text = component.name;
  if (!component.label.empty() && component.label != component.name) text += " as " + component.label;
  const std::string parameters = to_string(component.parameters);
  return parameters.empty() ? text : text + " {" + parameters + "}";
}

std::string text_of(const GeneratorSpec& generator);

template <class T>
std::string text_of(const std::vector<T>& values) {
  std::string text = "[";
  for (const T& value : values) text += (text.size() > 1 ? ", " : "") + text_of(value);
  return text + "]";
}

std::string text_of(const GeneratorSpec& generator) {
  std::string text = text_of(static_cast<const ComponentSpec&>(generator));
  if (!generator.n.empty()) text += " n = " + text_of(generator.n);
  if (!generator.N.empty()) text += " N = " + text_of(generator.N);
  return text;
}

std::string line_of(const std::string& key, const std::string& value) { return key + " = " + value; }

/// The elements of "[a, b {x=[1,2], y=3}]", those in brackets and quotes being whole.
std::vector<std::string> elements_of(const std::string& list) {
  std::vector<std::string> elements(1);
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 1; i + 1 < list.size(); ++i) {
    const char c = list[i];
    if (c == '"' && list[i - 1] != '\\') quoted = !quoted;
    if (!quoted) depth += (c == '[' || c == '{' ? 1 : 0) - (c == ']' || c == '}' ? 1 : 0);
    if (!quoted && depth == 0 && c == ',') {
      elements.emplace_back();
      ++i;  // the blank
    } else {
      elements.back() += c;
    }
  }
  return elements;
}

/// Lists that are too long to be read show the first element that differs.
constexpr std::size_t kLongest = 200;

std::string difference(const std::string& key, const std::string& there, const std::string& here) {
  if (there.size() > kLongest && there.starts_with('[') && here.starts_with('[')) {
    const std::vector<std::string> of_there = elements_of(there);
    const std::vector<std::string> of_here = elements_of(here);
    const auto [a, b] = std::mismatch(of_there.begin(), of_there.end(), of_here.begin(), of_here.end());
    return line_of(key, a == of_there.end() ? "nothing" : *a) + " there, " +
           (b == of_here.end() ? "nothing" : *b) + " here";
  }
  return line_of(key, there) + " there, " + here + " here";
}

using KeyValue = std::pair<std::string, std::string>;

std::vector<KeyValue> lines_of(const std::string& identity) {
  std::vector<KeyValue> lines;
  std::istringstream stream(identity);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t equals = line.find(" = ");
    lines.emplace_back(line.substr(0, equals), equals == std::string::npos ? "" : line.substr(equals + 3));
  }
  return lines;
}

}  // namespace

std::string experiment_identity(const Experiment& experiment) {
  std::vector<KeyValue> lines = {
      {"seed", std::to_string(experiment.seed)},
      {"repetitions", text_of(experiment.repetitions)},
      {"warmup", text_of(experiment.warmup)},
      {"min_seconds", text_of(experiment.min_seconds)},
      {"timing", experiment.timing == TimingMode::serial ? "serial" : "parallel"},
      {"time_limit", text_of(experiment.time_limit)},
      {"grid", experiment.grid == GridMode::cartesian ? "cartesian" : "paired"},
      {"n", text_of(experiment.n)},
      {"N", text_of(experiment.N)},
      {"tolerance", text_of(experiment.tolerance)},
      {"generators", text_of(experiment.generators)},
      {"methods", text_of(experiment.methods)},
  };
  // Absent where it is off.
  if (experiment.stop_when_within > 0) {
    lines.emplace_back("min_repetitions", text_of(experiment.min_repetitions));
    lines.emplace_back("stop_when_within", text_of(experiment.stop_when_within));
  }
  std::string identity;
  for (const auto& [key, value] : lines) identity += line_of(key, value) + "\n";
  return identity;
}

std::string identity_difference(const std::string& there, const std::string& here) {
  const std::vector<KeyValue> lines_there = lines_of(there);
  const std::vector<KeyValue> lines_here = lines_of(here);
  const std::map<std::string, std::string> values_here(lines_here.begin(), lines_here.end());
  std::map<std::string, std::string> only_here = values_here;
  std::vector<std::string> differences;
  for (const auto& [key, value] : lines_there) {
    only_here.erase(key);
    const auto found = values_here.find(key);
    const std::string other = found == values_here.end() ? "nothing" : found->second;
    if (other != value) differences.push_back(difference(key, value, other));
  }
  for (const auto& [key, value] : only_here) differences.push_back(difference(key, "nothing", value));
  if (differences.empty()) return "";
  const std::size_t more = differences.size() - 1;
  return differences.front() + (more == 0 ? "" : " (and " + std::to_string(more) + " more)");
}

int repetitions_of_whole_cells(const std::string& identity) {
  int repetitions = 1;
  for (const auto& [key, value] : lines_of(identity)) {
    if (key == "stop_when_within") return 1;  // such a cell is stored in one piece
    if (key == "repetitions") std::from_chars(value.data(), value.data() + value.size(), repetitions);
  }
  return repetitions;
}

}  // namespace raygauge
