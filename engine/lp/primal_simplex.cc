// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/primal_simplex.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/lp/affords.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

// Between two looks at the clock, and at the drift of the basis: so many pivots, or so many entries of the
// inverse and of the points passed over, some 10 ms.
constexpr std::int64_t kPivotsBetweenLooks = 512;
constexpr double kEntriesBetweenLooks = 2e7;
constexpr int kCostRaises = 14;  // 8^14 = 2^42: beyond, the first phase decides
constexpr double kLargeCost = 0x1p42;
constexpr int kRepairs = 3;
constexpr int kIdlePivots = 32;  // that an impatient solve allows, and half as many more as there are rows
// Margins of Farkas directions, tried in turn: far above the rounding in u·q, and far below most margins that
// random points leave.
constexpr double kMargins[] = {0x1p-24, 0x1p-36};
constexpr double kDrift = 1e-9;      // of the equations, after which the inverse is computed afresh
constexpr double kProgress = 1e-12;  // of the objective, relative, between two looks
constexpr double kNoise = 1e-14;     // of an objective, in units where both sets have magnitude 1
constexpr int kIdleLooks = 4;        // without progress: rounding leads the pivots in circles

std::int64_t default_pivot_limit(int n) { return 2000 + 400 * static_cast<std::int64_t>(n); }

std::int64_t pivots_between_looks(int m, std::ptrdiff_t points) {
  const double entries = static_cast<double>(m) * (m + 0.25 * static_cast<double>(points));
  return std::clamp(static_cast<std::int64_t>(kEntriesBetweenLooks / entries), std::int64_t{8},
                    kPivotsBetweenLooks);
}

}  // namespace

bool is_final(PrimalSimplex::End end) noexcept {
  return end == PrimalSimplex::End::failed || end == PrimalSimplex::End::pivot_limit ||
         end == PrimalSimplex::End::time_limit;
}

void PrimalSimplex::begin(int n, double gap_tolerance, std::int64_t max_pivots, const Kernels& kernels,
                          bool impatient) {
  n_ = n;
  kernels_ = &kernels;
  stage_ = Stage::optimise;
  raises_ = 0;
  separations_ = 0;
  repairs_ = 0;
  refactorisations_ = 0;
  impatient_ = impatient;
  max_pivots_ = max_pivots > 0 ? max_pivots : default_pivot_limit(n);
  loop_ = {};
  loop_.gap_tolerance = gap_tolerance;
  loop_.cost_tolerance = 4 * std::numeric_limits<double>::epsilon() * (n + 1);
  column_.reserve(static_cast<std::size_t>(padded_rows(n + 1)));
  guess_.reserve(static_cast<std::size_t>(n));
  white_.reserve(static_cast<std::size_t>(n));
  single_.reserve(static_cast<std::size_t>(n));
}

// max sign · guess · p over the points, and the best of them: a start needs no more than single precision.
double PrimalSimplex::price_guess(const PricedPoints& points, double sign, LaneList* lanes) {
  for (int k = 0; k < n_; ++k)
    column_[static_cast<std::size_t>(k)] = sign * guess_[static_cast<std::size_t>(k)];
  return kernels_->price_lanes(&points, n_, column_.data(), single_.data(), lanes);
}

// The point of A that the guess prefers, and artificial columns signed so that the basic solution is
// nonnegative. The inverse of that basis is known in closed form.
void PrimalSimplex::start(const ColumnPool& A, const ColumnPool& Q, const double* guess, double guess_error,
                          const Frame* frame, const AxisPoints* axes) {
  basis_.reset(n_ + 1, *kernels_);
  basis_.right_hand_side()[n_] = 1.0;

  // The guess, scaled to h_Q(-u) = 1 as the final normal will be.
  std::copy_n(guess, n_, guess_.data());
  const double h_Q = price_guess(Q.view(), -1.0, &loop_.first_Q);
  const double length = h_Q > 0 ? 1.0 / h_Q : 1.0;
  price_guess(A.view(), 1.0, &loop_.first_A);
  const std::int64_t index = loop_.first_A.best;
  for (int k = 0; k < n_; ++k) guess_[static_cast<std::size_t>(k)] = length * guess[k];

  double* a = column_.data();
  std::fill_n(a, basis_.view().P, 0.0);
  A.copy_point(index, a);
  a[n_] = 1.0;
  basis_.set_column(n_, a, 0.0, id_of_A(index));
  place_artificials(a, frame);
  set_artificial_costs(guess_.data(), guess_error, frame);
  if (axes != nullptr && frame == nullptr) place_axis_points(*axes);
}

