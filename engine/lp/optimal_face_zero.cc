// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// The origin as a combination of independent points.
#include <algorithm>
#include <cmath>

#include "engine/lp/affords.h"
#include "engine/lp/optimal_face.h"

namespace raygauge {
namespace {

constexpr double kShareOfPivots = 1.15;  // of the columns looked at for m pivots, where there are more
constexpr double kSecondChoice = 5;      // operations per m³ of choose() and upper(), with m columns
constexpr double kNoWeight = 1e-12;      // relative to the heaviest column

}  // namespace

// Whether there were columns that are no pivots. Their weight goes to the pivots, one column after the other:
// with M_P z = M_j, x_P grows by z for each unit that x_j loses. A pivot whose weight ends first changes
// places with column j.
bool OptimalFace::leave_others_out() {
  if (count() == rank()) return false;
  is_pivot_.assign(ids_.size(), false);
  for (const Pivot& pivot : pivots_) is_pivot_[static_cast<std::size_t>(pivot.column)] = true;
  const std::vector<bool> were_pivots = is_pivot_;
  for (int j = 0; j < count(); ++j) {
    if (!were_pivots[static_cast<std::size_t>(j)]) leave_out(j);
  }
  const double least = kNoWeight * *std::max_element(weights_.begin(), weights_.end());
  keep_heavier_than(least);
  return true;
}

// Of column j, which is no pivot.
void OptimalFace::leave_out(int j) {
  const BasisView& view = basis_.view();
  const auto r = static_cast<std::size_t>(rank());
  std::vector<double> z(r);
  for (std::size_t k = 0; k < r; ++k) {
    const double entry = column(j)[pivots_[k].row];
    const double* of_R = view.R + static_cast<std::ptrdiff_t>(k) * view.P;
    for (std::size_t i = 0; i < r; ++i) z[i] += of_R[i] * entry;
  }
  double step = weight(j);
  std::size_t first = r;  // to end
  for (std::size_t i = 0; i < r; ++i) {
    if (!(z[i] < 0) || !(weight(pivots_[i].column) < -z[i] * step)) continue;
    step = weight(pivots_[i].column) / -z[i];
    first = i;
  }
  for (std::size_t i = 0; i < r; ++i) weights_[static_cast<std::size_t>(pivots_[i].column)] += step * z[i];
  weights_[static_cast<std::size_t>(j)] -= step;
  if (first == r) return;
  weights_[static_cast<std::size_t>(pivots_[first].column)] = 0;
  pivots_[first].column = j;
  for (std::size_t k = 0; k < r; ++k) {
    double* of_R = view.R + static_cast<std::ptrdiff_t>(k) * view.P;
    const double share = of_R[first] / z[first];
    for (std::size_t i = 0; i < r; ++i) of_R[i] -= z[i] * share;
    of_R[first] = share;
  }
}

void OptimalFace::keep_heavier_than(double least) {
  std::vector<int> place(ids_.size(), -1);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    if (!(weights_[i] > least)) continue;
    std::copy_n(column(static_cast<int>(i)), m_, columns_.data() + kept * static_cast<std::size_t>(m_));
    costs_[kept] = costs_[i];
    weights_[kept] = weights_[i];
    ids_[kept] = ids_[i];
    place[i] = static_cast<int>(kept++);
  }
  columns_.resize(kept * static_cast<std::size_t>(m_));
  costs_.resize(kept);
  weights_.resize(kept);
  ids_.resize(kept);
  for (Pivot& pivot : pivots_) pivot.column = place[static_cast<std::size_t>(pivot.column)];
}

// Of the pivots at hand, which are all columns that are left. False where one of them has lost its weight.
bool OptimalFace::is_zero_as_chosen(const Stopwatch& stopwatch) {
  if (std::any_of(pivots_.begin(), pivots_.end(), [](const Pivot& pivot) { return pivot.column < 0; }))
    return false;
  take_pivots();
  return upper(stopwatch) == 0;
}

bool OptimalFace::is_independent_zero(const Stopwatch& stopwatch) {
  const auto some = static_cast<std::ptrdiff_t>(kShareOfPivots * m_);
  bool proven = count() > some && choose(stopwatch, some) && upper(stopwatch) == 0;
  for (;;) {
    if (!proven && (!choose(stopwatch) || upper(stopwatch) != 0)) return false;
    if (!affords(stopwatch, kSecondChoice * cube(m_)) || !leave_others_out()) return true;
    proven = is_zero_as_chosen(stopwatch);
  }
}

}  // namespace raygauge
