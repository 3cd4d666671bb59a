// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/twofold_simplex.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/lp/affords.h"
#include "engine/lp/exact_rank.h"
#include "engine/lp/scaling.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

constexpr double kNoise = 0x1p-97;        // of x_i and w_i relative to Σ_k |R_ik|: rounding
constexpr double kPivot = 64;             // the least pivot, in units of that noise
constexpr double kCostTolerance = 1e-15;  // of reduced costs, relative to their terms
constexpr double kPriceNoise = 0x1p-92;   // the same, relative to Σ|u_k|
constexpr double kMargin = 0x1p-75;       // of a Farkas direction, relative to Σ|u_k|
constexpr double kSlack = 1 + 0x1p-48;    // of ratios, for their own rounding
constexpr double kOutOfTurn = 0x1p20;     // the same, of an artificial column that leaves out of turn
constexpr double kDrift = 1e-6;
constexpr double kInversion = 30;  // operations for m³, in those of doubles
constexpr int kPivotsOfAFactorisation = 64;

std::int64_t pivot_limit(int m) { return 200 + 20 * static_cast<std::int64_t>(m); }

DoubleDouble dot(const double* y, const double* y_low, const double* column, int m) {
  DoubleDouble sum;
  for (int k = 0; k < m; ++k) sum = sum + DoubleDouble{y[k], y_low[k]} * column[k];
  return sum;
}

}  // namespace

TwofoldSimplex::End TwofoldSimplex::solve(const Points& A, const Points& Q,
                                          std::span<const std::int64_t> start, double gap_tolerance,
                                          const Kernels& kernels, const Stopwatch& stopwatch) {
  bind(A, Q, gap_tolerance, kernels, stopwatch);
  if (!affords(stopwatch, kInversion * cube(m_)) || !start_from(start)) return End::stopped;
  return run_phases(*this, pivot_limit(m_));
}

bool TwofoldSimplex::refresh() {
  if (fresh_ == pivots_) return false;
  begin_anew();
  return true;
}

// Whether c_B·x and y·b = y_n, which are equal, have come apart.
bool TwofoldSimplex::has_drifted() const {
  double objective = 0;
  for (int i = 0; i < m_; ++i) objective += cost(i) * basis_.x(i).high;
  return !(std::fabs(objective - y_[static_cast<std::size_t>(n_)]) <= kDrift * std::fabs(objective));
}

bool TwofoldSimplex::separate() {
  margin_ = kMargin * dual_length();
  begin(SimplexPhase::separate);
  return true;
}

double TwofoldSimplex::dual_length() const {
  double sum = 0;
  for (int k = 0; k < n_; ++k) sum += std::fabs(y_[static_cast<std::size_t>(k)]);
  return sum;
}

double TwofoldSimplex::cost_of_Q() const noexcept {
  if (phase_ == SimplexPhase::optimise) return 1;
  return phase_ == SimplexPhase::reach ? 0.0 : -margin_;
}

void TwofoldSimplex::bind(const Points& A, const Points& Q, double gap_tolerance, const Kernels& kernels,
                          const Stopwatch& stopwatch) {
  A_ = A;
  Q_ = Q;
  kernels_ = &kernels;
  stopwatch_ = &stopwatch;
  gap_tolerance_ = gap_tolerance;
  n_ = A.set->dimension();
  m_ = n_ + 1;
  phase_ = SimplexPhase::reach;
  pivots_ = fresh_ = points_priced_ = 0;
  const auto rows = static_cast<std::size_t>(padded_rows(m_));
  for (AlignedBuffer<double>* vector : {&column_, &y_, &y_low_, &u_, &u_low_, &cost_}) vector->reserve(rows);
  const std::ptrdiff_t blocks = std::max(A.set->block_count(), Q.set->block_count());
  values_.reserve(static_cast<std::size_t>(blocks * PointSet::kLanes));
}

bool TwofoldSimplex::start_from(std::span<const std::int64_t> start) {
  basis_.reset(m_, *kernels_);
  for (const std::int64_t id : start) {
    if (id < 0) continue;
    if (stopwatch_->expired()) return false;
    form_column(id);
    basis_.place(column_.data(), id);
  }
  begin_anew();
  return true;
}

