// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/ellipsoid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/numerics/vector_kernels.h"
#include "engine/sets/bounded_inverse.h"
#include "engine/sets/parameters.h"
#include "engine/sets/place_shape.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

// M⁻¹b or M⁻ᵀb in place of b, by Gaussian elimination with row exchanges; false for a singular M.
bool solve_in_quad(const DenseMatrix& M, bool transposed, Quad* b) {
  const auto n = static_cast<int>(M.rows());
  BasicScratch<Quad> rows(n * n);
  const auto entry = [&](int i, int j) -> Quad& { return rows.data()[i * n + j]; };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) entry(i, j) = transposed ? M(j, i) : M(i, j);
  }
  for (int p = 0; p < n; ++p) {
    int best = p;
    for (int i = p + 1; i < n; ++i) {
      if (elementary::fabs(entry(i, p)) > elementary::fabs(entry(best, p))) best = i;
    }
    if (entry(best, p) == 0) return false;
    std::swap_ranges(&entry(p, 0), &entry(p, 0) + n, &entry(best, 0));
    std::swap(b[p], b[best]);
    for (int i = p + 1; i < n; ++i) {
      const Quad factor = entry(i, p) / entry(p, p);
      for (int j = p; j < n; ++j) entry(i, j) -= factor * entry(p, j);
      b[i] -= factor * b[p];
    }
  }
  for (int p = n - 1; p >= 0; --p) {
    for (int j = p + 1; j < n; ++j) b[p] -= entry(p, j) * b[j];
    b[p] /= entry(p, p);
  }
  return true;
}

// Whether semi-axes are at right angles but for rounding, and of lengths that formulas may square.
bool has_right_angles(const Matrix3& axes) {
  constexpr double kRounding = 16 * 0x1p-53, kFlat = 1e-6, kSmallest = 1e-70, kLargest = 1e70;
  double least = kLargest, most = 0, widest = 0;
  for (const Vector3& axis : axes.column) {
    const double size = length(axis);
    least = std::min(least, size);
    most = std::max(most, size);
  }
  for (int i = 0; i < 3; ++i) {
    const Vector3 &a = axes.column[i], &b = axes.column[(i + 1) % 3];
    widest = std::max(widest, std::fabs(dot(a, b)) / (length(a) * length(b)));
  }
  return least > kFlat * most && least > kSmallest && most < kLargest && widest < kRounding;
}

}  // namespace

Ellipsoid::Ellipsoid(const ConstVectorRef& center, const Eigen::Ref<const Eigen::MatrixXd>& factor)
    : ConvexSet(static_cast<int>(center.size())),
      center_(checked_finite("ellipsoid", "center", center)),
      factor_(factor) {
  check_dimension("ellipsoid", "a column of factor", factor_.rows(), dimension());
  if (factor_.cols() < 1) throw InvalidParameterError("ellipsoid: factor needs at least one column");
  check_finite_matrix("ellipsoid", "factor", factor_);
  shape_ = factor_ * factor_.transpose();
  inverse_ = std::make_shared<const BoundedInverse>(factor_);
  const int n = dimension();
  SpatialShape shape;
  if (!place(shape, center_, n) || factor_.cols() != n) return;
  shape.kind = SpatialShape::Kind::ellipsoid;
  double square = 0;
  for (int j = 0; j < n; ++j) {
    shape.axis.column[j] = spatial(factor_.col(j), n);
    square += dot(shape.axis.column[j], shape.axis.column[j]);
  }
  shape.has_right_angles = n == 3 && has_right_angles(shape.axis);
  shape.inner_radius = inverse_->least_stretch() * (1 - 0x1p-50);
  shape.extent = length(shape.center) + std::sqrt(square);
  // The radii of curvature are at least σ²/σ', of the least and the largest half axis (Blaschke's theorem).
  if (n == 3 && square > 0)
    shape.rolling_radius = shape.inner_radius * (shape.inner_radius / std::sqrt(square)) * (1 - 0x1p-50);
  set_spatial_shape(std::make_shared<const SpatialShape>(shape));
}

