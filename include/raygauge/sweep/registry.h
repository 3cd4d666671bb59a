// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "raygauge/exceptions.h"

namespace raygauge {

/// The value of a generator's or method's parameter.
using ParameterValue = std::variant<bool, std::int64_t, double, std::string>;

/// Parameters by name. A component receives every parameter it declares: defaults are filled in by
/// `complete`.
using Parameters = std::map<std::string, ParameterValue>;

/// How a parameter makes the instances of its family harder: the quantity that errors are drawn against.
struct Hardness {
  std::string label;               ///< "1/δ"; empty: the parameter does not measure hardness
  double (*of)(double) = nullptr;  ///< the quantity at a value of the parameter; null: the value itself

  double operator()(double value) const { return of == nullptr ? value : of(value); }
};

/// Who provides a method: decides what tables and figures compare, what they compare with, and what they take
/// the truth from.
enum class Role : std::uint8_t {
  engine,    ///< a method of raygauge
  baseline,  ///< a competitor: a library, or a program of the user's
  oracle,    ///< exact arithmetic: its claims are the truth, its times are not compared
};

/// "engine", "baseline", "oracle": the words of results files.
std::string_view to_string(Role role) noexcept;

/// The inverse of to_string. Throws UnknownNameError.
Role role_from_string(std::string_view name);

/// What a generator promises of the distances that it states.
struct GeneratorPromises {
  bool known_distance = false;   ///< every instance has an exact_distance
  double distance_rounding = 0;  ///< relative error of the stated distance; 0: exact for the doubles
};

/// A declaration of this name accepts every other parameter, of any type, which is kept as given.
inline constexpr const char* kAnyParameter = "*";

/// Declares one parameter: the type of `default_value` is the parameter's type (an integer is accepted for a
/// real).
struct ParameterInfo {
  std::string name;
  ParameterValue default_value;
  double minimum = -std::numeric_limits<double>::infinity();  ///< inclusive; numbers only
  double maximum = std::numeric_limits<double>::infinity();   ///< inclusive; numbers only
  std::string description;
  std::vector<std::string> choices;  ///< strings only; empty: any
  std::string unit = "1";            ///< "1" for a pure number, "s", "B"
  Hardness hardness = {};            ///< of a generator's parameter, where it makes instances harder
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

/// What a registry knows of one component: its name, one line of description, its parameters and how to make
/// one. For a method also whether it takes point sets (which of the other sets it takes is for its load() to
/// say) and whose it is; for a generator what it promises.
template <class T>
struct Component {
  std::string name;
  std::string description;
  std::vector<ParameterInfo> parameters;
  std::function<std::unique_ptr<T>(const Parameters&)> make;
  bool point_sets = true;
  Role role = Role::engine;
  GeneratorPromises promises = {};
  std::vector<std::string> aliases = {};  ///< shorter names that find() takes
};

/// Components by name. Each library registers its components with one function (register_generators,
/// register_baselines, …); a sweep reaches them only through a registry.
template <class T>
class Registry {
 public:
  /// `kind` is the word for a component in messages: "generator", "method".
  explicit Registry(std::string kind) : kind_(std::move(kind)) {}

  /// Throws InvalidParameterError if the name is taken.
  void add(Component<T> component) {
    const std::string name = component.name;
    for (const std::string& alias : component.aliases) aliases_[alias] = name;
    if (!components_.emplace(name, std::move(component)).second) {
      throw InvalidParameterError(kind_ + " '" + name + "' is registered twice");
    }
  }

  /// The component of that name or alias, or nullptr.
  const Component<T>* find_if_known(const std::string& name) const {
    const auto alias = aliases_.find(name);
    const auto found = components_.find(alias == aliases_.end() ? name : alias->second);
    return found == components_.end() ? nullptr : &found->second;
  }

  /// Throws UnknownNameError, which lists the known names.
  const Component<T>& find(const std::string& name) const {
    const Component<T>* component = find_if_known(name);
    if (component == nullptr) throw UnknownNameError(kind_, name, names());
    return *component;
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
  std::map<std::string, std::string> aliases_;  ///< the name that each alias stands for
};

}  // namespace raygauge
