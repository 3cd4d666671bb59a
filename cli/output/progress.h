// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <string>

#include "raygauge/sweep.h"

namespace raygauge::cli {

/// Shows how far a sweep is: a bar that is redrawn in place on a terminal, elsewhere a plain line for every
/// tenth of the cells.
class ProgressDisplay {
 public:
  /// `resumed_cells` were done before; the display counts them in. `unit`: what is counted.
  ProgressDisplay(std::FILE* stream, std::uint64_t resumed_cells, const char* unit = "cell");
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  void show(const SweepProgress& progress);

  /// Removes the bar, so that other output can follow.
  void clear();

 private:
  void draw_bar(const std::string& text, double fraction);

  std::FILE* stream_;
  bool in_place_;
  std::uint64_t resumed_cells_;
  const char* unit_;
  int tenths_shown_ = 0;
  bool bar_on_screen_ = false;
};

}  // namespace raygauge::cli
