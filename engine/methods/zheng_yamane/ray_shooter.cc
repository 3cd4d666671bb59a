// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/zheng_yamane/ray_shooter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

constexpr double kZero = 1e-13;      // weight of artificial columns that is rounding noise
constexpr double kFeasible = 1e-11;  // how negative a weight may be after the vertices were moved
constexpr int kRayCostRaises = 14;
// How far the first normals may be from -a_c, in parts of its largest entry: what takes the fewest iterations
// on the grid of the paper, and at n = 20 to 100.
constexpr int kFewDimensions = 16;
constexpr double kMarginOfFew = 0.14;
constexpr double kMarginOfMany = 0.5;
constexpr int kRayRepairs = 2;
constexpr int kIterationsBetweenLooks = 64;  // at the clock, where they are over few points
constexpr std::ptrdiff_t kFewNumbers = 1 << 16;
constexpr int kShortlistQueries = 8;  // after a pass
// Of the pass's own reduced cost: a column of a shortlist that promises less waits for a better one.
constexpr double kWorthEntering = 0.4;

}  // namespace

void RayShooter::begin(SupportOracle& A, SupportOracle& Q, int n, const double* a_c, const Kernels& kernels) {
  A_ = &A;
  Q_ = &Q;
  n_ = n;
  kernels_ = &kernels;
  warm_ = false;
  iterations_ = passes_ = pivots_ = refactorisations_ = 0;
  keeps_shortlists_ = A.keeps_shortlist() && Q.keeps_shortlist();
  const auto size = static_cast<std::size_t>(n);
  basis_ = &bases_[0];
  spare_ = &bases_[1];
  center_.reserve(size);
  std::copy_n(a_c, n, center_.data());
  slots_.reserve(2 * size * (size + 1));
  column_.reserve(static_cast<std::size_t>(padded_rows(n)));
  bases_[0].reset(n, kernels);
  bases_[1].reset(n, kernels);
}

double* RayShooter::slot_A(std::int64_t slot) const noexcept {
  return const_cast<double*>(slots_.data()) + 2 * slot * n_;
}

double* RayShooter::slot_Q(std::int64_t slot) const noexcept { return slot_A(slot) + n_; }

// A column with u·s > enough, of the shortlists if they have one; otherwise the best of the points at hand.
// Returns its u·s.
double RayShooter::best_column(const double* u, double eta, double enough) {
  if (!keeps_shortlists_) return query(u, eta);
  if (shortlisted_-- > 0) {
    const double value = query_shortlists(u, eta);
    if (value > enough + kWorthEntering * shortlist_excess_) return value;
  }
  A_->pass(u, 1.0);
  Q_->pass(u, -1.0);
  ++passes_;
  shortlisted_ = kShortlistQueries;
  const double value = query_shortlists(u, eta);
  shortlist_excess_ = value - enough;
  return value > enough ? value : query(u, eta);
}

double RayShooter::query_shortlists(const double* u, double eta) {
  best_A_ = A_->query_shortlist(u, 1.0, slot_A(free_slot_));
  best_Q_ = Q_->query_shortlist(u, -1.0, slot_Q(free_slot_));
  ++iterations_;
  return support_of_column(u, eta);
}

// h_S(u) over the points at hand; the maximiser becomes the candidate column.
double RayShooter::query(const double* u, double eta) {
  ++iterations_;
  ++passes_;
  if (A_->has_points() && Q_->has_points()) {
    const PricedPoints A = A_->points();
    const PricedPoints Q = Q_->points();
    BestVertex best = {center_.data(), eta, slot_A(free_slot_), slot_Q(free_slot_), column_.data()};
    const double h_S = kernels_->best_vertex(&A, &Q, n_, u, &best);
    best_A_ = best.value_A;
    best_Q_ = best.value_Q;
    return h_S;
  }
  best_A_ = A_->query(u, 1.0, slot_A(free_slot_));
  best_Q_ = Q_->query(u, -1.0, slot_Q(free_slot_));
  return support_of_column(u, eta);
}