// With a new inverse: weights below zero are those of artificial columns with the opposite sign.
void TwofoldSimplex::begin_anew() {
  basis_.refactor();
  fresh_ = pivots_;
  basis_.measure_noise();
  for (int i = 0; i < m_; ++i) {
    if (basis_.x(i).high < -basis_.noise(i)) basis_.make_artificial(i);
  }
  if (has_reached()) {
    begin(SimplexPhase::optimise);
  } else {
    begin(phase_ == SimplexPhase::separate ? SimplexPhase::separate : SimplexPhase::reach);
  }
}

double TwofoldSimplex::cost(int i) const {
  if (basis_.is_artificial(i)) return phase_ == SimplexPhase::optimise ? 0.0 : 1.0;
  return is_from_Q(basis_.id(i)) ? cost_of_Q() : 0.0;
}

void TwofoldSimplex::begin(SimplexPhase phase) {
  phase_ = phase;
  std::fill_n(y_.data(), m_, 0.0);
  std::fill_n(y_low_.data(), m_, 0.0);
  for (int i = 0; i < m_; ++i) cost_[static_cast<std::size_t>(i)] = cost(i);
  basis_.refine_duals({cost_.data(), static_cast<std::size_t>(m_)}, y_.data(), y_low_.data());
}

void TwofoldSimplex::form_column(std::int64_t id) {
  double* column = column_.data();
  const bool from_Q = is_from_Q(id);
  const Points& points = from_Q ? Q_ : A_;
  points.set->copy_point(id / 2, column);
  for (int k = 0; k < n_; ++k) column[k] *= from_Q ? -points.factor[k] : points.factor[k];
  column[n_] = from_Q ? 0.0 : 1.0;
}

// max sign · u·p over the points.
double TwofoldSimplex::price_set(const Points& points, double sign, std::ptrdiff_t* index) {
  const PointSet& S = *points.set;
  double* u = u_.data();
  double* u_low = u_low_.data();
  for (int k = 0; k < n_; ++k) {
    const auto at = static_cast<std::size_t>(k);
    u[k] = sign * Scaling::direction_component(points.factor[k], y_[at]);
    u_low[k] = sign * Scaling::direction_component(points.factor[k], y_low_[at]);
  }
  double* values = values_.data();
  kernels_->products_twofold(S.data(), S.block_count(), n_, u, u_low, values);
  points_priced_ += S.size();
  *index = std::max_element(values, values + S.size()) - values;
  return values[*index];
}

std::int64_t TwofoldSimplex::price() {
  if (pivots_ - fresh_ >= kPivotsOfAFactorisation || (pivots_ != fresh_ && has_drifted())) begin_anew();
  std::ptrdiff_t a = 0;
  std::ptrdiff_t q = 0;
  Entering best;
  best.h_A = price_set(A_, 1.0, &a);
  best.h_Q = price_set(Q_, -1.0, &q);
  const double t = y_[static_cast<std::size_t>(n_)];
  const double d_A = -((best.h_A + t) + y_low_[static_cast<std::size_t>(n_)]);
  const double d_Q = cost_of_Q() - best.h_Q;
  const double noise = kPriceNoise * dual_length();
  const bool A_enters = d_A < -(kCostTolerance * std::fabs(t) + noise);
  const bool Q_enters = d_Q < -(kCostTolerance * std::fabs(cost_of_Q()) + noise);
  const bool take_A = A_enters && (!Q_enters || d_A < d_Q * std::fabs(t));
  if (take_A) best.id = id_of_A(a);
  if (Q_enters && !take_A) best.id = id_of_Q(q);
  return gap_is_closed(best) ? -1 : best.id;
}

bool TwofoldSimplex::gap_is_closed(const Entering& priced) const {
  if (phase_ != SimplexPhase::optimise || !(priced.h_Q > 0)) return false;
  double objective = 0;
  for (int i = 0; i < m_; ++i) {
    if (is_from_Q(basis_.id(i))) objective += basis_.x(i).high;
  }
  return objective + priced.h_A / priced.h_Q <= gap_tolerance_ * objective;
}

// False where rounding leaves no pivot.
bool TwofoldSimplex::enter(std::int64_t id) {
  form_column(id);
  basis_.transform(column_.data());
  const int row = basis_.leaving_row(phase_ == SimplexPhase::optimise);
  if (row < 0) return false;
  const double cost_of_column = is_from_Q(id) ? cost_of_Q() : 0.0;
  const DoubleDouble d = DoubleDouble{cost_of_column} - dot(y_.data(), y_low_.data(), column_.data(), m_);
  basis_.replace(row, column_.data(), id);
  basis_.measure_noise();
  for (int k = 0; k < m_; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const DoubleDouble y = DoubleDouble{y_[at], y_low_[at]} + d * basis_.R(row, k);
    y_[at] = y.high;
    y_low_[at] = y.low;
  }
  ++pivots_;
  return true;
}

