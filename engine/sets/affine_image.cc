// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/affine_image.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "engine/numerics/vector_kernels.h"
#include "engine/sets/parameters.h"
#include "raygauge/exceptions.h"

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
  inverse_ = BoundedInverse(M_);
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

// M x, where x has its entries `stride` numbers apart.
template <class Real>
void AffineImage::map_linearly(const Real* x, int stride, Real* image) const noexcept {
  const int n = dimension();
  std::fill_n(image, n, Real{0});
  for (int j = 0; j < n; ++j) {
    const double* column = M_.col(j).data();
    for (int k = 0; k < n; ++k) image[k] += x[std::ptrdiff_t{j} * stride] * column[k];
  }
}

void AffineImage::map(const double* x, double* image) const noexcept {
  map_linearly(x, 1, image);
  for (int k = 0; k < dimension(); ++k) image[k] += t_[k];
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

// The ball around the preimage x0 of c, computed as x, is the ball around x less |x0 - x| = |M⁻¹(c - M x -
// t)|.
double AffineImage::do_inner_radius(const double* c) const {
  const int n = dimension();
  if (inverse_.inverse().size() == 0) return 0;
  Scratch x(n), image(n);
  for (int i = 0; i < n; ++i) {
    x.data()[i] = 0;
    for (int k = 0; k < n; ++k) x.data()[i] += inverse_.inverse()(i, k) * (c[k] - t_[k]);
  }
  map(x.data(), image.data());
  double rounding = 0;  // of the image
  for (int k = 0; k < n; ++k) {
    rounding += std::fabs(t_[k]) + std::fabs(c[k]);
    for (int j = 0; j < n; ++j) rounding += std::fabs(M_(k, j) * x.data()[j]);
  }
  rounding *= (n + 4) * std::numeric_limits<double>::epsilon();
  const double astray = inverse_.image_length(c, image.data()) + 2 * rounding / inverse_.least_stretch();
  const double radius = S_->inner_radius_unchecked(x.data()) - astray;
  return radius > 0 ? radius * inverse_.least_stretch() * (1 - 0x1p-50) : 0.0;
}

SupportStructure AffineImage::do_structure() const noexcept { return S_->structure(); }

template <class Real>
void AffineImage::list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const {
  const int n = dimension();
  BasicScratch<Real> direction(n), column(n);
  Real* v = column.data();
  for (int j = 0; j < n; ++j) direction.data()[j] = dot(M_.col(j).data(), u, n);
  S_->support_pieces_unchecked(direction.data(), pieces, SupportPieces::kCapacity - capacity);
  const Real shift = dot(u, t_.data(), n);
  for (int i = 0; i < pieces.count; ++i) {
    pieces.value[static_cast<std::size_t>(i)] += shift;
    map_linearly(pieces.point(i), 1, v);
    for (int k = 0; k < n; ++k) pieces.point(i)[k] = v[k] + t_[k];
    Real* H = pieces.hessian(i);  // becomes M H Mᵀ: columns first, then rows
    for (int j = 0; j < n; ++j) {
      map_linearly(H + std::ptrdiff_t{j} * n, 1, v);
      std::copy_n(v, n, H + std::ptrdiff_t{j} * n);
    }
    for (int j = 0; j < n; ++j) {
      map_linearly(H + j, n, v);
      for (int k = 0; k < n; ++k) H[std::ptrdiff_t{k} * n + j] = v[k];
    }
  }
}

void AffineImage::do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const {
  list_pieces(u, pieces, capacity);
}

void AffineImage::do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const {
  list_pieces(u, pieces, capacity);
}

// A direction u of the image is Mᵀu for S; a normal v of S is M⁻ᵀv for the image.
bool AffineImage::do_facet_normal(const double* u, const double* v, double* normal) const {
  const int n = dimension();
  if (inverse_.inverse().size() == 0) return false;
  Scratch from(n), to(n), inner(n);
  for (int j = 0; j < n; ++j) {
    from.data()[j] = dot(M_.col(j).data(), u, n);
    to.data()[j] = dot(M_.col(j).data(), v, n);
  }
  if (!S_->facet_normal_unchecked(from.data(), to.data(), inner.data())) return false;
  for (int k = 0; k < n; ++k) normal[k] = dot(inverse_.inverse().col(k).data(), inner.data(), n);
  return true;
}

// Nearest before the map, not after it.
void AffineImage::do_facet_point(const double* normal, const double* target, double* point) const {
  const int n = dimension();
  Scratch inner_normal(n), inner_target(n);
  for (int j = 0; j < n; ++j) {
    inner_normal.data()[j] = dot(M_.col(j).data(), normal, n);
    inner_target.data()[j] = 0;
    for (int k = 0; k < n; ++k) inner_target.data()[j] += inverse_.inverse()(j, k) * (target[k] - t_[k]);
  }
  S_->facet_point_unchecked(inner_normal.data(), inner_target.data(), point);
  std::copy_n(point, n, inner_target.data());
  map(inner_target.data(), point);
}

}  // namespace raygauge
