// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/zheng_yamane/ray_set.h"

#include <algorithm>

#include "engine/methods/zheng_yamane/tuning.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

constexpr int kIterationsBetweenLooks = 64;  // at the clock, where they are over few points
constexpr std::ptrdiff_t kFewNumbers = 1 << 16;

}  // namespace

void RaySet::begin(SupportOracle& A, SupportOracle& Q, int n, const double* a_c, const Kernels& kernels) {
  A_ = &A;
  Q_ = &Q;
  n_ = n;
  kernels_ = &kernels;
  iterations_ = passes_ = 0;
  keeps_shortlists_ = A.keeps_shortlist() && Q.keeps_shortlist();
  const auto size = static_cast<std::size_t>(n), padded = static_cast<std::size_t>(padded_rows(n));
  center_.reserve(size);
  std::copy_n(a_c, n, center_.data());
  slots_.reserve(2 * size * (size + 1));
  column_.reserve(padded);
  std::fill_n(column_.data(), padded, 0.0);
}

double RaySet::best_candidate(const double* u, double enough) {
  if (!keeps_shortlists_) return query(u);
  if (shortlisted_-- > 0) {
    const double value = query_shortlists(u);
    if (value > enough + tuned::kRayWorthEntering * shortlist_excess_) return value;
  }
  A_->pass(u, 1.0);
  Q_->pass(u, -1.0);
  ++passes_;
  shortlisted_ = tuned::kShortlistQueries;
  const double value = query_shortlists(u);
  shortlist_excess_ = value - enough;
  return value > enough ? value : query(u);
}

double RaySet::query_shortlists(const double* u) {
  best_A_ = A_->query_shortlist(u, 1.0, room_A());
  best_Q_ = Q_->query_shortlist(u, -1.0, room_Q());
  ++iterations_;
  return support_of_candidate(u);
}

double RaySet::query(const double* u) {
  ++iterations_;
  ++passes_;
  if (A_->has_points() && Q_->has_points()) {
    const PricedPoints A = A_->points();
    const PricedPoints Q = Q_->points();
    BestVertex best = {center_.data(), eta_, room_A(), room_Q(), column_.data()};
    const double h_S = kernels_->best_vertex(&A, &Q, n_, u, &best);
    best_A_ = best.value_A;
    best_Q_ = best.value_Q;
    return h_S;
  }
  best_A_ = A_->query(u, 1.0, room_A());
  best_Q_ = Q_->query(u, -1.0, room_Q());
  return support_of_candidate(u);
}

double RaySet::verify(const double* u) {
  h_A_ = A_->verify(u, 1.0, best_A_, room_A());
  h_Q_ = Q_->verify(u, -1.0, best_Q_, room_Q());
  return support_of_candidate(u);
}

double RaySet::support_of_candidate(const double* u) {
  form_column(candidate_);
  double h_S = 0;
  for (int k = 0; k < n_; ++k) h_S += u[k] * column_[static_cast<std::size_t>(k)];
  return h_S;
}

const double* RaySet::form_column(std::int64_t slot) {
  const double* a = slot_A(slot);
  const double* q = slot_Q(slot);
  double* column = column_.data();
  for (int k = 0; k < n_; ++k) column[k] = a[k] - center_[static_cast<std::size_t>(k)] - eta_ * q[k];
  return column;
}

bool RaySet::is_overtaken(const double* u, double overtaking) {
  if (!(overtaking < kInfinity && best_A_ < 0 && -best_A_ >= overtaking * best_Q_)) return false;
  verify(u);
  return h_A_.value < 0 && -h_A_.value >= overtaking * h_Q_.value;
}

// A support query of a general set may be a linear program of its own.
int RaySet::between_looks() const {
  if (!A_->has_points() || !Q_->has_points()) return 1;
  const std::ptrdiff_t blocks = A_->points().block_count + Q_->points().block_count;
  return blocks * n_ * PointSet::kLanes < kFewNumbers ? kIterationsBetweenLooks : 1;
}

}  // namespace raygauge
