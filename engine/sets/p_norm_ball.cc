// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/p_norm_ball.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "engine/numerics/floating_point.h"
#include "engine/numerics/number_text.h"
#include "engine/numerics/vector_kernels.h"
#include "engine/sets/parameters.h"
#include "engine/sets/place_shape.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

double checked_exponent(double p) {
  if (std::isnan(p)) throw NonFiniteError("p-norm ball: p must be a number, got nan");
  if (p < 1) throw InvalidParameterError("p-norm ball: p must be at least 1, got " + shortest_text(p));
  return p;
}

// ‖v‖_∞, and v replaced by sign(v_k) e_k at the largest entry.
template <class Real>
Real unit_maximiser_1(Real* v, int n) {
  int best = 0;
  for (int k = 1; k < n; ++k) {
    if (elementary::fabs(v[k]) > elementary::fabs(v[best])) best = k;
  }
  const Real largest = v[best];
  std::fill_n(v, n, Real{0});
  if (largest != 0) v[best] = elementary::copysign(Real{1}, largest);
  return elementary::fabs(largest);
}

// ‖v‖_1, and v replaced by its signs.
template <class Real>
Real unit_maximiser_infinity(Real* v, int n) {
  Real sum = 0;
  for (int k = 0; k < n; ++k) {
    sum += elementary::fabs(v[k]);
    if (v[k] != 0) v[k] = elementary::copysign(Real{1}, v[k]);
  }
  return sum;
}

// ‖v‖_q, and v replaced by z. With S = Σ t_k^q: ‖v‖_q = max|v| S^(1/q) and |z_k| = t_k^(q-1) / S^(1/p), where
// no error of t_k is raised to a power: rounded t_k are those of another direction nearby, whose z has the
// p-norm 1 too.
template <class Real>
Real unit_maximiser(Real* v, int n, double p) {
  const Real largest = largest_magnitude(v, n);
  if (largest == 0) return 0;
  const Real q_minus_1 = 1 / (Real{p} - 1);
  Real sum = 0;
  for (int k = 0; k < n; ++k) {
    const Real t = elementary::fabs(v[k]) / largest;
    const Real power = elementary::pow(t, q_minus_1);
    sum += t * power;
    v[k] = elementary::copysign(power, v[k]);
  }
  const Real scale = elementary::pow(sum, 1 / Real{p});
  for (int k = 0; k < n; ++k) v[k] /= scale;
  return largest * elementary::pow(sum, (Real{p} - 1) / p);
}

}  // namespace

PNormBall::PNormBall(const ConstVectorRef& center, const ConstVectorRef& semi_axes, double p)
    : ConvexSet(static_cast<int>(center.size())),
      center_(checked_finite("p-norm ball", "center", center)),
      semi_axes_(semi_axes),
      p_(checked_exponent(p)) {
  check_dimension("p-norm ball", "semi_axes", semi_axes.size(), dimension());
  for (int k = 0; k < dimension(); ++k) {
    checked_nonnegative("p-norm ball", "coordinate " + std::to_string(k) + " of semi_axes", semi_axes_[k]);
  }
  const int n = dimension();
  SpatialShape shape;
  if (p_ != 2 || !place(shape, center_, n)) return;
  const bool round = (semi_axes_.array() == semi_axes_[0]).all();
  shape.kind = round ? SpatialShape::Kind::point : SpatialShape::Kind::ellipsoid;
  shape.axis.column[0].x = semi_axes_[0];
  shape.axis.column[1].y = semi_axes_[1];
  if (n == 3) shape.axis.column[2].z = semi_axes_[2];
  shape.radius = round ? semi_axes_[0] : 0.0;
  shape.inner_radius = semi_axes_.minCoeff();
  shape.extent = length(shape.center) + (round ? 0.0 : semi_axes_.norm());
  set_spatial_shape(std::make_shared<const SpatialShape>(shape));
}

template <class Real>
Real PNormBall::support(const Real* u, Real* point) const {
  const int n = dimension();
  for (int k = 0; k < n; ++k) point[k] = semi_axes_[k] * u[k];
  Real dual_norm = 0;
  if (p_ == 1) {
    dual_norm = unit_maximiser_1(point, n);
  } else if (p_ == 2) {
    dual_norm = normalize(point, n, point);
  } else if (p_ == std::numeric_limits<double>::infinity()) {
    dual_norm = unit_maximiser_infinity(point, n);
  } else {
    dual_norm = unit_maximiser(point, n, p_);
  }
  for (int k = 0; k < n; ++k) point[k] = center_[k] + semi_axes_[k] * point[k];
  return dot(u, center_.data(), n) + dual_norm;
}

double PNormBall::do_support(const double* u, double* point) const { return support(u, point); }

void PNormBall::do_center(double* point) const { Vector::Map(point, dimension()) = center_; }

void PNormBall::do_magnitude(double* magnitude) const {
  Vector::Map(magnitude, dimension()) = center_.cwiseAbs() + semi_axes_;
}

