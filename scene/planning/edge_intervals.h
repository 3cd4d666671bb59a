// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "scene/planning/edge_bodies.h"

namespace raygauge {

/// From one moment of an EdgeStage to a later one; of a configuration both are the same.
struct EdgeInterval {
  int first = 0, last = 0;
  int middle = -1, left = -1, right = -1;  ///< a moment and two intervals; -1: not made yet
};

/// The pieces of an edge, and their halves as far as they are asked for.
class EdgeIntervals {
 public:
  explicit EdgeIntervals(EdgeStage& stage) : stage_(stage) {}

  void clear() noexcept { intervals_.clear(); }
  int size() const noexcept { return static_cast<int>(intervals_.size()); }
  const EdgeInterval& operator[](int i) const { return intervals_[static_cast<std::size_t>(i)]; }

  int add(int first, int last);

  /// From a time to a later one. Where the motion of an obstacle breaks an interval ends: bounds hold within
  /// pieces.
  void cut_at_breaks(const std::vector<EdgeBody>& bodies, double from, double to);

  /// The moment in the middle of interval i.
  int middle_of(int i);
  int half_of(int i, bool is_left);

 private:
  EdgeStage& stage_;
  std::vector<EdgeInterval> intervals_;
};

}  // namespace raygauge
