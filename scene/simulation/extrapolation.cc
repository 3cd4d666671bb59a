// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/extrapolation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/numerics/fused.h"

namespace raygauge {

Extrapolation::Extrapolation(Eigen::Index size)
    : changes_(static_cast<std::size_t>(size)), values_(size, kMemory), f_(size), g_(size) {}

// The change of f at the place of the oldest one, and its products with all.
RAYGAUGE_VECTORS void Extrapolation::learn(int at, const Eigen::VectorXd& f) {
  using Choice [[gnu::vector_size(64), gnu::aligned(64)]] = std::int64_t;
  const Choice lane{0, 1, 2, 3, 4, 5, 6, 7};
  const Choice is_new = lane == at;
  Eight by_f = {}, by_new = {};
  const double *now = f.data(), *before = f_.data();
  for (Row& row : changes_) {
    const double change = *now - *before++;
    row.of = is_new ? Eight{} + change : row.of;
    by_new += row.of * change;
    by_f += row.of * *now++;
  }
  by_f_ = by_f;
  products_[at] = by_new;
  for (int k = 0; k < kMemory; ++k) products_[k][at] = by_new[k];
}

// Cholesky's factors L D Lᵀ; of what depends on others but for rounding nothing.
Extrapolation::Few Extrapolation::shares(int known) const {
  constexpr double kRounding = 1e-13;
  double L[kMemory][kMemory];
  Few d{}, x{};
  for (int i = 0; i < known; ++i) {
    double pivot = products_[i][i] * (1 + kRounding), right = by_f_[i];
    for (int j = 0; j < i; ++j) {
      double entry = products_[i][j];
      for (int k = 0; k < j; ++k) entry -= L[i][k] * L[j][k] * d[k];
      L[i][j] = d[j] > 0 ? entry / d[j] : 0;
      pivot -= L[i][j] * L[i][j] * d[j];
      right -= L[i][j] * x[j];
    }
    d[i] = pivot > kRounding / 2 * products_[i][i] ? pivot : 0;
    x[i] = right;
  }
  for (int i = known; i-- > 0;) {
    x[i] = d[i] > 0 ? x[i] / d[i] : 0;
    for (int k = i + 1; k < known; ++k) x[i] -= d[i] > 0 ? L[k][i] * x[k] : 0;
  }
  return x;
}

void Extrapolation::next(const Eigen::VectorXd& f, const Eigen::VectorXd& g, Eigen::VectorXd& here) {
  if (count_ > 0) {
    const int at = (count_ - 1) % kMemory;
    values_.col(at) = g - g_;
    learn(at, f);
  }
  f_ = f;
  g_ = g;
  here = g;
  const int known = std::min(count_++, kMemory);
  if (known == 0) return;
  const Few all = shares(known);
  if (!std::all_of(all.begin(), all.end(), [](double share) { return std::isfinite(share); })) return;
  for (int k = 0; k < known; ++k) here.noalias() -= all[static_cast<std::size_t>(k)] * values_.col(k);
}

}  // namespace raygauge