// Into column_.
void PrimalSimplex::form_column(const ColumnPool& pool, std::int64_t id) {
  double* column = column_.data();
  std::fill_n(column, basis_.view().P, 0.0);
  pool.copy_point(id / 2, column);
  column[n_] = is_from_Q(id) ? 0.0 : 1.0;
  for (int k = 0; k < n_ && is_from_Q(id); ++k) column[k] = -column[k];
}

bool PrimalSimplex::enter(const ColumnPool& pool, std::int64_t id, double reduced_cost) {
  form_column(pool, id);
  std::int64_t left = 0;
  const double cost = is_from_Q(id) ? loop_.cost_of_Q : 0.0;
  if (kernels_->pivot(&basis_.view(), column_.data(), cost, reduced_cost, id, false, &left) !=
      PivotResult::ok) {
    return false;
  }
  if (is_artificial(left)) --loop_.artificials;
  return true;
}

// B = [F S, a; 0, 1] with the signs S: R = [S F⁻¹, -S F⁻¹ a; 0, 1], whose last column is x. F = I without a
// frame.
void PrimalSimplex::place_artificials(const double* a, const Frame* frame) {
  BasisView& view = basis_.view();
  double* R_last = view.R + static_cast<std::ptrdiff_t>(n_) * view.P;
  double* white = white_.data();
  std::copy_n(a, n_, white);
  if (frame != nullptr) {
    std::fill_n(white, n_, 0.0);
    for (int k = 0; k < n_; ++k) {
      for (int i = 0; i < n_; ++i) white[i] += frame->inverse[static_cast<std::ptrdiff_t>(k) * n_ + i] * a[k];
    }
  }
  for (int k = 0; k < n_; ++k) {
    const double sign = white[k] > 0 ? -1.0 : 1.0;
    double* column = view.B + static_cast<std::ptrdiff_t>(k) * view.P;
    if (frame == nullptr) {
      column[k] = sign;
      view.R[static_cast<std::ptrdiff_t>(k) * view.P + k] = sign;
    } else {
      for (int i = 0; i < n_; ++i) {
        column[i] = sign * frame->F[static_cast<std::ptrdiff_t>(k) * n_ + i];
        view.R[static_cast<std::ptrdiff_t>(i) * view.P + k] =
            sign * frame->inverse[static_cast<std::ptrdiff_t>(i) * n_ + k];
      }
    }
    view.id[k] = -1 - k;
    R_last[k] = -sign * white[k];
  }
  R_last[n_] = 1.0;
  std::copy_n(R_last, view.P, view.x());
  loop_.artificials = n_;
}

// A point q of Q with -q = |q| S_k e_k in the place of column S_k e_k, at cost 1.
void PrimalSimplex::place_axis_points(const AxisPoints& axes) {
  BasisView& view = basis_.view();
  double t = 0;
  view.objective = 0;
  for (int k = 0; k < n_; ++k) {
    double* column = view.B + static_cast<std::ptrdiff_t>(k) * view.P;
    const bool positive = column[k] < 0;
    const double length = axes.length(k, positive);
    if (length > 0) {
      view.id[k] = id_of_Q(axes.index(k, positive));
      view.cost[k] = 1;
      view.y[k] = column[k] / length;
      column[k] *= length;
      view.R[static_cast<std::ptrdiff_t>(k) * view.P + k] /= length;
      view.R[static_cast<std::ptrdiff_t>(n_) * view.P + k] /= length;
      view.x()[k] /= length;
      --loop_.artificials;
    }
    t -= view.y[k] * basis_.column(n_)[k];
    view.objective += view.cost[k] * view.x()[k];
  }
  view.y[n_] = t;
}

