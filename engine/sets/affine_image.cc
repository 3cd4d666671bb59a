// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/operations.h"

#include <cmath>
#include <string>
#include <utility>

#include "engine/numerics/decompositions.h"
#include "engine/sets/bounded_inverse.h"
#include "engine/sets/linear_image.h"
#include "engine/sets/parameters.h"
#include "raygauge/exceptions.h"
#include "raygauge/sets/pose.h"

namespace raygauge {
namespace {

// Rows, then columns are brought to magnitude 1: units of length say nothing about being singular.
bool is_singular(Eigen::MatrixXd M) {
  for (Eigen::Index i = 0; i < M.rows(); ++i) {
    const double largest = M.row(i).cwiseAbs().maxCoeff();
    if (largest == 0) return true;
    M.row(i) /= largest;
  }
  for (Eigen::Index j = 0; j < M.cols(); ++j) {
    const double largest = M.col(j).cwiseAbs().maxCoeff();
    if (largest == 0) return true;
    M.col(j) /= largest;
  }
  return !is_invertible(M);
}

// M and t, with `exchanges_axes` and `reverses_axes` from the entries of M.
LinearMap make_map(const double* M, const double* t, int n) noexcept {
  LinearMap map;
  map.n = n;
  map.M = M;
  map.t = t;
  map.exchanges_axes = map.reverses_axes = true;
  for (int i = 0; i < n; ++i) {
    int in_row = 0, in_column = 0;
    for (int j = 0; j < n; ++j) {
      const double entry = M[std::ptrdiff_t{i} * n + j];
      in_row += M[std::ptrdiff_t{j} * n + i] != 0 ? 1 : 0;
      in_column += entry != 0 ? 1 : 0;
      map.reverses_axes = map.reverses_axes && (entry == 0 || std::fabs(entry) == 1);
    }
    map.exchanges_axes = map.exchanges_axes && in_row == 1 && in_column == 1;
  }
  map.reverses_axes = map.reverses_axes && map.exchanges_axes;
  return map;
}

}  // namespace

AffineImage::AffineImage(std::shared_ptr<const ConvexSet> S, const Eigen::Ref<const Eigen::MatrixXd>& M,
                         const ConstVectorRef& t)
    : CombinedSet(checked_set("affine image", "S", S)->dimension()),
      S_(std::move(S)),
      M_(M),
      t_(checked_finite("affine image", "t", t)) {
  check_dimension("affine image", "a column of M", M_.rows(), dimension());
  check_dimension("affine image", "a row of M", M_.cols(), dimension());
  check_dimension("affine image", "t", t_.size(), dimension());
  check_finite_matrix("affine image", "M", M_);
  if (is_singular(M_)) throw InvalidParameterError("affine image: M must be invertible, but it is singular");
  inverse_ = std::make_shared<const BoundedInverse>(M_);
  LinearMap map = make_map(M_.data(), t_.data(), dimension());
  map.inverse = inverse_.get();
  set_view(std::make_unique<LinearImage>(*S_, map));
}

std::shared_ptr<const AffineImage> AffineImage::rigid(std::shared_ptr<const ConvexSet> S,
                                                      const Eigen::Ref<const Eigen::MatrixXd>& R,
                                                      const ConstVectorRef& t) {
  check_dimension("rigid image", "a column of R", R.rows(), static_cast<int>(t.size()));
  return std::make_shared<const AffineImage>(std::move(S), nearest_rotation("rigid image", R).R, t);
}

}  // namespace raygauge
