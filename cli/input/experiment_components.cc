// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/experiment_components.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include "cli/input/file_pairs.h"
#include "cli/input/toml_values.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

/// The tables of [[kind]], at least one.
std::vector<const toml::table*> entries_of(const TomlSource& source, const std::string& kind) {
  const toml::node* node = source.root.get(kind);
  const std::string wanted = "expected at least one [[" + kind + "]] entry";
  if (node == nullptr) throw InvalidParameterError(source.path + ": " + wanted);
  std::vector<const toml::table*> entries;
  if (const toml::array* array = node->as_array()) {
    for (const toml::node& element : *array) entries.push_back(element.as_table());
  }
  if (entries.empty() || std::find(entries.begin(), entries.end(), nullptr) != entries.end()) {
    throw InvalidParameterError(place_of(*node) + ": " + wanted);
  }
  return entries;
}

/// What the registry knows of the component that `entry` names.
template <class T>
const Component<T>& named_component(const toml::table& entry, const std::string& kind,
                                    const Registry<T>& registry) {
  const toml::node* node = entry.get("name");
  if (node == nullptr) throw InvalidParameterError(place_of(entry) + ": a [[" + kind + "]] needs a name");
  const std::string name = read_text(*node, kind + ".name");
  const Component<T>* component = registry.find_if_known(name);
  if (component == nullptr) throw UnknownNameError(kind, name, registry.names(), place_of(*node));
  return *component;
}

/// Rejects keys that are neither `reserved` nor parameters of the component.
template <class T>
void check_keys(const toml::table& entry, const std::string& kind, const Component<T>& component,
                std::vector<std::string> reserved) {
  for (const ParameterInfo& info : component.parameters) reserved.push_back(info.name);
  reject_unknown_keys(entry, "key of " + kind + " '" + component.name + "'", reserved);
}

/// Throws the registry's complaint about one value, if it has one, with file and line.
template <class T>
void check_value(const toml::node& node, const std::string& kind, const Component<T>& component,
                 const std::string& parameter, const ParameterValue& value) {
  complete(place_of(node) + ": " + kind + " '" + component.name + "'", component.parameters,
           {{parameter, value}});
}

/// More variants of one generator than any sweep has use for; a slip in a range ends here, not in memory.
constexpr std::size_t kMaxCombinations = 100'000;

/// Every combination of one more parameter's values with those chosen so far.
std::vector<Parameters> combine(const std::vector<Parameters>& chosen, const std::string& name,
                                const std::vector<ParameterValue>& values) {
  std::vector<Parameters> result;
  for (const Parameters& parameters : chosen) {
    for (const ParameterValue& value : values) {
      result.push_back(parameters);
      result.back()[name] = value;
    }
  }
  return result;
}

const std::vector<std::string>& keys_of_sweep() {
  static const std::vector<std::string> kKeys = {"name", "n", "N"};
  return kKeys;
}

/// Whether a key of [[generator]] is for the sweep, and no parameter of the generator.
bool is_key_of_sweep(const std::string& key) {
  return std::find(keys_of_sweep().begin(), keys_of_sweep().end(), key) != keys_of_sweep().end();
}

/// The axis that an entry has of its own; empty if it has none.
std::vector<int> axis_of(const toml::table& entry, const std::string& key) {
  const toml::node* node = entry.get(key);
  if (node == nullptr) return {};
  const Range range{1, std::numeric_limits<int>::max()};
  const std::vector<std::int64_t> values = read_integers(*node, "generator." + key, range);
  return {values.begin(), values.end()};
}

std::vector<Parameters> swept_parameters(const toml::table& entry, const Component<Generator>& component) {
  std::vector<Parameters> combinations(1);
  for (const auto& [key, node] : entry) {
    const std::string name(key.str());
    if (is_key_of_sweep(name)) continue;
    const std::vector<ParameterValue> values = read_parameters(node, "generator." + name);
    for (const ParameterValue& value : values) check_value(node, "generator", component, name, value);
    if (values.size() > kMaxCombinations / combinations.size()) {
      throw InvalidParameterError(place_of(node) + ": more than " + std::to_string(kMaxCombinations) +
                                  " combinations of parameters of generator '" + component.name + "'");
    }
    combinations = combine(combinations, name, values);
  }
  return combinations;
}

}  // namespace

std::vector<GeneratorSpec> read_generators(const TomlSource& source, const GeneratorRegistry& registry) {
  const std::filesystem::path folder = std::filesystem::path(source.path).parent_path();
  std::vector<GeneratorSpec> specs;
  std::set<std::pair<std::string, std::string>> seen;
  for (const toml::table* entry : entries_of(source, "generator")) {
    const Component<Generator>& component = named_component(*entry, "generator", registry);
    if (component.name == kFilesGenerator) {
      for (GeneratorSpec& pair : read_file_pairs(*entry, folder, registry)) specs.push_back(std::move(pair));
      continue;
    }
    check_keys(*entry, "generator", component, keys_of_sweep());
    for (const Parameters& parameters : swept_parameters(*entry, component)) {
      const std::string completed = to_string(complete(component.name, component.parameters, parameters));
      if (!seen.emplace(component.name, completed).second) {
        throw InvalidParameterError(place_of(*entry) + ": generator '" + component.name + "' appears twice" +
                                    (completed.empty() ? "" : " with " + completed));
      }
      specs.push_back({{component.name, "", parameters}, axis_of(*entry, "n"), axis_of(*entry, "N")});
    }
  }
  return specs;
}

std::vector<ComponentSpec> read_methods(const TomlSource& source, const MethodRegistry& registry) {
  std::vector<ComponentSpec> specs;
  std::set<std::string> labels;
  for (const toml::table* entry : entries_of(source, "method")) {
    const Component<SolveMethod>& component = named_component(*entry, "method", registry);
    check_keys(*entry, "method", component, {"name", "label"});
    ComponentSpec spec{component.name, component.name, {}};
    for (const auto& [key, node] : *entry) {
      const std::string name(key.str());
      if (name == "name") continue;
      if (name == "label") {
        spec.label = read_text(node, "method.label");
        continue;
      }
      spec.parameters[name] = read_parameter(node, "method." + name);
      check_value(node, "method", component, name, spec.parameters[name]);
    }
    if (spec.label.empty() || !labels.insert(spec.label).second) {
      throw InvalidParameterError(place_of(*entry) + ": method label '" + spec.label +
                                  (spec.label.empty() ? "' is empty" : "' appears twice; set another label"));
    }
    specs.push_back(std::move(spec));
  }
  return specs;
}

}  // namespace raygauge::cli