// With g = ‖(x - c)/w‖_p < 1, every x + (1 - g) diag(w) z, ‖z‖_p <= 1, is in the set; and |z| <= 1 in the
// Euclidean norm has ‖z‖_p <= 1 for p >= 2, <= n^(1/p - 1/2) below.
double PNormBall::do_inner_radius(const double* x) const {
  const int n = dimension();
  const double least = semi_axes_.minCoeff();
  if (!(least > 0)) return 0;
  Scratch shift(n), normal(n);
  for (int k = 0; k < n; ++k) shift.data()[k] = x[k] - center_[k];
  const double g = std::isinf(p_)
                       ? (Vector::Map(shift.data(), n).cwiseAbs().array() / semi_axes_.array()).maxCoeff()
                       : norm(shift.data(), normal.data());
  const double norm = p_ >= 2 ? 1.0 : std::pow(n, 1 / p_ - 0.5);
  const double left = 1 - g * (1 + 1e-12) - (n + 4) * std::numeric_limits<double>::epsilon();
  return left > 0 ? left * least / norm * (1 - 1e-12) : 0.0;
}

// ‖x/w‖_p around the origin, and its gradient but for a factor. Large p have normals whose small coordinates
// no number can hold, but a norm like any other: an error of t enters the sum p-fold, and is taken to the
// power 1/p with it.
template <class Real>
Real PNormBall::norm(const Real* x, Real* normal) const {
  const int n = dimension();
  for (int k = 0; k < n; ++k) normal[k] = x[k] / semi_axes_[k];
  const Real largest = largest_magnitude(normal, n);
  if (largest == 0) return 0;
  Real sum = 0;
  for (int k = 0; k < n; ++k) {
    const Real t = elementary::fabs(normal[k]) / largest;
    const Real power = elementary::pow(t, Real{p_} - 1);
    sum += t * power;
    normal[k] = elementary::copysign(power, normal[k]) / semi_axes_[k];
  }
  return largest * elementary::pow(sum, 1 / Real{p_});
}

bool PNormBall::is_smooth() const noexcept { return p_ > 1 && p_ < std::numeric_limits<double>::infinity(); }

bool PNormBall::has_gauge() const noexcept {
  return center_.isZero(0) && semi_axes_.minCoeff() > 0 && std::isfinite(p_);
}

double PNormBall::do_gauge(const double* x, double* normal) const {
  // Below the normal range a quotient has no relative error bound.
  for (int k = 0; k < dimension(); ++k) {
    if (x[k] != 0 && !std::isnormal(x[k] / semi_axes_[k])) return kInfinity;
  }
  return norm(x, normal) * (1 + (2 * dimension() + 16) * std::numeric_limits<double>::epsilon());
}

bool PNormBall::do_quad_gauge_normal(const Quad* x, Quad* normal) const { return norm(x, normal) > 0; }

SupportStructure PNormBall::do_structure() const noexcept {
  return is_smooth() ? SupportStructure::smooth : SupportStructure::polytope;
}

// Where t_k <= kLevel, z_k may be anything up to kLevel^(q-1), for no more than kLevel of S: a cube in all
// but name for large p.
bool PNormBall::do_is_unconditional(double* extent) const {
  constexpr double kLevel = 1e-40;  // far below the rounding errors of Quad
  const double share = std::pow(kLevel, 1 / (p_ - 1)) * (1 - 4 * std::numeric_limits<double>::epsilon());
  Vector::Map(extent, dimension()) = share * semi_axes_;
  return true;
}

// Of the Hessian below, u_k H_kk = (q - 1) g_k (1 - u_k g_k/N).
bool PNormBall::do_summands(const double* u, double* reach, double* change) const {
  const int n = dimension();
  support(u, reach);
  double norm = 0;
  for (int k = 0; k < n; ++k) {
    reach[k] -= center_[k];
    norm += u[k] * reach[k];
  }
  for (int k = 0; k < n; ++k) {
    change[k] = std::fabs(reach[k] * (1 - u[k] * reach[k] / norm)) / (p_ - 1);
    reach[k] = std::fabs(reach[k]);
  }
  return norm > 0;
}

// With v = diag(w) u, N = ‖v‖_q, t = |v|/N and g = diag(w) sign(v) t^(q-1), the gradient less c, the Hessian
// is (q - 1)/N (diag(w² t^(q-2)) - g gᵀ). Where u_k is not about zero w_k² t_k^(q-2) = N g_k/u_k, with N =
// g·u: so the Hessian of a ball with p near 1 takes u to zero in spite of q - 1 = 1/(p - 1).
template <class Real>
void PNormBall::list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const {
  if (capacity < 1) return;
  // Smaller t count as this one; for q < 2 the curvature at t = 0 is infinite.
  const double smallest = pieces.graded && p_ > 2 ? 1e-200 : 1e-10;
  const int n = dimension();
  Real* point = pieces.point(0);
  Real* hessian = pieces.hessian(0);
  pieces.value[0] = support(u, point);
  pieces.count = 1;
  Real norm = 0;
  for (int k = 0; k < n; ++k) norm += (point[k] - center_[k]) * u[k];
  const Real q_minus_1 = 1 / (Real{p_} - 1);
  const Real curvature = norm > 0 ? q_minus_1 / norm : Real{0};
  for (int j = 0; j < n; ++j) {
    const Real g_j = point[j] - center_[j], w_j = semi_axes_[j];
    for (int k = 0; k < n; ++k) hessian[j * n + k] = -curvature * g_j * (point[k] - center_[k]);
    const bool zero = !(elementary::fabs(w_j * u[j]) > smallest * norm);
    hessian[j * n + j] +=
        curvature * (zero ? w_j * w_j * elementary::pow(Real{smallest}, q_minus_1 - 1) : norm * g_j / u[j]);
  }
}

void PNormBall::do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const {
  list_pieces(u, pieces, capacity);
}

void PNormBall::do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const {
  list_pieces(u, pieces, capacity);
}

}  // namespace raygauge
