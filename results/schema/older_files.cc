// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/schema/older_files.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <unordered_map>

#include "engine/numerics/number_text.h"
#include "raygauge/sweep/method.h"

namespace raygauge {
namespace {

/// The registered names of the methods of version 1.
constexpr std::array<std::string_view, 13> kMethods = {
    "direct",      "newton",    "zheng_yamane", "glpk_primal", "glpk_dual",  "clp_dual", "clp_primal",
    "nlopt_slsqp", "nlopt_mma", "exact",        "command",     "fcl_libccd", "fcl_indep"};

/// The generators' parameters of version 1 that measure hardness.
struct OldHardness {
  std::string_view parameter;
  const char* label;
  double (*of)(double value);
};

constexpr std::array<OldHardness, 5> kHardness = {{
    {"aspect", "aspect", [](double value) { return value; }},
    {"delta", "1/δ", [](double value) { return 1 / value; }},
    {"entry", "entry", [](double value) { return value; }},
    {"exponent", "scale", [](double value) { return std::exp2(value); }},
    {"offset", "offset", [](double value) { return value; }},
}};

using NamesByLabel = std::map<std::string, std::string, std::less<>>;

constexpr std::string_view kMethodsLine = "methods = [";
constexpr std::string_view kAs = " as ";

/// The entries of the line "methods = [a, b as c {x=1}]" of an identity, and where they stand in it.
std::vector<std::string_view> method_entries(std::string_view identity) {
  std::vector<std::string_view> entries;
  const std::size_t start = identity.find(kMethodsLine);
  if (start == std::string_view::npos) return entries;
  std::string_view list = identity.substr(start + kMethodsLine.size());
  list = list.substr(0, list.find('\n'));
  list = list.substr(0, list.rfind(']'));
  std::size_t begin = 0;
  int depth = 0;
  for (std::size_t i = 0; i <= list.size(); ++i) {
    if (i == list.size() || (depth == 0 && list.substr(i, 2) == ", ")) {
      if (i > begin) entries.push_back(list.substr(begin, i - begin));
      begin = i + 2;
    } else if (list[i] == '{') {
      ++depth;
    } else if (list[i] == '}') {
      --depth;
    }
  }
  return entries;
}

/// "glpk_dual" of "glpk_dual as lp {scale=true}".
std::string_view name_of_entry(std::string_view entry) {
  entry = entry.substr(0, entry.find(" {"));
  return entry.substr(0, entry.find(kAs));
}

NamesByLabel names_by_label(std::string_view identity) {
  NamesByLabel names;
  for (std::string_view entry : method_entries(identity)) {
    const std::string name(name_of_entry(entry));
    entry = entry.substr(0, entry.find(" {"));
    const std::size_t as = entry.find(kAs);
    names.emplace(as == std::string_view::npos ? name : std::string(entry.substr(as + kAs.size())),
                  current_method_name(name));
  }
  return names;
}

std::string method_name_of(const std::string& label, const NamesByLabel& names) {
  if (const auto found = names.find(label); found != names.end()) return found->second;
  std::string_view longest;
  for (const std::string_view method : kMethods) {
    if (label.starts_with(method) && method.size() > longest.size()) longest = method;
  }
  return longest.empty() ? label : current_method_name(std::string(longest));
}

Role role_of(std::string_view name) {
  if (name.starts_with("exact")) return Role::oracle;
  for (const std::string_view library : {"glpk", "clp", "nlopt", "fcl", "command"}) {
    if (name.starts_with(library)) return Role::baseline;
  }
  return Role::engine;
}

/// The value of NAME=VALUE among "a=1 name=2".
std::optional<double> parameter_of(const std::string& parameters, std::string_view name) {
  const std::string mark = " " + std::string(name) + "=";
  const std::string text = " " + parameters;
  const std::size_t found = text.find(mark);
  if (found == std::string::npos) return std::nullopt;
  double value = 0;
  const char* begin = text.data() + found + mark.size();
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
  return error == std::errc() ? std::optional(value) : std::nullopt;
}

void complete_hardness(Record& record) {
  for (const OldHardness& hardness : kHardness) {
    const std::optional<double> value = parameter_of(record.generator_parameters, hardness.parameter);
    if (!value) continue;
    record.hardness_label = hardness.label;
    record.hardness = hardness.of(*value);
    return;
  }
}

/// `text` with_current_numbers(), of each text once: records have few.
class CurrentNumbers {
 public:
  void apply(std::string& text) {
    if (text.empty()) return;
    const auto [known, is_new] = current_.try_emplace(text);
    if (is_new) known->second = with_current_numbers(text);
    if (known->second != text) text = known->second;
  }

 private:
  std::unordered_map<std::string, std::string> current_;
};

}  // namespace

void complete_older_records(std::vector<Record>& records, const std::string& identity) {
  constexpr double kRoundingOfExample1 = 0x1p-45;
  const NamesByLabel names = names_by_label(identity);
  CurrentNumbers of_generators;
  CurrentNumbers of_methods;
  for (Record& record : records) {
    of_generators.apply(record.generator_parameters);
    of_methods.apply(record.method_parameters);
    if (!record.method_name.empty()) continue;
    const bool is_labelled = names.find(record.method) != names.end();
    if (!is_labelled) record.method = current_method_name(record.method);
    record.method_name = method_name_of(record.method, names);
    record.role = role_of(record.method_name);
    if (record.generator == "example1") record.exact_distance_rounding = kRoundingOfExample1;
    complete_hardness(record);
  }
}

std::string current_identity(const std::string& identity) {
  std::string result = identity;
  std::vector<std::string_view> entries = method_entries(identity);
  std::ranges::reverse(entries);
  for (const std::string_view entry : entries) {
    const std::string name(name_of_entry(entry));
    const auto place = static_cast<std::size_t>(entry.data() - identity.data());
    result.replace(place, name.size(), current_method_name(name));
  }
  return result;
}

}  // namespace raygauge
