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

}  // namespace raygauge
