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

// The multiple of y nearest to x - δc: ρ itself is the less certain the smaller h_Q(-u) is.
template <class Real>
Real projected_ratio(const Real* x, const Real* y, const ResidualBall<Real>& ball, int n) {
  Real product = 0;
  for (int k = 0; k < n; ++k) product += (x[k] - ball.shift() * ball.center()[k]) * y[k];
  return product / dot(y, y, n);
}

double up(double x) { return x; }
double up(Quad x) { return rounded_up(x); }

}  // namespace

// The combinations x of A and y of Q with the weights of the step leave r = x - δc - ρy, if ρ >= 0:
// x = ρy + r costs no more than ρ + gauge_Q(r), x = ρy + δ(c + r/δ) no more than ρ + δ.
template <class Real>
void Newton<Real>::bound_by_weights() {
  const Real shift = ball_.shift();
  Real* x = target_.data();
  Real* y = linear_.data();
  const Real size_A = combine(now_->A, x);
  const Real size_Q = combine(now_->Q, y);
  const Real ratio = shift > 0 ? projected_ratio(x, y, ball_, n_) : now_->ratio;
  if (!(ratio >= 0)) return;
  Real size = size_A + ratio * size_Q;
  for (int k = 0; k < n_; ++k) {
    const Real shift_k = shift * ball_.center()[k];
    residual_vector_[static_cast<std::size_t>(k)] = x[k] - ratio * y[k] - shift_k;
    size += elementary::fabs(shift_k);
  }
  residual_ = length(residual_vector_.data(), n_);
  const Real rounding = coordinate_rounding(ratio) +
                        (n_ + now_->A.active_count + now_->Q.active_count + 8) * 2 * kRoundoff<Real> * size;
  const Real cost = (residual_ + rounding) / ball_.radius();
  const Real upwards = 1 + (n_ + 16) * 2 * kRoundoff<Real>;
  if (shift > 0 && cost * upwards > shift) return;
  if (!bounds_.reduce_upper(up((ratio + (shift > 0 ? shift : cost)) * upwards))) return;
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
