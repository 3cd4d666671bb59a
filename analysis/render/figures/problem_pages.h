// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/render/figures/figure.h"

namespace raygauge {

/// Records that may stand in one map over (n, N): of one generator, its parameters and one tolerance.
struct Problem {
  std::string name;  ///< "example2, separation=3, ε = 1e-6", what differs alone; "" where there is one only
  std::vector<Record> records;
};

/// More problems than these are for --where to choose from.
inline constexpr std::size_t kMostProblems = 8;

/// A page for each problem of the records that pass the filter. One that does not have what the figure needs
/// is left out. Throws FigureNeedsError where all are, or where there are more than kMostProblems.
Drawing page_for_each_problem(const std::string& figure, const std::vector<Record>& records,
                              const Filter& filter, const std::function<Drawing(const Problem&)>& draw_one);

}  // namespace raygauge
