// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <string>

#include "raygauge/sweep/record.h"

namespace raygauge {

/// What makes two records comparable: the cell of a grid, by its values, so that files can be merged.
struct CellKey {
  std::string generator;
  std::string generator_parameters;
  int n = 0;
  int N = 0;
  double tolerance = 0;
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy sees a 0 in what the compiler generates
  friend auto operator<=>(const CellKey&, const CellKey&) = default;
};

CellKey cell_key(const Record& record);

/// "example2 (separation=1.5)": the generator with its parameters, if it has any.
std::string problem_name(const CellKey& cell);

}  // namespace raygauge
