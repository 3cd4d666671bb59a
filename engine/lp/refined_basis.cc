// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/refined_basis.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/double_double.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

// Each step takes the error to ‖I - R B‖ of itself, which rarely exceeds 1e-6.
constexpr int kSteps = 3;

// How negative a weight that is zero may come out.
constexpr double kNegative = 1e-9;

double* cleared(AlignedBuffer<double>& buffer, int P) {
  buffer.reserve(static_cast<std::size_t>(P));
  std::fill_n(buffer.data(), P, 0.0);
  return buffer.data();
}

// An upper bound on a sum of m terms in double-double.
double rounded_up(const DoubleDouble& sum, int m) {
  return sum.rounded() * (1 + 4 * kUnitRoundoff) + m * 0x1p-99 * std::fabs(sum.high);
}

}  // namespace

void RefinedBasis::refine_duals(Basis& basis, const Kernels& kernels) {
  double* y_low = cleared(y_low_, basis.view().P);
  for (int step = 0; step < kSteps; ++step) kernels.duals_twofold(&basis.view(), y_low);
}

void RefinedBasis::refine_solution(Basis& basis, const Kernels& kernels) {
  double* x_low = cleared(x_low_, basis.view().P);
  for (int step = 0; step < kSteps; ++step) {
    kernels.refine_twofold(&basis.view(), basis.right_hand_side(), x_low, true);
  }
}

double RefinedBasis::upper(Basis& basis, const Kernels& kernels) {
  refine_solution(basis, kernels);
  const double share = basis.residual_share();
  if (!(share < 0.5)) return kInfinity;
  BasisView& view = basis.view();
  const double residual = kernels.refine_twofold(&view, basis.right_hand_side(), x_low_.data(), false);
  if (!std::isfinite(residual)) return kInfinity;
  const double error = 1.02 * residual / (1.0 - share);
  DoubleDouble sum;
  for (int i = 0; i < view.m; ++i) {
    if (is_artificial(view.id[i]) || !(view.x()[i] > 2 * error)) return kInfinity;  // x_low is u x at most
    if (is_from_Q(view.id[i])) sum = sum + DoubleDouble{view.x()[i], x_low_[static_cast<std::size_t>(i)]};
  }
  view.objective = sum.rounded();
  return (rounded_up(sum, view.m) + view.m * error) * (1 + 4 * kUnitRoundoff);
}

double RefinedBasis::upper_with_residual(Basis& basis, const Kernels& kernels, double gauge_bound) {
  BasisView& view = basis.view();
  DoubleDouble alpha;
  DoubleDouble beta;
  for (int i = 0; i < view.m; ++i) {
    double& x = view.x()[i];
    double& x_low = x_low_[static_cast<std::size_t>(i)];
    const bool artificial = is_artificial(view.id[i]);
    if (!(x >= -kNegative) || (artificial && !(x <= kNegative))) return kInfinity;
    if (artificial || x <= 0) x = x_low = 0;
    DoubleDouble& sum = is_from_Q(view.id[i]) ? beta : alpha;
    sum = sum + DoubleDouble{x, x_low};
  }
  if (!(alpha.rounded() > 0.5)) return kInfinity;
  const double residual = kernels.residual_twofold(&view, basis.right_hand_side(), x_low_.data());
  if (!std::isfinite(residual)) return kInfinity;
  view.objective = beta.rounded();
  const double alpha_down = alpha.rounded() * (1 - 4 * kUnitRoundoff) - view.m * 0x1p-99;
  return (rounded_up(beta, view.m) + gauge_bound * residual) / alpha_down * (1 + 8 * kUnitRoundoff);
}

}  // namespace raygauge
