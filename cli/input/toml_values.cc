// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/toml_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "cli/input/toml_refusal.h"
#include "raygauge/exceptions.h"
#include "results/text/words.h"

namespace raygauge::cli {
namespace {

/// More values than any sweep has use for; a slip in `step` or `factor` ends here, not in memory.
constexpr double kMaxRangeValues = 1e6;

/// How far, in steps, `to` may lie from the last value and still be met.
constexpr double kStepRounding = 1e-9;

constexpr Range kAnyReal{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

std::string text_of(const toml::node& node) {
  std::ostringstream text;
  if (node.is_table()) return "a table";
  if (node.is_array()) return "a list";
  node.visit([&](const auto& value) {
    if constexpr (toml::is_value<decltype(value)>) text << value;
  });
  return text.str();
}

[[noreturn]] void reject(const toml::node& node, const std::string& key, const std::string& expected) {
  throw InvalidParameterError(place_of(node) + ": " + key + " must be " + expected + ", got " +
                              text_of(node));
}

std::string to_text(double value) { return to_string(ParameterValue(value)); }

void check_range(const toml::node& node, const std::string& key, double value, const Range& range) {
  const bool inside = range.open ? value > range.minimum && value < range.maximum
                                 : value >= range.minimum && value <= range.maximum;
  if (inside) return;
  throw InvalidParameterError(place_of(node) + ": " + key + " must lie in " + (range.open ? "(" : "[") +
                              to_text(range.minimum) + ", " + to_text(range.maximum) +
                              (range.open ? ")" : "]") + ", got " + to_text(value));
}

/// The values of {from, to, step} or {from, to, factor}; their number is worked out first, so that no
/// rounding errors add up.
std::vector<double> range_values(const toml::table& table, const std::string& key, const Range& range) {
  reject_unknown_keys(table, "key of the range " + key, {"from", "to", "step", "factor"});
  const toml::node* from = table.get("from");
  const toml::node* to = table.get("to");
  const toml::node* step = table.get("step");
  const toml::node* factor = table.get("factor");
  if (from == nullptr || to == nullptr || (step != nullptr && factor != nullptr)) {
    throw InvalidParameterError(place_of(table) + ": " + key +
                                " must be a value, a list, {from, to, step} or {from, to, factor}");
  }
  constexpr Range kAny{-1e300, 1e300};
  const double first = read_real(*from, key + ".from", range);
  const double last = read_real(*to, key + ".to", range);
  const double increment = step == nullptr ? 1 : read_real(*step, key + ".step", kAny);
  const double ratio = factor == nullptr ? 1 : read_real(*factor, key + ".factor", {0, 1e300, true});
  const double steps =
      factor == nullptr ? (last - first) / increment : std::log(last / first) / std::log(ratio);
  if (!(steps >= 0 && steps < kMaxRangeValues)) {
    throw InvalidParameterError(place_of(table) + ": " + key + " does not lead from " + to_text(first) +
                                " to " + to_text(last));
  }
  std::vector<double> values;
  for (int i = 0; i <= std::floor(steps + kStepRounding); ++i) {
    const double value = factor == nullptr ? first + i * increment : first * std::pow(ratio, i);
    // The last one may miss `to` by rounding; it was meant.
    const bool meets_end = std::abs(i - steps) <= kStepRounding;
    values.push_back(meets_end ? last : value);
  }
  return values;
}

/// Whether every number of a range table is an integer, so that its values are.
bool is_integer_range(const toml::table& table) {
  return std::all_of(table.begin(), table.end(), [](const auto& entry) { return entry.second.is_integer(); });
}

template <class T, class ReadOne, class FromRange>
std::vector<T> read_list(const toml::node& node, const std::string& key, const ReadOne& read_one,
                         const FromRange& from_range) {
  if (const toml::table* table = node.as_table()) return from_range(*table);
  std::vector<T> values;
  if (const toml::array* array = node.as_array()) {
    for (const toml::node& element : *array) values.push_back(read_one(element));
    if (values.empty()) reject(node, key, "a nonempty list");
    return values;
  }
  values.push_back(read_one(node));
  return values;
}

}  // namespace

const toml::table& read_table(const toml::node& node, const std::string& key) {
  if (const toml::table* table = node.as_table()) return *table;
  refuse(node, key + " must be a table");
}

bool read_boolean(const toml::node& node, const std::string& key) {
  if (!node.is_boolean()) reject(node, key, "true or false");
  return *node.value<bool>();
}

std::string read_text(const toml::node& node, const std::string& key) {
  if (!node.is_string()) reject(node, key, "a string");
  return *node.value<std::string>();
}

std::int64_t read_integer(const toml::node& node, const std::string& key, const Range& range) {
  if (!node.is_integer()) reject(node, key, "an integer");
  const std::int64_t value = *node.value<std::int64_t>();
  check_range(node, key, static_cast<double>(value), range);
  return value;
}

double read_real(const toml::node& node, const std::string& key, const Range& range) {
  if (!node.is_number()) reject(node, key, "a number");
  // toml++ converts no integer that a double cannot hold exactly.
  const double value =
      node.is_integer() ? static_cast<double>(*node.value<std::int64_t>()) : *node.value<double>();
  check_range(node, key, value, range);
  return value;
}

std::vector<std::int64_t> read_integers(const toml::node& node, const std::string& key, const Range& range) {
  return read_list<std::int64_t>(
      node, key, [&](const toml::node& element) { return read_integer(element, key, range); },
      [&](const toml::table& table) {
        std::vector<std::int64_t> values;
        for (const double value : range_values(table, key, range)) values.push_back(std::llround(value));
        return values;
      });
}

std::vector<double> read_reals(const toml::node& node, const std::string& key, const Range& range) {
  return read_list<double>(
      node, key, [&](const toml::node& element) { return read_real(element, key, range); },
      [&](const toml::table& table) { return range_values(table, key, range); });
}

double read_number(const toml::node& node, const std::string& key) {
  if (node.is_floating_point() && std::isnan(*node.value<double>())) reject(node, key, "a number");
  return read_real(node, key, kAnyReal);
}

Eigen::VectorXd read_vector(const toml::node& node, const std::string& key) {
  const toml::array* list = node.as_array();
  if (list == nullptr || list->empty()) reject(node, key, "a nonempty list of numbers");
  Eigen::VectorXd vector(static_cast<Eigen::Index>(list->size()));
  for (Eigen::Index k = 0; k < vector.size(); ++k) {
    const toml::node& element = (*list)[static_cast<std::size_t>(k)];
    if (element.is_floating_point() && !std::isfinite(*element.value<double>()))
      reject(element, key, "made of finite numbers");
    vector[k] = read_number(element, key);
  }
  return vector;
}

Eigen::MatrixXd read_matrix(const toml::node& node, const std::string& key) {
  const toml::array* list = node.as_array();
  if (list == nullptr || list->empty()) reject(node, key, "a nonempty list of rows");
  std::vector<Eigen::VectorXd> rows;
  for (const toml::node& element : *list) {
    rows.push_back(read_vector(element, "a row of " + key));
    if (rows.back().size() != rows.front().size()) {
      throw InvalidParameterError(place_of(element) + ": a row of " + key + " has " +
                                  counted(rows.back().size(), "number") + ", the first one has " +
                                  std::to_string(rows.front().size()));
    }
  }
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(rows.size()), rows.front().size());
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) matrix.row(i) = rows[static_cast<std::size_t>(i)];
  return matrix;
}

