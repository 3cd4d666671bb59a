// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/optimal_face.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/lp/affords.h"
#include "engine/lp/exact_rank.h"
#include "engine/numerics/double_double.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

constexpr double kIndependent = 1e-11;  // the least pivot, relative to the first: where ranks end
constexpr double kLeastScale = 1e-4;    // of columns by their weights
constexpr int kSteps = 3;               // of refinement
constexpr int kRounds = 16;             // of so many steps, by an inverse with a larger residual_share()
constexpr double kAccurateInverse = 1e-5;
constexpr double kWorthARound = 0.25;  // of the bound before
constexpr double kRoundedUp = 1.02;

// max |x_k|: four at a time, which the compiler may not do by itself.
double largest_of(const double* x, std::size_t count) {
  double largest[4] = {0, 0, 0, 0};
  std::size_t k = 0;
  for (; k + 4 <= count; k += 4) {
    for (std::size_t i = 0; i < 4; ++i) largest[i] = std::max(largest[i], std::fabs(x[k + i]));
  }
  for (; k < count; ++k) largest[0] = std::max(largest[0], std::fabs(x[k]));
  return std::max(std::max(largest[0], largest[1]), std::max(largest[2], largest[3]));
}

}  // namespace

// Weighted: the pivots' weights are those that will change.
void Elimination::scale(int m, const std::vector<double>& columns, const std::vector<double>& weights) {
  const auto size = static_cast<std::size_t>(m);
  eliminated_.reserve(weights.size() * static_cast<std::size_t>(padded_rows(m)));
  largest_.assign(weights.size(), 0.0);
  left_.clear();
  const double heaviest = *std::max_element(weights.begin(), weights.end());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double* given = columns.data() + i * size;
    const double largest = largest_of(given, size);
    if (!(largest > 0)) continue;
    const double scale = std::max(weights[i] / heaviest, kLeastScale) / largest;
    double* scaled = column(static_cast<int>(i), m);
    for (std::size_t k = 0; k < size; ++k) scaled[k] = scale * given[k];
    std::fill(scaled + m, scaled + padded_rows(m), 0.0);
    largest_[i] = largest_of(scaled, size);
    left_.push_back(static_cast<int>(i));
  }
}

void Elimination::choose(int m, const std::vector<double>& columns, const std::vector<double>& weights,
                         std::ptrdiff_t most, const Kernels& kernels, const Stopwatch& stopwatch,
                         std::vector<Pivot>& pivots) {
  pivots.clear();
  scale(m, columns, weights);
  const auto has_less = [this](int a, int b) {
    return largest_[static_cast<std::size_t>(a)] < largest_[static_cast<std::size_t>(b)];
  };
  if (std::ssize(left_) > most) {
    std::nth_element(left_.begin(), left_.begin() + most, left_.end(),
                     [&](int a, int b) { return has_less(b, a); });
    left_.resize(static_cast<std::size_t>(most));
  }
  double first = 0;
  while (std::ssize(pivots) < m && !left_.empty() && !stopwatch.expired()) {
    const auto best = std::max_element(left_.begin(), left_.end(), has_less);
    const int chosen = *best;
    const double largest = largest_[static_cast<std::size_t>(chosen)];
    if (pivots.empty()) first = largest;
    if (!(largest > kIndependent * first)) return;
    left_.erase(best);
    pivots.push_back(clear_row_of(m, chosen, kernels));
  }
}

// A step of the elimination: the largest entry of the column is the pivot of the others that are left.
Elimination::Pivot Elimination::clear_row_of(int m, int id, const Kernels& kernels) {
  double* chosen = column(id, m);
  const double largest = largest_[static_cast<std::size_t>(id)];
  std::size_t row = 0;
  while (std::fabs(chosen[row]) != largest) ++row;
  const double pivot = std::exchange(chosen[row], 0.0);
  for (const int i : left_) {
    double* other = column(i, m);
    const double factor = std::exchange(other[row], 0.0) / pivot;
    if (factor == 0) continue;
    largest_[static_cast<std::size_t>(i)] = kernels.add_multiple(other, chosen, padded_rows(m), -factor);
  }
  return {static_cast<int>(row), id};
}

