// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What a basic solution is, and what it proves.
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/lp/point_basis.h"
#include "engine/numerics/double_double.h"
#include "engine/numerics/exact_sum.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

constexpr double kNegligibleError = 0.125;  // of an upper bound, relative to the gap that is asked for
constexpr double kArtificialZero = 1e-13;   // weight of artificial columns that is rounding noise

// max_i Σ_k |R_ik| without R's last column: what changes are the first n equations.
double norm_of_changes(const BasisView& view) {
  double norm = 0;
  for (int i = 0; i < view.m; ++i) {
    double row = 0;
    for (int k = 0; k < view.m - 1; ++k)
      row += std::fabs(view.R[static_cast<std::ptrdiff_t>(k) * view.P + i]);
    norm = std::max(norm, row);
  }
  return norm;
}

}  // namespace

void PointBasis::form_column(const ColumnPool& pool, std::int64_t id, double* column) const {
  const int n = view().m - 1;
  std::fill_n(column, view().P, 0.0);
  pool.copy_point(id / 2, column);
  column[n] = is_from_Q(id) ? 0.0 : 1.0;
  for (int k = 0; k < n && is_from_Q(id); ++k) column[k] = -column[k];
}

bool PointBasis::has_artificial_weight() const {
  double weight = 0;
  for (int i = 0; i < view().m; ++i) {
    if (is_artificial(view().id[i])) weight += std::fabs(view().x()[i]);
  }
  return weight > kArtificialZero;
}

double PointBasis::dual_length() const noexcept {
  double sum = 0;
  for (int k = 0; k < view().m - 1; ++k) sum += std::fabs(view().y[k]);
  return sum;
}

void PointBasis::origin_weights(std::vector<PointWeight>& weights) const {
  const BasisView& view = this->view();
  weights.clear();
  for (int i = 0; i < view.m; ++i) {
    if (!is_point_of_A(i) || !(view.x()[i] > left_out_)) continue;
    weights.push_back({static_cast<std::ptrdiff_t>(view.id[i] / 2), view.x()[i]});
  }
}

void PointBasis::contact_point(double* point) const {
  const BasisView& view = this->view();
  const int n = view.m - 1;
  std::fill_n(point, n, 0.0);
  for (int i = 0; i < view.m; ++i) {
    if (!is_point_of_A(i)) continue;
    for (int k = 0; k < n; ++k) point[k] += view.x()[i] * column(i)[k];
  }
}

void PointBasis::points_of_A(WeightedPoints& points) const {
  const BasisView& view = this->view();
  for (int i = 0; i < view.m; ++i) {
    if (!is_point_of_A(i)) continue;
    points.add(column(i), view.x()[i]);
  }
}

double PointBasis::proven_upper(double gap_tolerance) {
  // As accurate as the gap asks for, most basic solutions are from the start; the others are refined.
  double upper = gap_tolerance > 0 ? enclosed_upper(gap_tolerance, false) : kInfinity;
  if (!(upper < kInfinity)) upper = enclosed_upper(gap_tolerance, true);
  return upper < kInfinity ? upper : exact_upper();
}

// Σβ where every weight is proven to be positive; +infinity otherwise, or where the unrefined solution is not
// good enough.
double PointBasis::enclosed_upper(double gap_tolerance, bool refine) {
  BasisView& view = this->view();
  // The enclosure takes n³ operations, and artificial columns with weight leave nothing to prove with it.
  if (has_artificial_weight()) return kInfinity;
  const Enclosure enclosure = enclose(refine);
  if (!enclosure.valid) return kInfinity;
  left_out_ = 0;
  double sum = 0;
  double error = 0;
  for (int i = 0; i < view.m; ++i) {
    if (is_artificial(view.id[i]) || view.x()[i] < enclosure.error) return kInfinity;
    if (!is_from_Q(view.id[i])) continue;
    sum += view.x()[i];
    error += enclosure.error;
  }
  if (!refine && error > kNegligibleError * gap_tolerance * sum) return kInfinity;
  view.objective = sum;
  return (sum + error) * (1 + 2 * (view.m + 2) * kUnitRoundoff);
}

