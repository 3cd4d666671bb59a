// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sweep/registry.h"

#include <algorithm>
#include <array>

#include "engine/numerics/number_text.h"
#include "engine/sweep/parameter_text.h"
#include "raygauge/sweep/instance.h"

namespace raygauge {
namespace {

const char* type_name(const ParameterValue& value) {
  constexpr std::array<const char*, 4> kNames = {"true or false", "an integer", "a number", "a string"};
  return kNames[value.index()];
}

void check_range(const std::string& place, const ParameterInfo& info, double value) {
  if (value >= info.minimum && value <= info.maximum) return;
  throw InvalidParameterError(place + " must lie in [" + to_string(ParameterValue(info.minimum)) + ", " +
                              to_string(ParameterValue(info.maximum)) + "], got " +
                              to_string(ParameterValue(value)));
}

ParameterValue checked(const std::string& owner, const ParameterInfo& info, ParameterValue value) {
  const std::string place = owner + ": parameter '" + info.name + "'";
  if (std::holds_alternative<double>(info.default_value) && std::holds_alternative<std::int64_t>(value)) {
    value = static_cast<double>(std::get<std::int64_t>(value));
  }
  if (value.index() != info.default_value.index()) {
    throw InvalidParameterError(place + " must be " + type_name(info.default_value) + ", got " +
                                to_string(value));
  }
  if (const auto* integer = std::get_if<std::int64_t>(&value))
    check_range(place, info, static_cast<double>(*integer));
  if (const auto* real = std::get_if<double>(&value)) check_range(place, info, *real);
  if (const auto* text = std::get_if<std::string>(&value); text != nullptr && !info.choices.empty()) {
    if (std::find(info.choices.begin(), info.choices.end(), *text) == info.choices.end()) {
      throw UnknownNameError("value", *text, info.choices, place);
    }
  }
  return value;
}

template <class T>
T get(const Parameters& parameters, const std::string& name) {
  return std::get<T>(parameters.at(name));
}

constexpr std::array<std::string_view, 3> kRoleNames = {"engine", "baseline", "oracle"};
constexpr std::array<std::string_view, 4> kQuantityNames = {"distance", "depth", "separated", "growth"};

/// The value of an enumeration by its name.
template <class Enum, std::size_t N>
Enum value_of(const char* kind, std::string_view name, const std::array<std::string_view, N>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw UnknownNameError(kind, std::string(name), {names.begin(), names.end()});
  return static_cast<Enum>(found - names.begin());
}

}  // namespace

std::string_view to_string(Role role) noexcept { return kRoleNames[static_cast<std::size_t>(role)]; }

Role role_from_string(std::string_view name) { return value_of<Role>("role", name, kRoleNames); }

std::string_view to_string(Quantity quantity) noexcept {
  return kQuantityNames[static_cast<std::size_t>(quantity)];
}

Quantity quantity_from_string(std::string_view name) {
  return value_of<Quantity>("quantity", name, kQuantityNames);
}

Parameters complete(const std::string& owner, const std::vector<ParameterInfo>& declared,
                    const Parameters& given) {
  Parameters result;
  std::vector<std::string> names;
  bool any = false;
  for (const ParameterInfo& info : declared) {
    any = any || info.name == kAnyParameter;
    if (info.name == kAnyParameter) continue;
    names.push_back(info.name);
    const auto found = given.find(info.name);
    result[info.name] = found == given.end() ? info.default_value : checked(owner, info, found->second);
  }
  for (const auto& entry : given) {
    if (!any && result.count(entry.first) == 0)
      throw UnknownNameError("parameter", entry.first, names, owner);
    result.insert(entry);
  }
  return result;
}

double real_parameter(const Parameters& parameters, const std::string& name) {
  return get<double>(parameters, name);
}

std::int64_t integer_parameter(const Parameters& parameters, const std::string& name) {
  return get<std::int64_t>(parameters, name);
}

bool boolean_parameter(const Parameters& parameters, const std::string& name) {
  return get<bool>(parameters, name);
}

std::string string_parameter(const Parameters& parameters, const std::string& name) {
  return get<std::string>(parameters, name);
}

std::string to_string(const ParameterValue& value) {
  if (const auto* boolean = std::get_if<bool>(&value)) return *boolean ? "true" : "false";
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return std::to_string(*integer);
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return shortest_text(std::get<double>(value));
}

std::string to_string(const Parameters& parameters) {
  std::string result;
  for (const auto& [name, value] : parameters) {
    result += (result.empty() ? "" : " ") + name + "=" + quoted_where_needed(to_string(value));
  }
  return result;
}

}  // namespace raygauge
