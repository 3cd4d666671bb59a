// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/planning/edge_intervals.h"

#include <algorithm>

namespace raygauge {

int EdgeIntervals::add(int first, int last) {
  intervals_.push_back({first, last});
  return size() - 1;
}

void EdgeIntervals::cut_at_breaks(const std::vector<EdgeBody>& bodies, double from, double to) {
  int first = stage_.add(from);
  for (double t = from; t < to;) {
    double end = to;
    for (const EdgeBody& body : bodies) {
      if (!body.stands) end = std::min(end, body.body.motion->next_break(t));
    }
    const int last = stage_.add(end);
    add(first, last);
    first = last;
    t = end;
  }
}

int EdgeIntervals::middle_of(int i) {
  EdgeInterval& over = intervals_[static_cast<std::size_t>(i)];
  if (over.first == over.last) over.middle = over.first;
  if (over.middle < 0) {
    const double from = stage_.time(over.first), to = stage_.time(over.last);
    over.middle = stage_.add(from + (to - from) / 2);
  }
  return over.middle;
}

int EdgeIntervals::half_of(int i, bool is_left) {
  const int middle = middle_of(i);
  const EdgeInterval over = (*this)[i];
  int half = is_left ? over.left : over.right;
  if (half >= 0) return half;
  half = is_left ? add(over.first, middle) : add(middle, over.last);
  EdgeInterval& whole = intervals_[static_cast<std::size_t>(i)];
  (is_left ? whole.left : whole.right) = half;
  return half;
}

}  // namespace raygauge