// Degenerate: some basic variables are zero. If leaving them out solves the equations exactly, that is a
// proof too.
double PointBasis::exact_upper() {
  left_out_ = kArtificialZero;
  const BasisView& view = this->view();
  const double* x = view.x();
  double sum = 0;
  for (int i = 0; i < view.m; ++i) {
    if (x[i] <= kArtificialZero) continue;
    if (is_artificial(view.id[i])) return kInfinity;
    if (is_from_Q(view.id[i])) sum += x[i];
  }
  for (int k = 0; k < view.m; ++k) {
    ExactSum row;
    if (k == view.m - 1) row.add(-1.0);
    for (int i = 0; i < view.m; ++i) {
      if (x[i] > kArtificialZero) row.add_product(x[i], column(i)[k]);
    }
    if (!row.is_zero()) return kInfinity;
  }
  return sum * (1 + 2 * (view.m + 1) * kUnitRoundoff);
}

double PointBasis::upper_with_residual(double gauge_bound) const {
  const BasisView& view = this->view();
  const double* x = view.x();
  double alpha = 0;
  double beta = 0;
  for (int i = 0; i < view.m; ++i) {
    if (is_artificial(view.id[i]) || !(x[i] > 0)) continue;
    (is_from_Q(view.id[i]) ? beta : alpha) += x[i];
  }
  if (!(alpha > 0.5)) return kInfinity;
  double residual = 0;
  for (int k = 0; k < view.m - 1; ++k) {
    DoubleDouble sum;
    double magnitude = 0;
    for (int i = 0; i < view.m; ++i) {
      if (is_artificial(view.id[i]) || !(x[i] > 0)) continue;
      const DoubleDouble term = two_product(x[i], column(i)[k]);
      sum = sum + term;
      magnitude += std::fabs(term.high);
    }
    const double lost = view.m * 0x1p-99 * magnitude + kUnderflow;
    const double row = std::fabs(sum.rounded()) + lost;
    if (!(row < kInfinity)) return kInfinity;  // an overflow, of which a maximum might lose sight
    residual = std::max(residual, row);
  }
  const double rounding = 4 * (view.m + 4) * kUnitRoundoff;
  return (beta + gauge_bound * residual) / alpha * (1 + rounding);
}

// With B the basis as computed, B + D that of the points themselves, the weights x of the one and x' of the
// other: x' - x = -B⁻¹ D x',  |D x'|∞ <= e_A Σα' + e_Q Σβ',  ‖B⁻¹‖ <= ‖R‖ / (1 - ‖I - RB‖).
double PointBasis::upper_of_moved_points(double error_A, double error_Q) {
  if (has_artificial_weight()) return kInfinity;
  const Enclosure enclosure = enclose(true);
  if (!enclosure.valid) return kInfinity;
  const BasisView& view = this->view();
  double alpha = 0, beta = 0, least = kInfinity;
  int points_of_Q = 0;
  for (int i = 0; i < view.m; ++i) {
    if (is_artificial(view.id[i])) return kInfinity;
    const bool of_Q = is_from_Q(view.id[i]);
    points_of_Q += of_Q ? 1 : 0;
    (of_Q ? beta : alpha) += view.x()[i] + enclosure.error;
    least = std::min(least, view.x()[i] - enclosure.error);
  }
  constexpr double kRoundedUp = 1.01;
  const double inverse = kRoundedUp * norm_of_changes(view) / (1 - residual_share());
  const double turned = inverse * view.m * std::max(error_A, error_Q);
  if (!(turned < 0.5)) return kInfinity;
  const double moved = kRoundedUp * inverse * (error_A * alpha + error_Q * beta) / (1 - turned);
  if (!(least >= moved)) return kInfinity;
  return (beta + points_of_Q * moved) * (1 + 4 * (view.m + 4) * kUnitRoundoff);
}

double PointBasis::cone_radius() {
  const Enclosure enclosure = enclose(true);
  if (!enclosure.valid) return 0;
  const BasisView& view = this->view();
  double smallest = kInfinity;
  int points_of_Q = 0;
  for (int i = 0; i < view.m; ++i) {
    if (is_artificial(view.id[i])) return 0;
    if (!is_from_Q(view.id[i])) continue;
    ++points_of_Q;
    smallest = std::min(smallest, view.x()[i]);
  }
  if (points_of_Q != view.m - 1 || !(smallest > enclosure.error)) return 0;
  // |B⁻¹ r|∞ <= |R r|∞ / (1 - ‖E‖) <= 2 ‖R‖ |r|∞, and that must not exceed the smallest weight.
  return 0.49 * (smallest - enclosure.error) / norm_of_changes(view);
}

}  // namespace raygauge
