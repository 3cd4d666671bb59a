// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/ellipsoid.h"

#include "engine/exceptions.h"
#include "engine/sets/parameters.h"
#include "engine/sets/vector_kernels.h"

namespace raygauge {

Ellipsoid::Ellipsoid(const ConstVectorRef& center, const Eigen::Ref<const Eigen::MatrixXd>& factor)
    : ConvexSet(static_cast<int>(center.size())),
      center_(checked_finite("ellipsoid", "center", center)),
      factor_(factor) {
  check_dimension("ellipsoid", "a column of factor", factor_.rows(), dimension());
  if (factor_.cols() < 1) throw InvalidParameterError("ellipsoid: factor needs at least one column");
  check_finite_matrix("ellipsoid", "factor", factor_);
  shape_ = factor_ * factor_.transpose();
  inverse_ = BoundedInverse(factor_);
}

double Ellipsoid::do_support(const double* u, double* point) const {
  const int n = dimension();
  const auto m = static_cast<int>(factor_.cols());
  Scratch scratch(m);
  double* z = scratch.data();
  for (int j = 0; j < m; ++j) z[j] = dot(factor_.col(j).data(), u, n);
  const double length = normalize(z, m, z);
  std::copy_n(center_.data(), n, point);
  for (int j = 0; j < m; ++j) {
    const double* column = factor_.col(j).data();
    for (int k = 0; k < n; ++k) point[k] += z[j] * column[k];
  }
  return dot(u, center_.data(), n) + length;
}

void Ellipsoid::do_center(double* point) const { Vector::Map(point, dimension()) = center_; }

void Ellipsoid::do_magnitude(double* magnitude) const {
  const double columns = static_cast<double>(factor_.cols()) / dimension();
  Vector::Map(magnitude, dimension()) =
      center_.cwiseAbs() + std::max(1.0, columns) * factor_.cwiseAbs().rowwise().sum();
}

// With g = |L⁻¹(x - c)| < 1, every x + (1 - g) L z, |z| <= 1, is in the set.
double Ellipsoid::do_inner_radius(const double* x) const {
  const double shift = inverse_.image_length(x, center_.data());
  return shift < 1 ? (1 - shift) * inverse_.least_stretch() * (1 - 0x1p-50) : 0.0;
}

SupportStructure Ellipsoid::do_structure() const noexcept { return SupportStructure::smooth; }

// The Hessian of |Lᵀu| is (L Lᵀ - g gᵀ)/|Lᵀu|, g = L Lᵀu/|Lᵀu|.
void Ellipsoid::do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const {
  if (capacity < 1) return;
  const int n = dimension();
  double* point = pieces.point(0);
  pieces.value[0] = do_support(u, point);
  pieces.count = 1;
  const double length = pieces.value[0] - dot(u, center_.data(), n);
  const double curvature = length > 0 ? 1 / length : 0.0;
  double* hessian = pieces.hessian(0);
  for (int j = 0; j < n; ++j) {
    const double g_j = point[j] - center_[j];
    for (int k = 0; k < n; ++k) {
      hessian[j * n + k] = curvature * (shape_(k, j) - (point[k] - center_[k]) * g_j);
    }
  }
}

}  // namespace raygauge