// The same over the whole sets.
double RayShooter::verify(const double* u, double eta) {
  h_A_ = A_->verify(u, 1.0, best_A_, slot_A(free_slot_));
  h_Q_ = Q_->verify(u, -1.0, best_Q_, slot_Q(free_slot_));
  return support_of_column(u, eta);
}

double RayShooter::support_of_column(const double* u, double eta) {
  form_column(free_slot_, eta, column_.data());
  double h_S = 0;
  for (int k = 0; k < n_; ++k) h_S += u[k] * column_[static_cast<std::size_t>(k)];
  return h_S;
}

// s = s_A - a_c - η s_Q, equation (13b).
void RayShooter::form_column(std::int64_t slot, double eta, double* column) const {
  const double* a = slot_A(slot);
  const double* q = slot_Q(slot);
  for (int k = 0; k < n_; ++k) column[k] = a[k] - center_[static_cast<std::size_t>(k)] - eta * q[k];
}

// Artificial columns ±e_k at costs that make -a_c the first normal, scaled to h_S(u) = 1.
void RayShooter::start_cold(double eta) {
  Basis& basis = *basis_;
  pivots_ += basis.view().pivots;
  basis.reset(n_, *kernels_);
  BasisView& view = basis.view();
  raises_ = 0;
  free_slot_ = n_;
  std::fill_n(column_.data(), padded_rows(n_), 0.0);
  double* u = view.y;
  double largest = 0;
  const double margin = n_ < kFewDimensions ? kMarginOfFew : kMarginOfMany;
  for (int k = 0; k < n_; ++k) u[k] = -center_[static_cast<std::size_t>(k)];
  const double h_S = query(u, eta);
  const double length = h_S > 0 ? 1.0 / h_S : 1.0;
  for (int k = 0; k < n_; ++k) {
    u[k] *= length;
    largest = std::max(largest, std::fabs(u[k]));
  }
  for (int k = 0; k < n_; ++k) {
    const double b = -center_[static_cast<std::size_t>(k)];
    const double sign = b < 0 ? -1.0 : 1.0;
    const std::ptrdiff_t diagonal = static_cast<std::ptrdiff_t>(k) * view.P + k;
    basis.right_hand_side()[k] = b;
    view.B[diagonal] = sign;
    view.R[diagonal] = sign;
    view.x()[k] = std::fabs(b);
    view.cost[k] = std::max(sign * u[k], 0.0) + margin * largest;
    view.y[k] = sign * view.cost[k];
    view.id[k] = -1 - k;
    view.objective += view.cost[k] * view.x()[k];
  }
}

// The same support points at another η; false if the ray does not pass through their hull.
bool RayShooter::move_vertices(double eta) {
  const BasisView& old = basis_->view();
  pivots_ += spare_->view().pivots;
  spare_->reset(n_, *kernels_);
  for (int i = 0; i < n_; ++i) {
    if (is_artificial(old.id[i])) return false;
    form_column(old.id[i], eta, column_.data());
    spare_->set_column(i, column_.data(), 1.0, old.id[i]);
    spare_->right_hand_side()[i] = basis_->right_hand_side()[i];
  }
  ++refactorisations_;
  if (!spare_->refactor()) return false;
  const double* x = spare_->view().x();
  if (std::any_of(x, x + n_, [](double c) { return !(c >= -kFeasible); })) return false;
  pivots_ += basis_->view().pivots;
  basis_->view().pivots = 0;
  std::swap(basis_, spare_);
  return true;
}

double RayShooter::artificial_weight() const {
  const BasisView& view = basis_->view();
  double weight = 0;
  for (int i = 0; i < n_; ++i) {
    if (is_artificial(view.id[i])) weight += std::fabs(view.x()[i]);
  }
  return weight;
}