template <class Real>
Real Ellipsoid::support(const Real* u, Real* point) const {
  const int n = dimension();
  const auto m = static_cast<int>(factor_.cols());
  BasicScratch<Real> scratch(m);
  Real* z = scratch.data();
  for (int j = 0; j < m; ++j) z[j] = dot(factor_.col(j).data(), u, n);
  const Real length = normalize(z, m, z);
  std::copy_n(center_.data(), n, point);
  for (int j = 0; j < m; ++j) {
    const double* column = factor_.col(j).data();
    for (int k = 0; k < n; ++k) point[k] += z[j] * column[k];
  }
  return dot(u, center_.data(), n) + length;
}

double Ellipsoid::do_support(const double* u, double* point) const { return support(u, point); }

void Ellipsoid::do_center(double* point) const { Vector::Map(point, dimension()) = center_; }

void Ellipsoid::do_magnitude(double* magnitude) const {
  const double columns = static_cast<double>(factor_.cols()) / dimension();
  Vector::Map(magnitude, dimension()) =
      center_.cwiseAbs() + std::max(1.0, columns) * factor_.cwiseAbs().rowwise().sum();
}

// With g = |L⁻¹(x - c)| < 1, every x + (1 - g) L z, |z| <= 1, is in the set.
double Ellipsoid::do_inner_radius(const double* x) const {
  const double shift = inverse_->image_length(x, center_.data());
  return shift < 1 ? (1 - shift) * inverse_->least_stretch() * (1 - 0x1p-50) : 0.0;
}

const GaugeFormula* Ellipsoid::do_gauge_formula() const noexcept {
  return factor_.cols() == dimension() && center_.isZero(0) ? this : nullptr;
}

// |L⁻¹x| around the origin, with the gradient L⁻ᵀL⁻¹x but for a factor.
bool Ellipsoid::do_quad_gauge_normal(const Quad* x, Quad* normal) const {
  const int n = dimension();
  BasicScratch<Quad> z(n);
  std::copy_n(x, n, z.data());
  if (!solve_in_quad(factor_, false, z.data())) return false;
  std::copy_n(z.data(), n, normal);
  return solve_in_quad(factor_, true, normal);
}

SupportStructure Ellipsoid::do_structure() const noexcept { return SupportStructure::smooth; }

template <>
double Ellipsoid::shape(int j, int k) const {
  return shape_(k, j);
}

// Doubles would leave nothing of a short axis beside a long one.
template <>
Quad Ellipsoid::shape(int j, int k) const {
  Quad sum = 0;
  for (Eigen::Index i = 0; i < factor_.cols(); ++i) sum += Quad{factor_(j, i)} * factor_(k, i);
  return sum;
}

// The Hessian of |Lᵀu| is (L Lᵀ - g gᵀ)/|Lᵀu|, g = L Lᵀu/|Lᵀu|.
template <class Real>
void Ellipsoid::list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const {
  if (capacity < 1) return;
  const int n = dimension();
  Real* point = pieces.point(0);
  pieces.value[0] = support(u, point);
  pieces.count = 1;
  const Real length = pieces.value[0] - dot(u, center_.data(), n);
  const Real curvature = length > 0 ? 1 / length : Real{0};
  Real* hessian = pieces.hessian(0);
  for (int j = 0; j < n; ++j) {
    const Real g_j = point[j] - center_[j];
    for (int k = 0; k < n; ++k) {
      hessian[j * n + k] = curvature * (shape<Real>(j, k) - (point[k] - center_[k]) * g_j);
    }
  }
}

void Ellipsoid::do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const {
  list_pieces(u, pieces, capacity);
}

void Ellipsoid::do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const {
  list_pieces(u, pieces, capacity);
}

}  // namespace raygauge