// c_k = max(S_k F_k · guess, 0) + slack, and the duals of that basis: yᵀ F S = c.
void PrimalSimplex::set_artificial_costs(const double* guess, double guess_error, const Frame* frame) {
  BasisView& view = basis_.view();
  double* white = white_.data();  // Fᵀ guess, then S c
  double scale = 0;
  for (int k = 0; k < n_; ++k) {
    white[k] = guess[k];
    if (frame != nullptr) {
      white[k] = std::inner_product(guess, guess + n_, frame->F + static_cast<std::ptrdiff_t>(k) * n_, 0.0);
    }
    scale = std::max(scale, std::fabs(white[k]));
  }
  const double* x = view.x();
  view.objective = 0;
  for (int k = 0; k < n_; ++k) {
    const double sign = std::signbit(basis_.column(k)[k]) ? -1.0 : 1.0;  // F_kk > 0
    view.cost[k] = std::max(sign * white[k], 0.0) + guess_error * scale;
    view.objective += view.cost[k] * x[k];
    white[k] = sign * view.cost[k];
  }
  double t = 0;
  for (int k = 0; k < n_; ++k) {
    view.y[k] = white[k];
    if (frame != nullptr) {
      view.y[k] =
          std::inner_product(white, white + n_, frame->inverse + static_cast<std::ptrdiff_t>(k) * n_, 0.0);
    }
    t -= view.y[k] * basis_.column(n_)[k];
  }
  view.y[n_] = t;
}

PrimalSimplex::End PrimalSimplex::solve(const ColumnPool& A, const ColumnPool& Q,
                                        const Stopwatch& stopwatch) {
  const End end = optimise(A, Q, stopwatch);
  if (end == End::solved) basis_.refresh_duals();
  return end;
}

void PrimalSimplex::bind(const ColumnPool& A, const ColumnPool& Q) {
  loop_.A = A.view();
  loop_.Q = Q.view();
  loop_.noise_A = kUnitRoundoff * A.magnitude();
  loop_.noise_Q = kUnitRoundoff * Q.magnitude();
}

PrimalSimplex::End PrimalSimplex::optimise(const ColumnPool& A, const ColumnPool& Q,
                                           const Stopwatch& stopwatch) {
  BasisView& view = basis_.view();
  bind(A, Q);
  idle_looks_ = 0;
  least_objective_ = kInfinity;
  pivots_assessed_ = view.pivots;
  std::int64_t between_looks = pivots_between_looks(n_ + 1, A.size() + Q.size());
  if (impatient_) between_looks = std::min<std::int64_t>(between_looks, kIdlePivots + n_ / 2);
  for (;;) {
    loop_.pivot_limit = std::min(max_pivots_, view.pivots + between_looks);
    const double objective = view.objective;
    const LoopEnd end = kernels_->simplex_loop(&view, &loop_);
    if (end == LoopEnd::pivot_limit) {
      const bool out_of_pivots = view.pivots >= max_pivots_;
      if (!out_of_pivots && !stopwatch.expired()) {
        if (impatient_ && !gains(objective)) return End::stalled;
        if (!look_after_basis()) return End::failed;
        continue;
      }
      basis_.refresh_duals();
      return out_of_pivots ? End::pivot_limit : End::time_limit;
    }
    if (stage_ == Stage::separate && (end != LoopEnd::optimal || !is_separated())) {
      if (!separate()) enter_stage(Stage::reach);
      continue;
    }
    if (end == LoopEnd::stalled && impatient_) return End::stalled;
    const bool no_time_to_invert = stopwatch.expired() || !affords_inverse(stopwatch, n_ + 1, *kernels_);
    if (end == LoopEnd::unbounded || end == LoopEnd::stalled) {
      if (no_time_to_invert) return End::time_limit;
      if (!repair()) return End::failed;
      loop_.bland = end == LoopEnd::stalled;
      continue;
    }
    const bool artificial = artificial_weight() > kArtificialZero;
    if (!artificial && !stopwatch.expired() && stage_ == Stage::optimise) return End::solved;
    basis_.refresh_duals();
    if (no_time_to_invert) return End::time_limit;
    if (artificial) return stage_ == Stage::optimise ? End::bounded : End::unreachable;
    enter_stage(Stage::optimise);
  }
}