void TwofoldPointBasis::measure_noise() {
  noise_.reserve(static_cast<std::size_t>(padded_rows(size())));
  norms_of_rows(noise_.data());
  for (int i = 0; i < size(); ++i) noise_[static_cast<std::size_t>(i)] *= kNoise;
}

int TwofoldPointBasis::leaving_row(bool at_zero) const {
  int row = -1;
  double largest = 0;
  for (int i = 0; at_zero && i < size(); ++i) {
    const double w_i = std::fabs(w(i).high) / noise(i);
    if (!is_artificial(i) || !(w_i > std::max(largest, kOutOfTurn))) continue;
    largest = w_i;
    row = i;
  }
  if (row >= 0) return row;
  double bound = kInfinity;
  for (int i = 0; i < size(); ++i) {
    const double w_i = w(i).high;
    if (w_i > kPivot * noise(i)) bound = std::min(bound, (std::max(x(i).high, 0.0) + noise(i)) / w_i);
  }
  for (int i = 0; i < size(); ++i) {
    const double w_i = w(i).high;
    if (!(w_i > std::max(largest, kPivot * noise(i))) || !(x(i).high <= kSlack * bound * w_i)) continue;
    largest = w_i;
    row = i;
  }
  return row;
}

bool TwofoldPointBasis::has_reached() const {
  for (int i = 0; i < size(); ++i) {
    if (is_artificial(i) && x(i).high > noise(i)) return false;
  }
  return true;
}

double TwofoldPointBasis::upper(const Stopwatch& stopwatch) {
  solve(solution_);
  if (!(solution_.error < kInfinity)) return kInfinity;
  DoubleDouble beta;
  zeros_.clear();
  for (int i = 0; i < size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double x = solution_.part[0][at];  // the others are below its last bit
    if (is_artificial(i) || !(x > 2 * solution_.error)) {
      if (!(std::fabs(x) <= 4 * solution_.error)) return kInfinity;
      zeros_.push_back(i);
      solution_.part[0][at] = 0;
    } else if (is_from_Q(id(i))) {
      beta = beta + DoubleDouble{x, solution_.part[1][at]};
    }
  }
  objective_ = beta.rounded();
  if (!zeros_.empty() && !are_zero(stopwatch)) return kInfinity;
  if (objective_ == 0) return 0;
  // Third parts are below 2⁻¹⁰⁵ of the first ones.
  return (objective_ + size() * solution_.error) * (1 + 4 * kUnitRoundoff + size() * 0x1p-98);
}

// Whether the weights at zeros_ are exactly zero: the other columns, which are independent, span the
// right-hand side.
bool TwofoldPointBasis::are_zero(const Stopwatch& stopwatch) {
  const int m = size(), count = m - static_cast<int>(zeros_.size());
  columns_.assign((static_cast<std::size_t>(count) + 1) * static_cast<std::size_t>(m), 0.0);
  double* next = columns_.data();
  auto zero = zeros_.begin();
  for (int i = 0; i < m; ++i) {
    if (zero != zeros_.end() && *zero == i) {
      ++zero;
      continue;
    }
    next = std::copy_n(column(i), m, next);
  }
  columns_.back() = 1;
  std::vector<int> chosen(static_cast<std::size_t>(count));
  std::iota(chosen.begin(), chosen.end(), 0);
  return columns_span({columns_.data(), m, m, count + 1}, chosen, stopwatch);
}

void TwofoldPointBasis::contact_point(double* point) const {
  const int n = size() - 1;
  std::fill_n(point, n, 0.0);
  for (int i = 0; i < size(); ++i) {
    if (!is_point_of_A(i)) continue;
    const double weight = solution_.part[0][static_cast<std::size_t>(i)];
    for (int k = 0; k < n; ++k) point[k] += weight * column(i)[k];
  }
}

void TwofoldPointBasis::weights_of_A(std::vector<PointWeight>& weights) const {
  weights.clear();
  for (int i = 0; i < size(); ++i) {
    const double weight = solution_.part[0][static_cast<std::size_t>(i)];
    if (!is_point_of_A(i) || weight == 0) continue;
    weights.push_back({static_cast<std::ptrdiff_t>(id(i) / 2), weight});
  }
}

}  // namespace raygauge