void OptimalFace::begin(int m, const Kernels& kernels) {
  m_ = m;
  kernels_ = &kernels;
  columns_.clear();
  costs_.clear();
  weights_.clear();
  ids_.clear();
  pivots_.clear();
}

void OptimalFace::add(const double* column, double cost, double weight, std::int64_t id) {
  columns_.insert(columns_.end(), column, column + m_);
  costs_.push_back(cost);
  weights_.push_back(weight);
  ids_.push_back(id);
}

bool OptimalFace::choose(const Stopwatch& stopwatch, std::ptrdiff_t most) {
  if (ids_.empty()) return false;
  elimination_.choose(m_, columns_, weights_, most, *kernels_, stopwatch, pivots_);
  if (rank() == 0 || stopwatch.expired()) return false;
  take_pivots();
  return true;
}

// M_RP into basis_.
void OptimalFace::take_pivots() {
  const int r = rank();
  basis_.reset(r, *kernels_);
  work_.resize(static_cast<std::size_t>(r));
  for (int i = 0; i < r; ++i) {
    const int from = pivots_[static_cast<std::size_t>(i)].column;
    for (int k = 0; k < r; ++k)
      work_[static_cast<std::size_t>(k)] = column(from)[pivots_[static_cast<std::size_t>(k)].row];
    basis_.set_column(i, work_.data(), costs_[static_cast<std::size_t>(from)], i);
  }
}

// (b - M x)_R over the columns that are no pivots, and b_low_. Returns a bound on its rounding error in any
// entry.
double OptimalFace::set_right_hand_side() {
  is_pivot_.assign(ids_.size(), false);
  for (const Pivot& pivot : pivots_) is_pivot_[static_cast<std::size_t>(pivot.column)] = true;
  b_low_.assign(static_cast<std::size_t>(rank()), 0.0);
  double error = 0;
  for (int k = 0; k < rank(); ++k) {
    const int row = pivots_[static_cast<std::size_t>(k)].row;
    DoubleDouble sum{row == m_ - 1 ? 1.0 : 0.0};
    double size = 0;
    for (int i = 0; i < count(); ++i) {
      if (is_pivot_[static_cast<std::size_t>(i)]) continue;
      const DoubleDouble term = two_product(weight(i), column(i)[row]);
      sum = sum - term;
      size += std::fabs(term.high);
    }
    basis_.right_hand_side()[k] = sum.high;
    b_low_[static_cast<std::size_t>(k)] = sum.low;
    if (size > 0) error = std::max(error, count() * 0x1p-99 * (size + 1) + kUnderflow);
  }
  return error;
}

// A bound on |R (b - B (x + x_low_))|∞ of the solution for the right-hand side b, from x on. A step
// multiplies the error by less than residual_share(): where that is much, steps go on as long as the bound
// falls.
double OptimalFace::refine(Basis& basis) {
  BasisView& view = basis.view();
  std::fill_n(x_low_.data(), view.P, 0.0);
  const int rounds = basis.residual_share() < kAccurateInverse ? 1 : kRounds;
  double bound = kInfinity;
  for (int round = 0; round < rounds; ++round) {
    for (int step = 0; step < kSteps; ++step)
      kernels_->refine_twofold(&view, basis.right_hand_side(), x_low_.data(), true);
    const double before = bound;
    bound = kernels_->refine_twofold(&view, basis.right_hand_side(), x_low_.data(), false);
    if (!(bound < kWorthARound * before)) break;
  }
  return bound;
}

