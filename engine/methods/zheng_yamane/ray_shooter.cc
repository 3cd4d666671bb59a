// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/zheng_yamane/ray_shooter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/methods/zheng_yamane/tuning.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

constexpr double kZero = 1e-13;      // weight of artificial columns that is rounding noise
constexpr double kFeasible = 1e-11;  // how negative a weight may be after the vertices were moved
constexpr int kRayCostRaises = 14;
constexpr int kRayRepairs = 2;

}  // namespace

void RayShooter::begin(SupportOracle& A, SupportOracle& Q, int n, const double* a_c, const Kernels& kernels) {
  n_ = n;
  kernels_ = &kernels;
  warm_ = false;
  pivots_ = refactorisations_ = 0;
  set_.begin(A, Q, n, a_c, kernels);
  basis_ = &bases_[0];
  spare_ = &bases_[1];
  bases_[0].reset(n, kernels);
  bases_[1].reset(n, kernels);
}

// Artificial columns ±e_k at costs that make -a_c the first normal, scaled to h_S(u) = 1.
void RayShooter::start_cold() {
  Basis& basis = *basis_;
  pivots_ += basis.view().pivots;
  basis.reset(n_, *kernels_);
  BasisView& view = basis.view();
  raises_ = 0;
  set_.next_candidate_at(n_);
  double* u = view.y;
  double largest = 0;
  const double margin = n_ < tuned::kManyDimensionsOfRays ? tuned::kRayMarginOfFew : tuned::kRayMarginOfMany;
  for (int k = 0; k < n_; ++k) u[k] = -set_.center()[k];
  const double h_S = set_.query(u);
  const double length = h_S > 0 ? 1.0 / h_S : 1.0;
  for (int k = 0; k < n_; ++k) {
    u[k] *= length;
    largest = std::max(largest, std::fabs(u[k]));
  }
  for (int k = 0; k < n_; ++k) {
    const double b = -set_.center()[k];
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
bool RayShooter::move_vertices() {
  const BasisView& old = basis_->view();
  pivots_ += spare_->view().pivots;
  spare_->reset(n_, *kernels_);
  for (int i = 0; i < n_; ++i) {
    if (is_artificial(old.id[i])) return false;
    spare_->set_column(i, set_.form_column(old.id[i]), 1.0, old.id[i]);
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

// Brings the candidate column, of u·s = h_S, into the basis. False if rounding leaves no pivot.
bool RayShooter::enter_candidate(double h_S) {
  std::int64_t left = 0;
  BasisView& view = basis_->view();
  if (kernels_->pivot(&view, set_.column(), 1.0, 1.0 - h_S, set_.candidate(), false, &left) !=
      PivotResult::ok) {
    return false;
  }
  // The slot of the vertex that left takes the next candidate; artificial columns free one that was never
  // used.
  set_.next_candidate_at(left >= 0 ? left : -1 - left);
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

RayShooter::End RayShooter::shoot(double eta, double tolerance, double overtaking,
                                  std::int64_t max_iterations, const Stopwatch& stopwatch) {
  set_.move_to(eta);
  const bool kept = warm_ && (move_vertices() || eta >= eta_shot_);
  if (!kept) start_cold();
  warm_ = true;
  eta_shot_ = eta;
  int repairs = 0;
  int idle = 0;
  double least = basis_->view().objective;
  for (;;) {
    const BasisView& view = basis_->view();
    const std::int64_t passes = set_.passes();
    double h_S = set_.best_candidate(view.y, 1 + tolerance);
    sigma_ = view.objective;
    const bool out_of_iterations = set_.iterations() >= max_iterations;
    const bool out_of_time = set_.iterations() % set_.between_looks() == 0 && stopwatch.expired();
    if (h_S <= 1 + tolerance || out_of_iterations || out_of_time) h_S = set_.verify(view.y);
    if (set_.passes() > passes && set_.is_overtaken(view.y, overtaking)) return End::overtaken;
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

}  // namespace raygauge
