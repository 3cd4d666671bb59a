// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "raygauge/scene/scene_run.h"

namespace raygauge {

/// How long the cells of a run still take: one that has not begun, as long as those of its kind took on
/// average; one in flight the rest of that, and once it has taken longer, as long again as it has taken. One
/// thread at a time. Times are seconds since the run began.
class CellClock {
 public:
  /// `cells`: the numbers of the cells to do, in the order in which they are begun.
  CellClock(const ScenePlan& plan, const std::vector<std::uint64_t>& cells, int threads);

  /// Cell cells[i] begins; those before it that did not begin here are done by others.
  void begin(std::size_t i, double now);
  void end(std::size_t i, double now);

  /// 0 while nothing is known.
  double seconds_left(double now) const;

 private:
  struct Kind {
    double seconds = 0;
    std::int64_t done = 0, ahead = 0;
  };
  std::size_t number_of_kind(std::size_t i) const;
  double expected(const Kind& kind) const;

  const ScenePlan& plan_;
  const std::vector<std::uint64_t>& cells_;
  int threads_;
  std::array<Kind, 3> kinds_;
  std::size_t begun_ = 0;                // cells before this one have begun
  std::map<std::size_t, double> since_;  // of the cells in flight
};

}  // namespace raygauge
