// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/posed_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/numerics/vector_kernels.h"
#include "engine/sets/parameters.h"
#include "engine/sets/set_sums.h"

namespace raygauge {

PosedView::PosedView(const ConvexSet& S, const Pose& pose) : ConvexSet(S.dimension()), S_(S), pose_(pose) {
  check_dimension("pose", "its rotation", pose.dimension(), S.dimension());
}

bool PosedView::is_translated() const noexcept {
  const double* t = pose_.translation_data();
  return !std::all_of(t, t + dimension(), [](double t_k) { return t_k == 0; });
}

// R x, where x has its entries `stride` numbers apart.
template <class Real>
void PosedView::turn(const Real* x, int stride, Real* image) const noexcept {
  const int n = dimension();
  std::fill_n(image, n, Real{0});
  for (int j = 0; j < n; ++j) {
    const double* column = pose_.rotation_data() + std::ptrdiff_t{j} * n;
    for (int k = 0; k < n; ++k) image[k] += x[std::ptrdiff_t{j} * stride] * column[k];
  }
}

// Rᵀu.
template <class Real>
void PosedView::turn_back(const Real* u, Real* inner) const noexcept {
  const int n = dimension();
  for (int j = 0; j < n; ++j) inner[j] = dot(u, pose_.rotation_data() + std::ptrdiff_t{j} * n, n);
}

double PosedView::do_support(const double* u, double* point) const {
  const int n = dimension();
  Scratch direction(n), x(n);
  turn_back(u, direction.data());
  const double value = S_.support_unchecked(direction.data(), x.data());
  turn(x.data(), 1, point);
  for (int k = 0; k < n; ++k) point[k] += pose_.translation_data()[k];
  return value + dot(u, pose_.translation_data(), n);
}

void PosedView::do_center(double* point) const {
  Scratch x(dimension());
  S_.center_unchecked(x.data());
  turn(x.data(), 1, point);
  for (int k = 0; k < dimension(); ++k) point[k] += pose_.translation_data()[k];
}

// Twice, as for AffineImage: the products with R lose as much again as S does.
void PosedView::do_magnitude(double* magnitude) const {
  const int n = dimension();
  Scratch inner(n);
  S_.magnitude_unchecked(inner.data());
  for (int k = 0; k < n; ++k) {
    magnitude[k] = std::fabs(pose_.translation_data()[k]);
    for (int j = 0; j < n; ++j) {
      magnitude[k] += 2 * std::fabs(pose_.rotation_data()[std::ptrdiff_t{j} * n + k]) * inner.data()[j];
    }
  }
}

// The preimage of c is Rᵀ(c - t) but for the defect and rounding, and R shrinks lengths by no more than the
// defect.
double PosedView::do_inner_radius(const double* c) const {
  const int n = dimension();
  Scratch shifted(n), x(n);
  double size = 0;
  for (int k = 0; k < n; ++k) {
    shifted.data()[k] = c[k] - pose_.translation_data()[k];
    size += std::fabs(c[k]) + std::fabs(pose_.translation_data()[k]);
  }
  turn_back(shifted.data(), x.data());
  const double astray = 2 * (pose_.defect() + 2 * (n + 4) * std::numeric_limits<double>::epsilon()) * size;
  const double radius = S_.inner_radius_unchecked(x.data()) - astray;
  return radius > 0 ? radius * (1 - pose_.defect()) * (1 - 0x1p-50) : 0.0;
}

// gauge(R⁻¹x) <= gauge(Rᵀx) + |R⁻¹x - Rᵀx|/R_S, R_S the radius of a ball around the origin inside S.
double PosedView::do_gauge(const double* x, double* normal) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const int n = dimension();
  if (is_translated()) return kInfinity;
  Scratch inner(n), inner_normal(n);
  turn_back(x, inner.data());
  const double gauge = S_.gauge_unchecked(inner.data(), inner_normal.data());
  if (!(gauge < kInfinity)) return kInfinity;
  turn(inner_normal.data(), 1, normal);
  if (pose_.is_axis_exchange()) return gauge;
  std::fill_n(inner_normal.data(), n, 0.0);
  const double radius = S_.inner_radius_unchecked(inner_normal.data());
  if (!(radius > 0)) return kInfinity;
  const double astray =
      2 * (pose_.defect() + (n + 4) * std::numeric_limits<double>::epsilon()) * length(x, n) * (1 + 0x1p-50);
  return (gauge + astray / radius) * (1 + 0x1p-50);
}

bool PosedView::do_quad_gauge_normal(const Quad* x, Quad* normal) const {
  if (is_translated()) return false;
  BasicScratch<Quad> inner(dimension()), inner_normal(dimension());
  turn_back(x, inner.data());
  if (!S_.gauge_normal_unchecked(inner.data(), inner_normal.data())) return false;
  turn(inner_normal.data(), 1, normal);
  return true;
}