ParameterValue read_parameter(const toml::node& node, const std::string& key) {
  if (node.is_boolean()) return *node.value<bool>();
  if (node.is_integer()) return *node.value<std::int64_t>();
  if (node.is_floating_point()) return *node.value<double>();
  if (node.is_string()) return *node.value<std::string>();
  reject(node, key, "a number, a string, true or false");
}

std::vector<ParameterValue> read_parameters(const toml::node& node, const std::string& key) {
  return read_list<ParameterValue>(
      node, key, [&](const toml::node& element) { return read_parameter(element, key); },
      [&](const toml::table& table) {
        std::vector<ParameterValue> values;
        const bool integers = is_integer_range(table);
        // Beyond 2^53 the values of a range would not be the integers that were written.
        constexpr Range kExactIntegers{-0x1p53, 0x1p53}, kReals{-1e300, 1e300};
        for (const double value : range_values(table, key, integers ? kExactIntegers : kReals)) {
          if (integers) {
            values.emplace_back(static_cast<std::int64_t>(std::llround(value)));
          } else {
            values.emplace_back(value);
          }
        }
        return values;
      });
}

void reject_unknown_keys(const toml::table& table, const std::string& kind,
                         const std::vector<std::string>& known) {
  for (const auto& [key, value] : table) {
    const std::string name(key.str());
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      throw UnknownNameError(kind, name, known, place_of(key, value));
    }
  }
}

}  // namespace raygauge::cli