// Whether the objective has fallen from `before`. One that is zero but for rounding cannot: it is no negative
// number.
bool PrimalSimplex::gains(double before) const {
  const double now = basis_.view().objective;
  if (stage_ == Stage::optimise && now < kNoise) return false;
  return now < before - kProgress * std::fabs(before);
}

// Now and then in a long solve. False where going on is useless.
bool PrimalSimplex::look_after_basis() {
  if (!(basis_.drift() <= kDrift)) {
    ++refactorisations_;
    if (!basis_.refactor()) return false;
  }
  if (basis_.view().pivots - pivots_assessed_ < kPivotsBetweenLooks) return true;
  pivots_assessed_ = basis_.view().pivots;
  const double objective = basis_.view().objective;
  const bool better = objective < least_objective_ * (1 - kProgress);
  idle_looks_ = better ? 0 : idle_looks_ + 1;
  least_objective_ = std::min(least_objective_, objective);
  return idle_looks_ < kIdleLooks;
}

bool PrimalSimplex::repair() {
  if (++repairs_ > kRepairs) return false;
  loop_.gap_tolerance = 0;
  ++refactorisations_;
  return basis_.refactor();
}

double PrimalSimplex::artificial_weight() const {
  if (loop_.artificials == 0) return 0;
  const BasisView& view = basis_.view();
  double weight = 0;
  for (int i = 0; i < view.m; ++i) {
    if (is_artificial(view.id[i])) weight += std::fabs(view.x()[i]);
  }
  return weight;
}

void PrimalSimplex::raise_bounds() {
  if (++raises_ > kCostRaises) return enter_stage(Stage::reach);
  BasisView& view = basis_.view();
  for (int i = 0; i < view.m; ++i) {
    if (is_artificial(view.id[i])) view.cost[i] = 8 * (view.cost[i] + 0.125);
  }
  basis_.refresh_duals();
}

bool PrimalSimplex::separate() {
  if (separations_ >= static_cast<int>(std::size(kMargins))) return false;
  ++separations_;
  enter_stage(Stage::separate);
  return true;
}

// Whether the distance of A from the cone outweighs the margin: the objective is -h_A(u).
bool PrimalSimplex::is_separated() {
  basis_.refresh_duals();
  return basis_.view().objective > 0;
}

double PrimalSimplex::cost_of_Q(Stage stage) const noexcept {
  if (stage == Stage::optimise) return 1;
  return stage == Stage::reach ? 0.0 : -kMargins[separations_ - 1];
}

void PrimalSimplex::enter_stage(Stage stage) {
  stage_ = stage;
  loop_.cost_of_Q = cost_of_Q(stage);
  BasisView& view = basis_.view();
  for (int i = 0; i < view.m; ++i) {
    if (is_artificial(view.id[i])) {
      view.cost[i] = stage == Stage::optimise ? kLargeCost : 1.0;
    } else {
      view.cost[i] = is_from_Q(view.id[i]) ? loop_.cost_of_Q : 0.0;
    }
  }
  ++refactorisations_;
  if (!basis_.refactor()) basis_.refresh_duals();
}

double PrimalSimplex::threshold_A() const noexcept {
  const double t = basis_.view().y[n_];
  return -t + 2 * loop_.cost_tolerance * std::fabs(t) + dual_length() * loop_.noise_A;
}

double PrimalSimplex::threshold_Q() const noexcept {
  return loop_.cost_of_Q + loop_.cost_tolerance + dual_length() * loop_.noise_Q;
}

double PrimalSimplex::dual_length() const noexcept {
  double sum = 0;
  for (int k = 0; k < n_; ++k) sum += std::fabs(basis_.view().y[k]);
  return sum;
}

}  // namespace raygauge
