// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/sweep/sweep_plan.h"
#include "raygauge/sweep.h"

namespace raygauge {

/// The first repetitions of a cell, solved by one thread while no other does anything.
struct LoneSolves {
  Cell cell;
  std::vector<Record> records;  ///< by repetition, then method; empty if SweepHooks::stop cut it short
};

/// Solves alone the first repetitions of a cell of median cost among `cells`, which a sweep by `threads`
/// threads is to take: 3 to 15 of them, as many as keep within a two-hundredth of the time of that sweep. The
/// thread runs on cpus[0] if `cpus` is not empty. Throws what a generator or a method throws.
LoneSolves solve_alone(const SweepPlan& plan, const std::vector<Cell>& cells, int threads,
                       const std::vector<int>& cpus, const SweepHooks& hooks = {});

/// By how much threads that solve at once slow each other down. With t_alone(r) the times of a method in
/// `alone` and t(r) those of the same instances in the sweep's own `records` of that cell, which its other
/// threads were running beside, the method's slowdown is
///
///     median over r of  t(r) / t_alone(r).
///
/// Empty if `alone` is, or if the sweep was granted one thread only.
Calibration calibration_of(const LoneSolves& alone, const std::vector<Record>& records);

}  // namespace raygauge
