// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/sweep/sweep.h"
#include "engine/sweep/sweep_plan.h"

namespace raygauge {

/// Measures by how much `threads` threads that solve at once slow each other down: the first repetitions of a
/// cell of median cost among `cells` are solved by one thread alone, then by all threads together: 3 to 15
/// instances, as many as keep within a hundredth of the time of sweeping over `cells`. With
/// t_serial(r) and t_j(r) the times of instance r alone and on thread j, a method's inflation is
///
///     median over r and j of  t_j(r) / t_serial(r).
///
/// Thread j runs on cpus[j] if `cpus` is not empty. Empty if SweepHooks::stop cut it short. Throws what a
/// generator or a method throws.
Calibration calibrate(const SweepPlan& plan, const std::vector<Cell>& cells, int threads,
                      const std::vector<int>& cpus, const SweepHooks& hooks = {});

/// The entry of a method whose solve of instance r took serial[r] = t_serial(r) seconds alone and
/// parallel[j][r] = t_j(r) on thread j; parallel[j] is empty for a thread that the runtime did not grant.
Calibration::Entry calibration_entry(const std::string& method, std::span<const double> serial,
                                     const std::vector<std::span<const double>>& parallel);

}  // namespace raygauge
