// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/file_pairs.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include "cli/input/file_names.h"
#include "cli/input/file_sets.h"
#include "cli/input/text_table.h"
#include "cli/input/toml_refusal.h"
#include "cli/input/toml_values.h"
#include "generators/files.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostPairs = 100'000;

const std::vector<std::string> kMoves = {"scale_A", "scale_Q", "center_A", "center_Q", "pose_A", "pose_Q"};

/// A pair, and the place that messages name.
struct Pair {
  Parameters parameters;
  std::string place;
};

void check_number(std::size_t pairs, const std::string& place) {
  if (pairs <= kMostPairs) return;
  throw InvalidParameterError(place + ": more than " + std::to_string(kMostPairs) + " pairs of files");
}

std::vector<std::string> sources_of(const toml::node& node, const std::string& key, const fs::path& folder) {
  std::vector<std::string> sources;
  const auto add = [&](const toml::node& element) {
    const std::string pattern = read_text(element, "generator." + key);
    for (std::string& source : placed(element, [&] { return matching_sources(pattern, folder); }))
      sources.push_back(std::move(source));
  };
  const toml::array* list = node.as_array();
  if (list == nullptr) {
    add(node);
  } else {
    for (const toml::node& element : *list) add(element);
  }
  if (sources.empty()) refuse(node, "generator." + key + " must name a file");
  return sources;
}

std::vector<Pair> every_pair(const std::vector<std::string>& As, const std::vector<std::string>& Qs,
                             bool of_one_list, const std::string& place) {
  check_number(As.size() * Qs.size(), place);
  std::vector<std::string> all = As;
  all.insert(all.end(), Qs.begin(), Qs.end());
  const auto names = short_names(all);
  std::vector<Pair> pairs;
  for (const std::string& A : As) {
    for (const std::string& Q : Qs) {
      if (of_one_list && A == Q) continue;
      pairs.push_back({{{"A", A}, {"Q", Q}, {"pair", names.at(A) + "-" + names.at(Q)}}, place});
    }
  }
  return pairs;
}

/// What matches the pattern of a key, by what its `*` stands for.
std::map<std::string, std::string> by_matched_text(const toml::node& node, const std::string& key,
                                                   const fs::path& folder) {
  const std::string pattern = read_text(node, "generator." + key);
  std::map<std::string, std::string> sources;
  for (const std::string& source : placed(node, [&] { return matching_sources(pattern, folder); }))
    sources[matched_text(pattern, source)] = source;
  if (sources.count("") != 0) refuse(node, "generator." + key + " must be a pattern where paired = true");
  return sources;
}

/// Each A with the Q for which the patterns' `*` stand for the same text, which is the pair's name.
std::vector<Pair> paired_sources(const toml::node& A, const toml::node& Q, const fs::path& folder) {
  const auto As = by_matched_text(A, "A", folder);
  const auto Qs = by_matched_text(Q, "Q", folder);
  check_number(As.size(), place_of(A));
  std::vector<Pair> pairs;
  for (const auto& [text, source] : As) {
    const auto partner = Qs.find(text);
    if (partner == Qs.end()) refuse(Q, "no Q for '" + source + "'");
    pairs.push_back({{{"A", source}, {"Q", partner->second}, {"pair", text}}, place_of(A)});
  }
  for (const auto& [text, source] : Qs) {
    if (As.count(text) == 0) refuse(A, "no A for '" + source + "'");
  }
  return pairs;
}

/// Columns that say something of a pair; any other is the user's own.
std::vector<std::string> known_columns() {
  std::vector<std::string> known = kMoves;
  known.insert(known.end(), {"A", "Q", "pair", kExactDistance, kExactDistanceRounding});
  return known;
}

bool is_own_column(const std::string& name) {
  const std::vector<std::string> known = known_columns();
  return std::find(known.begin(), known.end(), name) == known.end();
}

