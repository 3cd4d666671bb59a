// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/growth_body.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/vector_kernels.h"
#include "raygauge/numerics/quad.h"

namespace raygauge {

GrowthBody::GrowthBody(const ConvexSet& A, const TwofoldPoint& c_A, const ConvexSet& Q,
                       const TwofoldPoint& c_Q, bool c_Q_in_Q)
    : MinkowskiView({.S = &Q, .T = &A, .sign = -1.0, .a = c_A, .b = c_Q}),
      c_A_(c_A.high),
      c_Q_(c_Q.high),
      c_Q_in_Q_(c_Q_in_Q) {}

void GrowthBody::do_center(double* point) const { std::fill_n(point, dimension(), 0.0); }

double GrowthBody::do_inner_radius(const double* c) const {
  const int n = dimension();
  Scratch around(n);
  double size = 0;
  for (int k = 0; k < n; ++k) {
    around.data()[k] = c_Q_[k] + c[k];
    size += std::fabs(c_Q_[k]) + std::fabs(c[k]) + std::fabs(c_A_[k]);
  }
  const double radius_Q = sum().S->inner_radius_unchecked(around.data());
  const double of_view = MinkowskiView::do_inner_radius(c);
  if (!c_Q_in_Q_ && !(radius_Q > 0)) return of_view;
  const double radius = sum().T->inner_radius_unchecked(c_A_) + radius_Q;
  // c_A is a point of A and c_Q one of Q, up to their rounding: one ball is enough if c is 0.
  const bool at_center = std::all_of(c, c + n, [](double x) { return x == 0; });
  return at_center ? std::max(of_view, proven_length(radius, size + radius, n)) : of_view;
}

void PosedCenter::assign(const Posed& S) {
  const int n = S.dimension();
  assign_origin(n);
  if (S.pose == nullptr) return S.set.center_unchecked(high_.data());
  local_.resize(static_cast<std::size_t>(n));
  S.set.center_unchecked(local_.data());
  const double* R = S.pose->rotation_data();
  for (int i = 0; i < n; ++i) {
    Quad sum = S.pose->translation_data()[i];
    for (int j = 0; j < n; ++j) {
      sum += Quad{R[static_cast<std::ptrdiff_t>(j) * n + i]} * local_[static_cast<std::size_t>(j)];
    }
    const auto at = static_cast<std::size_t>(i);
    high_[at] = static_cast<double>(sum);
    low_[at] = static_cast<double>(sum - high_[at]);
  }
}

void PosedCenter::assign_origin(int n) {
  high_.assign(static_cast<std::size_t>(n), 0.0);
  low_.assign(static_cast<std::size_t>(n), 0.0);
}

template <class Real>
void PointView::write(Real* point) const {
  const auto low = [](const Point& p, int k) { return p.low != nullptr ? Real{p.low[k]} : Real{0}; };
  for (int k = 0; k < dimension(); ++k) {
    point[k] = Real{p_.high[k]};
    if (from_.high != nullptr) point[k] -= from_.high[k];
    point[k] += low(p_, k) - low(from_, k);
  }
}

double PointView::do_support(const double* u, double* point) const {
  write(point);
  return dot(u, point, dimension());
}

void PointView::do_center(double* point) const { write(point); }

void PointView::do_magnitude(double* magnitude) const {
  for (int k = 0; k < dimension(); ++k)
    magnitude[k] = std::fabs(p_.high[k]) + (from_.high != nullptr ? std::fabs(from_.high[k]) : 0.0);
}

template <class Real>
void PointView::list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const {
  const int n = dimension();
  if (capacity < 1) return;
  write(pieces.point(0));
  pieces.value[0] = dot(u, pieces.point(0), n);
  std::fill_n(pieces.hessian(0), std::ptrdiff_t{n} * n, Real{0});
  pieces.count = 1;
}

void PointView::do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const {
  list_pieces(u, pieces, capacity);
}

void PointView::do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const {
  list_pieces(u, pieces, capacity);
}

}  // namespace raygauge
