// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>

#include "raygauge/numerics/dense.h"

namespace raygauge {

/// A linear map that brings a set of points into isotropic position: with the second moments
/// Σ = (1/N) Σ_i p_i p_iᵀ = F Fᵀ about the origin, those of the points F⁻¹ p_i are the identity.
struct IsotropicMap {
  DenseMatrix F;        ///< n × n, lower triangular
  DenseMatrix inverse;  ///< F⁻¹
};

/// The isotropic map of `points` (n × N; of a large set, of 4096 of them). Empty if the points are
/// nearly isotropic already (axes of F within a factor of 4), or if no reliable map exists: fewer than 2n
/// points, or flatter than 1e-6.
std::optional<IsotropicMap> isotropic_map(const Eigen::Ref<const Eigen::MatrixXd>& points);

}  // namespace raygauge