// A bound on the error of x + x_low_, for a right-hand side + b_low_ of which every entry is known to
// `error_of_b`. The low parts are solved for on their own.
double OptimalFace::enclose(Basis& basis, double error_of_b) {
  BasisView& view = basis.view();
  const auto r = static_cast<std::size_t>(rank());
  if (!basis.refactor()) return kInfinity;
  x_low_.reserve(static_cast<std::size_t>(view.P));
  const double share = basis.residual_share();
  double residual = refine(basis);
  if (std::any_of(b_low_.begin(), b_low_.end(), [](double low) { return low != 0; })) {
    const std::vector<double> x(view.x(), view.x() + r), x_low(x_low_.data(), x_low_.data() + r);
    std::copy(b_low_.begin(), b_low_.end(), basis.right_hand_side());
    std::fill_n(view.x(), view.P, 0.0);
    residual += refine(basis);
    double size = 0;
    for (std::size_t i = 0; i < r; ++i) {
      const double y = view.x()[i];
      const DoubleDouble sum = two_sum(x[i], x_low[i]) + two_sum(y, x_low_[i]);
      view.x()[i] = sum.high;
      x_low_[i] = sum.low;
      size = std::max(size, std::fabs(x[i]) + std::fabs(y));
    }
    residual += 0x1p-100 * size;
  }
  if (!(share < 0.5) || !std::isfinite(residual)) return kInfinity;
  const double norm = error_of_b > 0 ? basis.norm_of_inverse() : 0;
  return kRoundedUp * (residual + norm * error_of_b) / (1 - share);
}

double OptimalFace::upper(const Stopwatch& stopwatch) {
  if (!affords(stopwatch, 3 * cube(rank()))) return kInfinity;
  const double error = enclose(basis_, set_right_hand_side());
  if (!(error < kInfinity)) return kInfinity;
  rounded_ = true;
  for (int i = 0; i < rank(); ++i) {
    double& low = x_low_[static_cast<std::size_t>(i)];
    const DoubleDouble x = two_sum(basis_.view().x()[i], low);
    if (!(x.high > 2 * error)) return kInfinity;
    weights_[static_cast<std::size_t>(pivots_[static_cast<std::size_t>(i)].column)] = x.high;
    low = x.low;
    rounded_ = rounded_ && std::fabs(low) + error < 0.5 * (x.high - std::nextafter(x.high, 0.0));
  }
  DoubleDouble sum;
  for (int i = 0; i < count(); ++i) {
    if (!(weight(i) > 0)) return kInfinity;
    if (costs_[static_cast<std::size_t>(i)] > 0) sum = sum + weight(i);
  }
  if (!may_solve(error) || !spans(true, stopwatch)) return kInfinity;
  if (sum.high == 0) return 0;
  for (int i = 0; i < rank(); ++i) {
    const int from = pivots_[static_cast<std::size_t>(i)].column;
    if (costs_[static_cast<std::size_t>(from)] > 0) sum = sum + x_low_[static_cast<std::size_t>(i)];
  }
  return (sum.rounded() + rank() * error) * (1 + 4 * kUnitRoundoff + count() * 0x1p-98);
}

// False where a row that is none of the pivots' is proven to miss b, with weights that are known to `error`:
// sooner than by ranks.
bool OptimalFace::may_solve(double error) const {
  std::vector<bool> is_pivot(static_cast<std::size_t>(m_), false);
  for (const Pivot& pivot : pivots_) is_pivot[static_cast<std::size_t>(pivot.row)] = true;
  for (int k = 0; k < m_; ++k) {
    if (is_pivot[static_cast<std::size_t>(k)]) continue;
    DoubleDouble rest{k == m_ - 1 ? -1.0 : 0.0};
    double size = 1, reach = 0;
    for (int i = 0; i < count(); ++i) {
      const DoubleDouble term = two_product(weight(i), column(i)[k]);
      rest = rest + term;
      size += std::fabs(term.high);
    }
    for (int i = 0; i < rank(); ++i) {
      const double entry = column(pivots_[static_cast<std::size_t>(i)].column)[k];
      rest = rest + two_product(x_low_[static_cast<std::size_t>(i)], entry);
      reach += std::fabs(entry);
    }
    if (std::fabs(rest.rounded()) > kRoundedUp * (reach * error + (count() + 1) * 0x1p-98 * size))
      return false;
  }
  return true;
}

