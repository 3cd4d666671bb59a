// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/parameter_columns.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "engine/sweep/parameter_text.h"
#include "raygauge/exceptions.h"
#include "results/journal/csv.h"
#include "results/text/language.h"

namespace raygauge {
namespace {

constexpr std::string_view kOfGenerator = "generator.";
constexpr std::string_view kOfMethod = "method.";

std::optional<std::string> value_in(const std::string& parameters, std::string_view name) {
  for (const auto& [key, value] : split_parameters(parameters)) {
    if (key == name) return value;
  }
  return std::nullopt;
}

std::optional<std::string> value_of(const Record& record, std::string_view name) {
  if (name.starts_with(kOfGenerator))
    return value_in(record.generator_parameters, name.substr(kOfGenerator.size()));
  if (name.starts_with(kOfMethod)) return value_in(record.method_parameters, name.substr(kOfMethod.size()));
  if (auto of_generator = value_in(record.generator_parameters, name)) return of_generator;
  return value_in(record.method_parameters, name);
}

std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// The names in either kind of parameters; each distinct text is taken apart once.
std::pair<std::set<std::string>, std::set<std::string>> names_in(const std::vector<Record>& records) {
  std::set<std::string> generators;
  std::set<std::string> methods;
  for (const Record& record : records) {
    generators.insert(record.generator_parameters);
    methods.insert(record.method_parameters);
  }
  const auto names_of = [](const std::set<std::string>& texts) {
    std::set<std::string> names;
    for (const std::string& text : texts) {
      for (const auto& [name, value] : split_parameters(text)) names.insert(name);
    }
    return names;
  };
  return {names_of(generators), names_of(methods)};
}

/// "generator example2 separation": sorts and compares as one text.
std::string owned_name(const char* kind, const std::string& owner, const std::string& name) {
  return std::string(kind) + '\n' + owner + '\n' + name;
}

}  // namespace

std::vector<std::string> parameter_names(const std::vector<Record>& records) {
  const auto [generators, methods] = names_in(records);
  std::set<std::string> all = generators;
  all.insert(methods.begin(), methods.end());
  std::vector<std::string> names;
  std::vector<std::string> qualified;
  for (const std::string& name : all) {
    const bool is_column = find_analysis_column(name) != nullptr;
    if (!is_column) names.push_back(name);
    if (!is_column && (generators.count(name) == 0 || methods.count(name) == 0)) continue;
    if (generators.count(name) != 0) qualified.push_back(std::string(kOfGenerator) + name);
    if (methods.count(name) != 0) qualified.push_back(std::string(kOfMethod) + name);
  }
  names.insert(names.end(), qualified.begin(), qualified.end());
  return names;
}

std::string parameter_text(const Record& record, const std::string& name) {
  return value_of(record, name).value_or("");
}

AnalysisColumn parameter_column(const std::vector<Record>& records, const std::string& name) {
  const bool numbers = std::all_of(records.begin(), records.end(), [&](const Record& record) {
    const auto number = number_in(parameter_text(record, name));
    return number && *number == *number;
  });
  AnalysisColumn column{
      {name, "1", "parameter " + name, numbers ? ValueType::float64 : ValueType::text}, {}, {}, false};
  column.get = [name, numbers](const Record& record) -> Value {
    std::string text = parameter_text(record, name);
    if (numbers) return *number_in(text);
    return text;
  };
  return column;
}

AnalysisColumn column_among(const std::vector<Record>& records, const std::string& name,
                            const std::string& place) {
  if (const AnalysisColumn* column = find_analysis_column(name)) return *column;
  const bool there = std::any_of(records.begin(), records.end(),
                                 [&](const Record& record) { return value_of(record, name).has_value(); });
  if (there) return parameter_column(records, name);
  std::vector<std::string> known;
  for (const AnalysisColumn& column : analysis_columns()) known.push_back(column.name);
  for (std::string& parameter : parameter_names(records)) known.push_back(std::move(parameter));
  throw UnknownNameError("column", name, known, place);
}

namespace {

/// Whether the texts of parameters still differ from each other without those of a name in `dropped`.
bool differ_without(const std::vector<std::string>& texts, const std::set<std::string>& dropped) {
  std::set<std::string> seen;
  return std::all_of(texts.begin(), texts.end(), [&](const std::string& text) {
    std::string rest;
    for (const auto& [name, value] : split_parameters(text)) {
      if (dropped.count(name) == 0) rest += name + '\n' + value + '\n';
    }
    return seen.insert(rest).second;
  });
}

/// Texts among the parameters that the others tell apart already, as the files of a pair that has a name.
std::set<std::string> redundant_texts(const std::vector<std::string>& texts) {
  std::set<std::string> names;
  for (const std::string& text : texts) {
    for (const auto& [name, value] : split_parameters(text)) {
      if (!number_in(value)) names.insert(name);
    }
  }
  std::set<std::string> dropped;
  for (const std::string& name : names) {
    dropped.insert(name);
    if (!differ_without(texts, dropped)) dropped.erase(name);
  }
  return dropped;
}

}  // namespace

VaryingParameters::VaryingParameters(const RecordGroups& records) {
  std::map<std::string, std::set<std::string>> values;
  std::set<std::pair<std::string, std::string>> seen;
  const auto add = [&](const char* kind, const std::string& owner, const std::string& parameters) {
    if (!seen.emplace(kind + owner, parameters).second) return;
    for (const auto& [name, value] : split_parameters(parameters))
      values[owned_name(kind, owner, name)].insert(value);
  };
  for (const RecordGroup& group : records) {
    const Record& record = group.first();
    add("generator", record.generator, record.generator_parameters);
    add("method", record.method, record.method_parameters);
  }
  std::map<std::string, std::vector<std::string>> of_generator;
  for (const auto& [owner, parameters] : seen) {
    if (owner.starts_with("generator")) of_generator[owner].push_back(parameters);
  }
  std::set<std::string> redundant;
  for (const auto& [owner, texts] : of_generator) {
    for (const std::string& name : redundant_texts(texts))
      redundant.insert(owned_name("generator", owner.substr(std::string("generator").size()), name));
  }
  for (const auto& [name, all] : values) {
    if (all.size() > 1 && redundant.count(name) == 0) varying_.push_back(name);
  }
}

std::string VaryingParameters::of_generator(const Record& record) const {
  return varying_of("generator", record.generator, record.generator_parameters);
}

std::string VaryingParameters::of_method(const Record& record) const {
  return varying_of("method", record.method, record.method_parameters);
}

std::string VaryingParameters::varying_of(const char* kind, const std::string& owner,
                                          const std::string& parameters) const {
  std::string text;
  for (const auto& [name, value] : split_parameters(parameters)) {
    if (!std::binary_search(varying_.begin(), varying_.end(), owned_name(kind, owner, name))) continue;
    text += (text.empty() ? "" : " ") + name + "=" + quoted_where_needed(value);
  }
  return text;
}

std::string tidy_csv(const std::vector<Record>& records) {
  std::vector<std::string> names = parameter_names(records);
  const auto [generators, methods] = names_in(records);
  const std::set<std::string> in_generators = generators;
  const std::set<std::string> in_methods = methods;
  // A short name that both kinds have would say of which it is only record by record.
  names.erase(std::remove_if(names.begin(), names.end(),
                             [&](const std::string& name) {
                               return in_generators.count(name) != 0 && in_methods.count(name) != 0;
                             }),
              names.end());
  std::string text = csv_header();
  text.pop_back();
  for (const std::string& name : names) text += "," + language::csv(name);
  text += '\n';
  for (const Record& record : records) {
    text += csv_rows({record});
    text.pop_back();
    for (const std::string& name : names) text += "," + language::csv(parameter_text(record, name));
    text += '\n';
  }
  return text;
}

}  // namespace raygauge
