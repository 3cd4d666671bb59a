// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine/exceptions.h"

namespace raygauge {

/// The value of a generator's or method's parameter.
using ParameterValue = std::variant<bool, std::int64_t, double, std::string>;

/// Parameters by name. A component receives every parameter it declares: defaults are filled in by
/// `complete`.
using Parameters = std::map<std::string, ParameterValue>;

/// Declares one parameter: the type of `default_value` is the parameter's type (an integer is accepted for a
/// real).
struct ParameterInfo {
  std::string name;
  ParameterValue default_value;
  double minimum = -std::numeric_limits<double>::infinity();  ///< inclusive; numbers only
  double maximum = std::numeric_limits<double>::infinity();   ///< inclusive; numbers only
  std::string description;
  std::vector<std::string> choices;  ///< strings only; empty: any
};

/// `given` with every missing parameter set to its default. Throws UnknownNameError for a parameter that is
/// not declared and InvalidParameterError for a wrong type or range; `owner` names the component in the
/// message.
Parameters complete(const std::string& owner, const std::vector<ParameterInfo>& declared,
                    const Parameters& given);

double real_parameter(const Parameters& parameters, const std::string& name);
std::int64_t integer_parameter(const Parameters& parameters, const std::string& name);
bool boolean_parameter(const Parameters& parameters, const std::string& name);
std::string string_parameter(const Parameters& parameters, const std::string& name);

/// "separation=1.5 kind=plain": parameters in name order, numbers in shortest round-trip form; "" for none.
std::string to_string(const Parameters& parameters);
std::string to_string(const ParameterValue& value);

/// What a registry knows of one component: its name, one line of description, its parameters, how to make
/// one, and for a method whether it takes point sets. (Which of the other sets it takes is for its load() to
/// say.)
template <class T>
struct Component {
  std::string name;
  std::string description;
  std::vector<ParameterInfo> parameters;
  std::function<std::unique_ptr<T>(const Parameters&)> make;
  bool point_sets = true;
};

/// Components by name. Rooms add theirs by one function each (register_generators, register_baselines, …); a
/// sweep reaches them through here alone.
template <class T>
class Registry {
 public:
  /// `kind` is the word for a component in messages: "generator", "method".
  explicit Registry(std::string kind) : kind_(std::move(kind)) {}

  /// Throws InvalidParameterError if the name is taken.
  void add(Component<T> component) {
    const std::string name = component.name;
    if (!components_.emplace(name, std::move(component)).second) {
      throw InvalidParameterError(kind_ + " '" + name + "' is registered twice");
    }
  }

  /// Throws UnknownNameError, which lists the known names.
  const Component<T>& find(const std::string& name) const {
    const auto found = components_.find(name);
    if (found == components_.end()) throw UnknownNameError(kind_, name, names());
    return found->second;
  }

  /// A component with its parameters checked and completed. Throws UnknownNameError or InvalidParameterError.
  std::unique_ptr<T> make(const std::string& name, const Parameters& given) const {
    const Component<T>& component = find(name);
    return component.make(complete(kind_ + " '" + name + "'", component.parameters, given));
  }

  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const auto& entry : components_) result.push_back(entry.first);
    return result;
  }

 private:
  std::string kind_;
  std::map<std::string, Component<T>> components_;
};

}  // namespace raygauge
