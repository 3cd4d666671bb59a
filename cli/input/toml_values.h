// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "cli/input/toml_source.h"
#include "raygauge/sweep/registry.h"

namespace raygauge::cli {

/// An interval of numbers; `open` ones exclude their ends.
struct Range {
  double minimum = 0;
  double maximum = 0;
  bool open = false;
};

// Strict readers of TOML values. `key` is the full name for messages ("sweep.n"). They throw
// InvalidParameterError, with file and line, for a value of another type or outside its range.

const toml::table& read_table(const toml::node& node, const std::string& key);
bool read_boolean(const toml::node& node, const std::string& key);
std::string read_text(const toml::node& node, const std::string& key);
std::int64_t read_integer(const toml::node& node, const std::string& key, const Range& range);
double read_real(const toml::node& node, const std::string& key, const Range& range);

/// One value, a list of them, or a range: {from = 3, to = 10, step = 1} (step 1 if left out) or
/// {from = 1e-2, to = 1e-10, factor = 0.1}; `to` is included where the steps meet it. Integers rounded.
std::vector<std::int64_t> read_integers(const toml::node& node, const std::string& key, const Range& range);
std::vector<double> read_reals(const toml::node& node, const std::string& key, const Range& range);

/// A number, infinite ones included.
double read_number(const toml::node& node, const std::string& key);

/// A nonempty list of finite numbers, and a list of such lists of one length, the rows of a matrix.
Eigen::VectorXd read_vector(const toml::node& node, const std::string& key);
Eigen::MatrixXd read_matrix(const toml::node& node, const std::string& key);

/// A parameter's value, or the values of a list or a range of them.
ParameterValue read_parameter(const toml::node& node, const std::string& key);
std::vector<ParameterValue> read_parameters(const toml::node& node, const std::string& key);

/// Throws UnknownNameError, with file and line, for the first key of `table` that is not `known`. `kind` is
/// the word for a key in the message: "[sweep] key".
void reject_unknown_keys(const toml::table& table, const std::string& kind,
                         const std::vector<std::string>& known);

}  // namespace raygauge::cli
