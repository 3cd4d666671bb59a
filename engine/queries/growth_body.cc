// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/growth_body.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/vector_kernels.h"
#include "engine/sets/set_sums.h"

namespace raygauge {

GrowthBody::GrowthBody(const ConvexSet& A, const double* c_A, const ConvexSet& Q, const double* c_Q,
                       bool c_Q_in_Q)
    : ConvexSet(A.dimension()), A_(A), Q_(Q), c_A_(c_A), c_Q_(c_Q), c_Q_in_Q_(c_Q_in_Q) {}

double GrowthBody::do_support(const double* u, double* point) const {
  const int n = dimension();
  Scratch a(n);
  double value = sum_support(Q_, A_, -1.0, u, point, a.data());
  for (int k = 0; k < n; ++k) {
    const double shift = c_A_[k] - c_Q_[k];
    value += u[k] * shift;
    point[k] += shift;
  }
  return value;
}

void GrowthBody::do_center(double* point) const { std::fill_n(point, dimension(), 0.0); }

void GrowthBody::do_magnitude(double* magnitude) const {
  const int n = dimension();
  sum_magnitude(Q_, A_, magnitude);
  for (int k = 0; k < n; ++k) magnitude[k] += 2 * (std::fabs(c_A_[k]) + std::fabs(c_Q_[k]));
}

double GrowthBody::do_inner_radius(const double* c) const {
  const int n = dimension();
  Scratch around(n);
  double size = 0;
  for (int k = 0; k < n; ++k) {
    around.data()[k] = c_Q_[k] + c[k];
    size += std::fabs(c_Q_[k]) + std::fabs(c[k]) + std::fabs(c_A_[k]);
  }
  const double radius_Q = Q_.inner_radius_unchecked(around.data());
  if (!c_Q_in_Q_ && !(radius_Q > 0)) return 0;
  const double radius = A_.inner_radius_unchecked(c_A_) + radius_Q;
  // c_A is a point of A and c_Q one of Q, up to their rounding: one ball is enough if c is 0.
  const bool at_center = std::all_of(c, c + n, [](double x) { return x == 0; });
  return at_center ? proven_length(radius, size + radius, n) : 0.0;
}

SupportStructure GrowthBody::do_structure() const noexcept {
  return structure_of_sum(A_.structure(), Q_.structure());
}

void GrowthBody::do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const {
  const int n = dimension();
  Scratch shift(n);
  for (int k = 0; k < n; ++k) shift.data()[k] = c_A_[k] - c_Q_[k];
  sum_pieces(Q_, A_, -1.0, u, pieces, capacity);
  const double along = dot(u, shift.data(), n);
  for (int i = 0; i < pieces.count; ++i) {
    pieces.value[static_cast<std::size_t>(i)] += along;
    for (int k = 0; k < n; ++k) pieces.point(i)[k] += shift.data()[k];
  }
}

double PointView::do_support(const double* u, double* point) const {
  std::copy_n(p_, dimension(), point);
  return dot(u, p_, dimension());
}

void PointView::do_center(double* point) const { std::copy_n(p_, dimension(), point); }

void PointView::do_magnitude(double* magnitude) const {
  for (int k = 0; k < dimension(); ++k) magnitude[k] = std::fabs(p_[k]);
}

void PointView::do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const {
  const int n = dimension();
  if (capacity < 1) return;
  pieces.value[0] = do_support(u, pieces.point(0));
  std::fill_n(pieces.hessian(0), n * n, 0.0);
  pieces.count = 1;
}

}  // namespace raygauge
