// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "raygauge/sets/linear_image.h"

namespace raygauge {

/// {M x + t : x in S}, the image of S under an invertible affine map of R^n. See LinearImage for what it
/// keeps of S.
///
///     h(u) = h_S(Mᵀu) + u·t,      s(u) = M s_S(Mᵀu) + t,      centre M c_S + t.
class AffineImage final : public LinearImage {
 public:
  /// M is n × n. Throws InvalidParameterError (null pointer, or M singular: after its rows and columns are
  /// scaled, a pivot of its LU factors is below n ε of the largest), DimensionMismatchError or
  /// NonFiniteError.
  AffineImage(std::shared_ptr<const ConvexSet> S, const Eigen::Ref<const Eigen::MatrixXd>& M,
              const ConstVectorRef& t);

  /// The same for a rigid motion: the rotation is that of nearest_rotation(), which may throw.
  static std::shared_ptr<const AffineImage> rigid(std::shared_ptr<const ConvexSet> S,
                                                  const Eigen::Ref<const Eigen::MatrixXd>& R,
                                                  const ConstVectorRef& t);

  const std::shared_ptr<const ConvexSet>& S() const noexcept { return S_; }
  const DenseMatrix& M() const noexcept { return M_; }
  const Vector& t() const noexcept { return t_; }

 private:
  std::shared_ptr<const ConvexSet> S_;
  DenseMatrix M_;
  Vector t_;
  std::shared_ptr<const BoundedInverse> inverse_;  // of M
};

}  // namespace raygauge