// Whether the pivot columns span all columns, and b.
bool OptimalFace::spans(bool with_right_hand_side, const Stopwatch& stopwatch) {
  if (rank() == m_) return true;
  std::vector<int> chosen;
  for (const Pivot& pivot : pivots_) chosen.push_back(pivot.column);
  work_ = columns_;
  if (with_right_hand_side) {
    work_.insert(work_.end(), static_cast<std::size_t>(m_), 0.0);
    work_.back() = 1;
  }
  const int columns = count() + (with_right_hand_side ? 1 : 0);
  return columns_span({work_.data(), m_, m_, columns}, chosen, stopwatch);
}

void OptimalFace::refine_duals(double* y, double* y_low) {
  const BasisView& view = basis_.view();
  const int r = rank();
  std::fill_n(y_low, m_, 0.0);
  work_.resize(static_cast<std::size_t>(r));
  for (int step = 0; step < kSteps; ++step) {
    for (int i = 0; i < r; ++i) {
      const int from = pivots_[static_cast<std::size_t>(i)].column;
      DoubleDouble reduced{costs_[static_cast<std::size_t>(from)]};
      for (int k = 0; k < m_; ++k) reduced = reduced - DoubleDouble{y[k], y_low[k]} * column(from)[k];
      work_[static_cast<std::size_t>(i)] = reduced.rounded();
    }
    for (int k = 0; k < r; ++k) {
      double change = 0;
      for (int i = 0; i < r; ++i) {
        change += work_[static_cast<std::size_t>(i)] * view.R[static_cast<std::ptrdiff_t>(k) * view.P + i];
      }
      const int row = pivots_[static_cast<std::size_t>(k)].row;
      const DoubleDouble better = DoubleDouble{y[row], y_low[row]} + change;
      y[row] = better.high;
      y_low[row] = better.low;
    }
  }
}

// M_RPᵀ u_R = -M_PᵀU over the other rows, whose coordinates stay.
double OptimalFace::enclose_orthogonal(double* u, double* u_low, const Stopwatch& stopwatch) {
  const int r = rank();
  if (r == m_ || !affords(stopwatch, 3 * cube(r))) return kInfinity;  // of m columns: u = 0 only
  std::vector<bool> is_pivot(static_cast<std::size_t>(m_), false);
  for (const Pivot& pivot : pivots_) is_pivot[static_cast<std::size_t>(pivot.row)] = true;
  transposed_.reset(r, *kernels_);
  work_.resize(static_cast<std::size_t>(r));
  for (int k = 0; k < r; ++k) {
    for (int i = 0; i < r; ++i) {
      work_[static_cast<std::size_t>(i)] =
          column(pivots_[static_cast<std::size_t>(i)].column)[pivots_[static_cast<std::size_t>(k)].row];
    }
    transposed_.set_column(k, work_.data(), 0, k);
  }
  b_low_.assign(static_cast<std::size_t>(r), 0.0);
  double error = 0;
  for (int i = 0; i < r; ++i) {
    const double* p = column(pivots_[static_cast<std::size_t>(i)].column);
    DoubleDouble sum;
    double size = 0;
    for (int k = 0; k < m_; ++k) {
      if (is_pivot[static_cast<std::size_t>(k)]) continue;
      const DoubleDouble term = two_product(u[k], p[k]);
      sum = sum - term;
      size += std::fabs(term.high);
    }
    transposed_.right_hand_side()[i] = sum.high;
    b_low_[static_cast<std::size_t>(i)] = sum.low;
    error = std::max(error, m_ * 0x1p-99 * size + kUnderflow);
  }
  error = enclose(transposed_, error);
  if (!(error < kInfinity) || !spans(false, stopwatch)) return kInfinity;
  std::fill_n(u_low, m_, 0.0);
  for (int k = 0; k < r; ++k) {
    const int row = pivots_[static_cast<std::size_t>(k)].row;
    const DoubleDouble value = two_sum(transposed_.view().x()[k], x_low_[static_cast<std::size_t>(k)]);
    u[row] = value.high;
    u_low[row] = value.low;
  }
  return error;
}

}  // namespace raygauge
