// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/data/cell_ratio.h"
#include "analysis/data/instances.h"
#include "analysis/statistics/statistics.h"

namespace raygauge {

/// Which method wins a cell of the grid.
struct CellWinner {
  CellKey cell;
  std::string method;  ///< of the two methods with the smallest center_of() their times, the one that leads
  std::string runner_up;  ///< the other; "" if no other method has a finite median
  double seconds = 0;     ///< of the winner
  Ratio lead;  ///< runner_up / method: paired_ratio() over common instances, of a Pool their geometric mean;
               ///< without any ratio_of_medians(); NaN without a runner-up
  bool decided = false;  ///< the 95 % interval of `lead` lies above 1
};

/// The winner of each cell, by generator, n, N, tolerance; cells in which no method has a finite median (half
/// of its solves or more without an answer) are left out.
std::vector<CellWinner> cell_winners(const std::map<CellKey, std::vector<MethodInstances>>& cells);
std::vector<CellWinner> cell_winners(const std::vector<Record>& records);

}  // namespace raygauge
