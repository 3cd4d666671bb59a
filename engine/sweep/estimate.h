// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "raygauge/sweep/experiment.h"
#include "raygauge/sweep/instance.h"
#include "raygauge/sweep/method.h"

namespace raygauge {

/// What a sweep is about to do, and roughly how long it will take.
struct SweepEstimate {
  std::size_t cells = 0;
  std::uint64_t instances = 0;  ///< cells × repetitions
  std::uint64_t records = 0;    ///< instances × methods
  int threads = 1;

  double seconds = 0;                ///< whole sweep, as if the threads did not slow each other down
  std::vector<double> cell_seconds;  ///< of each cell of the grid, on one thread

  Cell largest;  ///< with the most coordinates
  double largest_bytes =
      0;  ///< what one thread holds while it runs that cell: instances and the methods' models
  double probing_seconds = 0;  ///< spent on finding out
  std::size_t probed_cells =
      0;  ///< cells that were probed; the others lie between or beyond them (smaller ones count too)
};

/// Solves one instance of a few cells, from cheap to expensive ones, with every method, and takes the time of
/// a repetition to be a power of n·N between and beyond them. A cell is probed only if the one before it lets
/// expect that it ends within `budget_seconds` of the call, a single solve being limited to that as well;
/// where all cells are large, smaller ones of the same generator come first. Stores nothing. Throws what
/// run_sweep throws.
/// `heap_bytes`, if given, is asked for the bytes that the process holds: what the methods make of the last
/// probe, in proportion to n·N, is their part of largest_bytes; without it that is of the instances alone.
SweepEstimate estimate_sweep(const Experiment& experiment, const GeneratorRegistry& generators,
                             const MethodRegistry& methods, double budget_seconds = 1.2,
                             const std::function<double()>& heap_bytes = {});

}  // namespace raygauge