// Whether the last query, if it was one of all points at hand, promises a bound of `overtaking`.
bool RayShooter::overtakes(double overtaking) const noexcept {
  return overtaking < kInfinity && best_A_ < 0 && -best_A_ >= overtaking * best_Q_;
}

// Brings the candidate column, of u·s = h_S, into the basis. False if rounding leaves no pivot.
bool RayShooter::enter_candidate(double h_S) {
  std::int64_t left = 0;
  BasisView& view = basis_->view();
  if (kernels_->pivot(&view, column_.data(), 1.0, 1.0 - h_S, free_slot_, false, &left) != PivotResult::ok) {
    return false;
  }
  // The slot of the vertex that left takes the next candidate; artificial columns free one that was never
  // used.
  free_slot_ = left >= 0 ? left : -1 - left;
  return true;
}

// Makes the artificial columns of the basis dearer. False where that was tried often.
bool RayShooter::raise_artificial_costs() {
  if (++raises_ > kRayCostRaises) return false;
  BasisView& view = basis_->view();
  for (int i = 0; i < n_; ++i) {
    if (is_artificial(view.id[i])) view.cost[i] = 8 * (view.cost[i] + 0.125);
  }
  basis_->refresh_duals();
  return true;
}

// The last query was one of all points at hand: whether it promises a bound of `overtaking`, which the whole
// sets then prove.
bool RayShooter::is_overtaken(double eta, double overtaking) {
  if (!overtakes(overtaking)) return false;
  verify(basis_->view().y, eta);
  return h_A_.value < 0 && -h_A_.value >= overtaking * h_Q_.value;
}

RayShooter::End RayShooter::shoot(double eta, double tolerance, double overtaking,
                                  std::int64_t max_iterations, const Stopwatch& stopwatch) {
  shortlisted_ = 0;
  const bool kept = warm_ && (move_vertices(eta) || eta >= eta_shot_);
  if (!kept) start_cold(eta);
  warm_ = true;
  eta_shot_ = eta;
  int repairs = 0;
  int idle = 0;
  double least = basis_->view().objective;
  for (;;) {
    const BasisView& view = basis_->view();
    const std::int64_t passes = passes_;
    double h_S = best_column(view.y, eta, 1 + tolerance);
    sigma_ = view.objective;
    const bool out_of_iterations = iterations_ >= max_iterations;
    const bool out_of_time = iterations_ % between_looks() == 0 && stopwatch.expired();
    if (h_S <= 1 + tolerance || out_of_iterations || out_of_time) h_S = verify(view.y, eta);
    if (passes_ > passes && is_overtaken(eta, overtaking)) return End::overtaken;
    if (out_of_iterations) return End::iteration_limit;
    if (out_of_time) return End::time_limit;
    if (h_S <= 1 + tolerance) {
      if (artificial_weight() <= kZero) return End::hit;
      if (!raise_artificial_costs()) return End::missed;
      least = view.objective;
      continue;
    }
    idle = view.objective < least * (1 - 1e-15) ? 0 : idle + 1;
    least = std::min(least, view.objective);
    if (idle > 64 + 8 * n_) return End::failed;
    if (enter_candidate(h_S)) continue;
    ++refactorisations_;
    if (++repairs > kRayRepairs || !basis_->refactor()) return End::failed;
  }
}

// A support query of a general set may be a linear program of its own.
int RayShooter::between_looks() const {
  if (!A_->has_points() || !Q_->has_points()) return 1;
  const std::ptrdiff_t blocks = A_->points().block_count + Q_->points().block_count;
  return blocks * n_ * PointSet::kLanes < kFewNumbers ? kIterationsBetweenLooks : 1;
}

const double* RayShooter::vertex_A(int l) const noexcept {
  const std::int64_t slot = basis_->view().id[l];
  return slot < 0 ? nullptr : slot_A(slot);
}

const double* RayShooter::vertex_Q(int l) const noexcept {
  const std::int64_t slot = basis_->view().id[l];
  return slot < 0 ? nullptr : slot_Q(slot);
}

}  // namespace raygauge
