// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/affine_image.h"

#include <Eigen/LU>
#include <string>
#include <utility>

#include "engine/exceptions.h"
#include "engine/sets/parameters.h"
#include "engine/sets/vector_kernels.h"

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
  return !Eigen::FullPivLU<Eigen::MatrixXd>(M).isInvertible();
}

}  // namespace

AffineImage::AffineImage(std::shared_ptr<const ConvexSet> S, const Eigen::Ref<const Eigen::MatrixXd>& M,
                         const ConstVectorRef& t)
    : ConvexSet(checked_set("affine image", "S", S)->dimension()),
      S_(std::move(S)),
      M_(M),
      t_(checked_finite("affine image", "t", t)) {
  check_dimension("affine image", "a column of M", M_.rows(), dimension());
  check_dimension("affine image", "a row of M", M_.cols(), dimension());
  check_dimension("affine image", "t", t_.size(), dimension());
  check_finite_matrix("affine image", "M", M_);
  if (is_singular(M_)) throw InvalidParameterError("affine image: M must be invertible, but it is singular");
}

std::shared_ptr<const AffineImage> AffineImage::rigid(std::shared_ptr<const ConvexSet> S,
                                                      const Eigen::Ref<const Eigen::MatrixXd>& R,
                                                      const ConstVectorRef& t) {
  constexpr double kOrthogonality = 1e-12;
  auto image = std::make_shared<const AffineImage>(std::move(S), R, t);
  const Eigen::Index n = R.rows();
  const Eigen::MatrixXd defect = R.transpose() * R - Eigen::MatrixXd::Identity(n, n);
  if (defect.cwiseAbs().maxCoeff() > kOrthogonality) {
    throw InvalidParameterError(
        "rigid image: the columns of R must be orthonormal to 1e-12, they are so to " +
        std::to_string(defect.cwiseAbs().maxCoeff()));
  }
  if (R.determinant() < 0) {
    throw InvalidParameterError(
        "rigid image: R must be a rotation, but it is a reflection (its determinant is -1)");
  }
  return image;
}

void AffineImage::map(const double* x, double* image) const noexcept {
  const int n = dimension();
  std::copy_n(t_.data(), n, image);
  for (int j = 0; j < n; ++j) {
    const double* column = M_.col(j).data();
    for (int k = 0; k < n; ++k) image[k] += x[j] * column[k];
  }
}

double AffineImage::do_support(const double* u, double* point) const {
  const int n = dimension();
  Scratch direction(n), x(n);
  for (int j = 0; j < n; ++j) direction.data()[j] = dot(M_.col(j).data(), u, n);
  const double value = S_->support_unchecked(direction.data(), x.data());
  map(x.data(), point);
  return value + dot(u, t_.data(), n);
}

void AffineImage::do_center(double* point) const {
  Scratch x(dimension());
  S_->center_unchecked(x.data());
  map(x.data(), point);
}

void AffineImage::do_magnitude(double* magnitude) const {
  // Twice: the products with M lose as much again as S does.
  const int n = dimension();
  Scratch inner(n);
  S_->magnitude_unchecked(inner.data());
  for (int k = 0; k < n; ++k) {
    magnitude[k] = std::fabs(t_[k]);
    for (int j = 0; j < n; ++j) magnitude[k] += 2 * std::fabs(M_(k, j)) * inner.data()[j];
  }
}

}  // namespace raygauge
