// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What the weights of a step prove.
#include <algorithm>
#include <cmath>

#include "engine/methods/newton/newton.h"
#include "engine/numerics/vector_kernels.h"

namespace raygauge {
namespace {

// Σ weight_i s_i over the active pieces; returns Σ weight_i |s_i|₁, the scale of its rounding errors.
template <class Real>
Real combine(const PieceList<Real>& list, Real* point) {
  Real size = 0;
  std::fill_n(point, list.n, Real{0});
  for (int a = 0; a < list.active_count; ++a) {
    const int i = list.active[static_cast<std::size_t>(a)];
    const Real weight = list.weight[static_cast<std::size_t>(i)];
    for (int k = 0; k < list.n; ++k) {
      point[k] += weight * list.point(i)[k];
      size += weight * elementary::fabs(list.point(i)[k]);
    }
  }
  return size;
}

double up(double x) { return x; }
double up(Quad x) { return rounded_up(x); }

}  // namespace

// The multiple of y nearest to x - δc: ρ itself is the less certain the smaller h_Q(-u) is.
template <class Real>
Real Newton<Real>::projected_ratio(const Real* x, const Real* y) const {
  Real product = 0;
  for (int k = 0; k < n_; ++k) product += (x[k] - shift_ * ball_center_[static_cast<std::size_t>(k)]) * y[k];
  return product / dot(y, y, n_);
}

// The combinations x of A and y of Q with the weights of the step leave r = x - δc - ρy, if ρ >= 0:
// x = ρy + r costs no more than ρ + gauge_Q(r), x = ρy + δ(c + r/δ) no more than ρ + δ.
template <class Real>
void Newton<Real>::bound_by_weights() {
  Real* x = target_.data();
  Real* y = linear_.data();
  const Real size_A = combine(now_->A, x);
  const Real size_Q = combine(now_->Q, y);
  const Real ratio = shift_ > 0 ? projected_ratio(x, y) : now_->ratio;
  if (!(ratio >= 0)) return;
  Real size = size_A + ratio * size_Q;
  for (int k = 0; k < n_; ++k) {
    const Real shift_k = shift_ * ball_center_[static_cast<std::size_t>(k)];
    residual_vector_[static_cast<std::size_t>(k)] = x[k] - ratio * y[k] - shift_k;
    size += elementary::fabs(shift_k);
  }
  residual_ = length(residual_vector_.data(), n_);
  const Real rounding =
      std::sqrt(n_) * (oracle_A_.coordinate_error() + ratio * oracle_Q_.coordinate_error()) +
      (n_ + now_->A.active_count + now_->Q.active_count + 8) * 2 * kRoundoff<Real> * size;
  const Real cost = (residual_ + rounding) / inner_radius_;
  const Real upwards = 1 + (n_ + 16) * 2 * kRoundoff<Real>;
  if (shift_ > 0 && cost * upwards > shift_) return;
  if (!bounds_.reduce_upper(up((ratio + (shift_ > 0 ? shift_ : cost)) * upwards))) return;
  for (int k = 0; k < n_; ++k) contact_[static_cast<std::size_t>(k)] = static_cast<double>(x[k]);
  if (!keeps_combination_) return;
  combination_.clear(n_);
  for (int a = 0; a < now_->A.active_count; ++a) {
    const int i = now_->A.active[static_cast<std::size_t>(a)];
    for (int k = 0; k < n_; ++k) {
      point_[static_cast<std::size_t>(k)] = static_cast<double>(now_->A.point(i)[k]);
    }
    combination_.add(point_.data(), static_cast<double>(now_->A.weight[static_cast<std::size_t>(i)]));
  }
}

template void Newton<double>::bound_by_weights();
template void Newton<Quad>::bound_by_weights();

}  // namespace raygauge