/// A column of the user's must not look like a slip in one that is known.
void check_own_column(const std::string& name, const std::string& place) {
  constexpr const char* kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  const std::vector<std::string> known = known_columns();
  const bool only_case = std::any_of(known.begin(), known.end(), [&](const std::string& other) {
    return std::equal(name.begin(), name.end(), other.begin(), other.end(), same);
  });
  const bool reserved = name.starts_with("scale_") || name.starts_with("center_") ||
                        name.starts_with("pose_") || name.starts_with("content_") ||
                        name.starts_with("exact_") || name == "skip_header" || name == "stream";
  if (only_case || reserved) throw UnknownNameError("column", name, known, place);
  if (name.empty() || std::isdigit(static_cast<unsigned char>(name.front())) != 0 ||
      name.find_first_not_of(kLetters) != std::string::npos)
    throw InvalidParameterError(place + ": the column '" + name +
                                "' needs a name of letters, digits, '_', '-' and '.', a letter first");
}

double known_distance(const std::string& name, double value, const std::string& place) {
  if (value >= 0 && (name == kExactDistance || value < 1)) return value;
  throw InvalidParameterError(place + ": " + name + " must be " +
                              (name == kExactDistance ? "a distance" : "a relative error below 1"));
}

ParameterValue cell_value(const std::string& name, const std::string& text, const std::string& place) {
  if (is_own_column(name)) return text;
  if (name.starts_with("pose_")) return pose_text(parse_pose(text, place + ": " + name));
  if (name.starts_with("center_")) {
    if (text == "true" || text == "false") return text == "true";
    throw InvalidParameterError(place + ": " + name + " must be true or false, got '" + text + "'");
  }
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size())
    throw InvalidParameterError(place + ": " + name + " must be a number, got '" + text + "'");
  if (name == kExactDistance || name == kExactDistanceRounding) return known_distance(name, number, place);
  return number;
}

Pair pair_of(const TextTable& table, const TextTable::Row& row, const fs::path& folder) {
  Pair pair{{}, row.place};
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    const std::string& name = table.names[c];
    const std::string& text = row.cells[c];
    if (name == "A" || name == "Q") {
      if (text.empty()) throw InvalidParameterError(row.place + ": no file for " + name);
      pair.parameters[name] = (folder / text).string();
    } else if (name == "pair") {
      if (!text.empty()) pair.parameters[name] = text;
    } else if (!text.empty()) {
      pair.parameters[name] = cell_value(name, text, row.place);
    }
  }
  return pair;
}

/// `source` is relative to the experiment, and so are the names that come out.
std::vector<Pair> listed_pairs(const std::string& source, const fs::path& folder) {
  const TextTable table = read_text_table((folder / source).string());
  const std::string heading = (folder / source).string();
  for (const std::string& name : table.names) {
    if (is_own_column(name)) check_own_column(name, heading);
  }
  for (const char* needed : {"A", "Q"}) {
    if (std::find(table.names.begin(), table.names.end(), needed) == table.names.end())
      throw InvalidParameterError(heading + ": there is no column '" + needed + "'");
  }
  check_number(table.rows.size(), heading);
  std::vector<Pair> pairs;
  std::vector<std::string> sources;
  for (const TextTable::Row& row : table.rows) {
    pairs.push_back(pair_of(table, row, fs::path(source).parent_path()));
    for (const char* role : {"A", "Q"}) sources.push_back(string_parameter(pairs.back().parameters, role));
  }
  const auto names = short_names(sources);
  for (Pair& pair : pairs) {
    const auto name = [&](const char* role) { return names.at(string_parameter(pair.parameters, role)); };
    pair.parameters.emplace("pair", name("A") + "-" + name("Q"));
  }
  return pairs;
}

/// The values that a key sweeps.
std::vector<ParameterValue> values_of(const toml::node& node, const std::string& key) {
  const std::string full = "generator." + key;
  if (!key.starts_with("pose_")) return read_parameters(node, full);
  const auto pose = [&](const toml::node& element) -> ParameterValue {
    const toml::table* table = element.as_table();
    if (table == nullptr) refuse(element, full + " must be a table, as in { translation = [0, 0, 3] }");
    return pose_text(*table);
  };
  const toml::array* list = node.as_array();
  if (list == nullptr) return {pose(node)};
  std::vector<ParameterValue> values;
  for (const toml::node& element : *list) values.push_back(pose(element));
  if (values.empty()) refuse(node, full + " must not be empty");
  return values;
}

