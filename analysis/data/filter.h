// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "raygauge/sweep/record.h"

namespace raygauge {

/// A condition on records, as in "n>=5 && method!=glpk_primal":
///
///     any        = all { "||" all }
///     all        = one { "&&" one }
///     one        = "!" one | "(" any ")" | COLUMN | COLUMN compare VALUE
///     compare    = "==" | "!=" | "<" | "<=" | ">" | ">="
///     VALUE      = number | inf | nan | true | false | word | 'text' | "text" | COLUMN
///
/// COLUMN is any of analysis_columns(); alone it must be one of truths ("!agrees"). Texts compare byte by
/// byte; after a text column a bare word is a text, after a number it is another column ("error > gap").
/// Numbers compare as IEEE 754 has it: everything but != is false for a NaN.
class Filter {
 public:
  /// Passes every record.
  Filter() = default;

  /// Throws InvalidParameterError, which names the expression and the place in it, for a syntax error or
  /// types that do not compare; UnknownNameError, which lists the known columns, for an unknown one.
  explicit Filter(const std::string& expression);

  bool operator()(const Record& record) const { return !passes_ || passes_(record); }

  /// The source of the condition; empty for the one that passes everything.
  const std::string& expression() const { return expression_; }

 private:
  std::string expression_;
  std::function<bool(const Record&)> passes_;
};

/// The records that pass, in their order.
std::vector<Record> filtered(const std::vector<Record>& records, const Filter& filter);

}  // namespace raygauge
