// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/statistics/statistics.h"
#include "analysis/studies/table3/cell_ratio.h"

namespace raygauge {

/// Which method wins a cell of the grid.
struct CellWinner {
  CellKey cell;
  std::string method;     ///< smallest median time
  std::string runner_up;  ///< second smallest; "" if no other method has a finite median
  double seconds = 0;     ///< the winner's median
  Ratio lead;  ///< runner_up / method: paired_ratio() over common instances, without any ratio_of_medians();
               ///< NaN without a runner-up
  bool decided = false;  ///< the 95 % interval of `lead` lies above 1
};

/// The winner of each cell, by generator, n, N, tolerance; cells in which no method has a finite median (half
/// of its solves or more without an answer) are left out.
std::vector<CellWinner> cell_winners(const std::vector<Record>& records);

}  // namespace raygauge