/// Each pair with every value of one more key.
std::vector<Pair> swept(const std::vector<Pair>& pairs, const std::string& key, const toml::node& node) {
  const std::vector<ParameterValue> values = values_of(node, key);
  check_number(pairs.size() * values.size(), place_of(node));
  std::vector<Pair> result;
  for (const Pair& pair : pairs) {
    if (pair.parameters.count(key) != 0)
      refuse(node, "generator." + key + " is a column of the CSV file as well: give one of them");
    for (const ParameterValue& value : values) {
      result.push_back(pair);
      result.back().parameters[key] = value;
    }
  }
  return result;
}

std::vector<Pair> unmoved_pairs(const toml::table& entry, const fs::path& folder) {
  const toml::node* A = entry.get("A");
  const toml::node* Q = entry.get("Q");
  const toml::node* files = entry.get("files");
  const toml::node* pairs = entry.get("pairs");
  const int ways =
      (A != nullptr || Q != nullptr ? 1 : 0) + (files != nullptr ? 1 : 0) + (pairs != nullptr ? 1 : 0);
  if (ways != 1 || (A == nullptr) != (Q == nullptr))
    refuse(entry, "generator 'files' needs A and Q, or files, or pairs");
  const toml::node* paired = entry.get("paired");
  if (paired != nullptr && A == nullptr) refuse(*paired, "generator.paired is for A and Q");
  if (pairs != nullptr) {
    const std::string source = read_text(*pairs, "generator.pairs");
    return placed(*pairs, [&] { return listed_pairs(source, folder); });
  }
  if (files != nullptr) {
    const std::vector<std::string> sources = sources_of(*files, "files", folder);
    if (sources.size() < 2) refuse(*files, "a pair needs two files, there is one");
    return every_pair(sources, sources, true, place_of(*files));
  }
  if (paired != nullptr && read_boolean(*paired, "generator.paired")) return paired_sources(*A, *Q, folder);
  const std::vector<std::string> As = sources_of(*A, "A", folder);
  return every_pair(As, sources_of(*Q, "Q", folder), false, place_of(*A));
}

std::string hexadecimal(std::uint64_t number) {
  std::string text(16, '0');
  for (std::size_t i = text.size(); i-- > 0; number /= 16) text[i] = "0123456789abcdef"[number % 16];
  return text;
}

GeneratorSpec spec_of(Pair pair, const GeneratorRegistry& registry) {
  const auto generator = registry.make(kFilesGenerator, pair.parameters);
  const auto& files = dynamic_cast<const FilePair&>(*generator);
  files.check();
  const SetFacts A = files.facts_of_A();
  const SetFacts Q = files.facts_of_Q();
  pair.parameters["content_A"] = hexadecimal(A.digest);
  pair.parameters["content_Q"] = hexadecimal(Q.digest);
  return {{kFilesGenerator, "", std::move(pair.parameters)}, {A.n}, {std::max(A.N, Q.N)}};
}

}  // namespace

std::vector<GeneratorSpec> read_file_pairs(const toml::table& entry, const fs::path& folder,
                                           const GeneratorRegistry& registry) {
  for (const char* axis : {"n", "N"}) {
    if (const toml::node* node = entry.get(axis))
      refuse(*node, std::string("generator 'files' takes ") + axis + " from its files");
  }
  std::vector<std::string> known = kMoves;
  known.insert(known.end(), {"name", "A", "Q", "files", "pairs", "paired", "skip_header", "stream"});
  reject_unknown_keys(entry, "key of generator 'files'", known);
  std::vector<Pair> pairs = unmoved_pairs(entry, folder);
  for (const std::string key : {"skip_header", "stream"}) {
    const toml::node* given = entry.get(key);
    if (given == nullptr) continue;
    const bool value = read_boolean(*given, "generator." + key);
    for (Pair& pair : pairs) pair.parameters[key] = value;
  }
  for (const std::string& key : kMoves) {
    if (const toml::node* node = entry.get(key)) pairs = swept(pairs, key, *node);
  }
  std::vector<GeneratorSpec> specs;
  std::set<std::string> seen;
  for (Pair& pair : pairs) {
    const std::string place = pair.place;
    if (!seen.insert(to_string(pair.parameters)).second)
      throw InvalidParameterError(place + ": the pair '" + string_parameter(pair.parameters, "pair") +
                                  "' appears twice");
    try {
      specs.push_back(spec_of(std::move(pair), registry));
    } catch (const Error& error) {
      throw InvalidParameterError(place + ": " + error.what());
    }
  }
  return specs;
}

}  // namespace raygauge::cli
