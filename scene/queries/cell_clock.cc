// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/queries/cell_clock.h"

#include <algorithm>

namespace raygauge {

CellClock::CellClock(const ScenePlan& plan, const std::vector<std::uint64_t>& cells, int threads)
    : plan_(plan), cells_(cells), threads_(threads) {
  for (std::size_t i = 0; i < cells.size(); ++i) ++kinds_[number_of_kind(i)].ahead;
}

std::size_t CellClock::number_of_kind(std::size_t i) const {
  return static_cast<std::size_t>(plan_.cells[cells_[i]].kind);
}

void CellClock::begin(std::size_t i, double now) {
  for (; begun_ <= i; ++begun_) --kinds_[number_of_kind(begun_)].ahead;
  since_[i] = now;
}

void CellClock::end(std::size_t i, double now) {
  Kind& kind = kinds_[number_of_kind(i)];
  kind.seconds += now - since_[i];
  ++kind.done;
  since_.erase(i);
}

// Of a kind of which none is done yet, the mean of all.
double CellClock::expected(const Kind& kind) const {
  if (kind.done > 0) return kind.seconds / static_cast<double>(kind.done);
  Kind all;
  for (const Kind& one : kinds_) all.seconds += one.seconds, all.done += one.done;
  return all.done > 0 ? all.seconds / static_cast<double>(all.done) : 0.0;
}

double CellClock::seconds_left(double now) const {
  double work = 0, longest = 0;
  for (const Kind& kind : kinds_) work += static_cast<double>(kind.ahead) * expected(kind);
  for (const auto& [i, since] : since_) {
    const double taken = now - since, mean = expected(kinds_[number_of_kind(i)]);
    const double rest = taken < mean ? mean - taken : taken;
    work += rest;
    longest = std::max(longest, rest);
  }
  return std::max(longest, work / threads_);
}

}  // namespace raygauge