// Without a rounding error only where R exchanges axes.
bool PosedView::do_touches_origin(double* u) const {
  if (!pose_.is_axis_exchange() || is_translated()) return false;
  Scratch inner(dimension());
  if (!S_.touches_origin_unchecked(inner.data())) return false;
  turn(inner.data(), 1, u);
  return true;
}

bool PosedView::do_is_unconditional(double* extent) const {
  const int n = dimension();
  if (!pose_.is_axis_exchange()) return false;
  Scratch inner(n), center(n);
  if (!S_.is_unconditional_unchecked(inner.data())) return false;
  for (int j = 0; j < n; ++j) {
    const double* column = pose_.rotation_data() + std::ptrdiff_t{j} * n;
    for (int k = 0; k < n; ++k) {
      if (column[k] != 0) extent[k] = inner.data()[j];
    }
  }
  S_.center_unchecked(inner.data());
  turn(inner.data(), 1, center.data());
  for (int k = 0; k < n; ++k) extent[k] -= rounding_of_sum(center.data()[k], pose_.translation_data()[k]);
  return true;
}

template <class Real>
void PosedView::list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const {
  const int n = dimension();
  BasicScratch<Real> direction(n), column(n);
  Real* v = column.data();
  turn_back(u, direction.data());
  // A Hessian that is graded along S's axes is not along others.
  pieces.graded = pieces.graded && pose_.is_axis_exchange();
  S_.support_pieces_unchecked(direction.data(), pieces, SupportPieces::kCapacity - capacity);
  const Real shift = dot(u, pose_.translation_data(), n);
  for (int i = 0; i < pieces.count; ++i) {
    pieces.value[static_cast<std::size_t>(i)] += shift;
    turn(pieces.point(i), 1, v);
    for (int k = 0; k < n; ++k) pieces.point(i)[k] = v[k] + pose_.translation_data()[k];
    Real* H = pieces.hessian(i);  // becomes R H Rᵀ: columns first, then rows
    for (int j = 0; j < n; ++j) {
      turn(H + std::ptrdiff_t{j} * n, 1, v);
      std::copy_n(v, n, H + std::ptrdiff_t{j} * n);
    }
    for (int j = 0; j < n; ++j) {
      turn(H + j, n, v);
      for (int k = 0; k < n; ++k) H[std::ptrdiff_t{k} * n + j] = v[k];
    }
  }
}

void PosedView::do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const {
  list_pieces(u, pieces, capacity);
}

void PosedView::do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const {
  list_pieces(u, pieces, capacity);
}

// A normal v of S is R⁻ᵀv here. R⁻ᵀ = R (3 - RᵀR)/2 but for the square of the defect.
template <class Real>
bool PosedView::find_facet_normal(const Real* u, const Real* v, Real* normal) const {
  const int n = dimension();
  BasicScratch<Real> from(n), to(n), inner(n);
  turn_back(u, from.data());
  turn_back(v, to.data());
  if (!S_.facet_normal_unchecked(from.data(), to.data(), inner.data())) return false;
  turn(inner.data(), 1, normal);
  turn_back(normal, to.data());
  for (int k = 0; k < n; ++k) to.data()[k] = (3 * inner.data()[k] - to.data()[k]) / 2;
  turn(to.data(), 1, normal);
  return true;
}

// R⁻¹ = Rᵀ (3 - R Rᵀ)/2 likewise.
template <class Real>
void PosedView::find_facet_point(const Real* normal, const Real* target, Real* point) const {
  const int n = dimension();
  BasicScratch<Real> inner_normal(n), shifted(n), inner(n);
  turn_back(normal, inner_normal.data());
  for (int k = 0; k < n; ++k) shifted.data()[k] = target[k] - pose_.translation_data()[k];
  turn_back(shifted.data(), inner.data());
  turn(inner.data(), 1, point);
  for (int k = 0; k < n; ++k) shifted.data()[k] = (3 * shifted.data()[k] - point[k]) / 2;
  turn_back(shifted.data(), inner.data());
  S_.facet_point_unchecked(inner_normal.data(), inner.data(), point);
  std::copy_n(point, n, inner.data());
  turn(inner.data(), 1, point);
  for (int k = 0; k < n; ++k) point[k] += pose_.translation_data()[k];
}

bool PosedView::do_facet_normal(const double* u, const double* v, double* normal) const {
  return find_facet_normal(u, v, normal);
}

bool PosedView::do_quad_facet_normal(const Quad* u, const Quad* v, Quad* normal) const {
  return find_facet_normal(u, v, normal);
}

void PosedView::do_facet_point(const double* normal, const double* target, double* point) const {
  find_facet_point(normal, target, point);
}

void PosedView::do_quad_facet_point(const Quad* normal, const Quad* target, Quad* point) const {
  find_facet_point(normal, target, point);
}

}  // namespace raygauge
