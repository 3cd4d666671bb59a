// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/scene/placement.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

using Small = std::array<double, kMostSceneDimensions>;

// Rᵀu.
Small turned_back(const SmallMatrix& R, const double* u) {
  Small v{};
  for (Eigen::Index j = 0; j < R.cols(); ++j) {
    double sum = 0;
    for (Eigen::Index k = 0; k < R.rows(); ++k) sum += R(k, j) * u[k];
    v[static_cast<std::size_t>(j)] = sum;
  }
  return v;
}

// R x, where x has its entries `stride` numbers apart.
Small turned(const SmallMatrix& R, const double* x, Eigen::Index stride = 1) {
  Small y{};
  for (Eigen::Index k = 0; k < R.rows(); ++k) {
    double sum = 0;
    for (Eigen::Index j = 0; j < R.cols(); ++j) sum += R(k, j) * x[j * stride];
    y[static_cast<std::size_t>(k)] = sum;
  }
  return y;
}

}  // namespace

Placement Placement::identity(int n) { return {SmallMatrix::Identity(n, n), SmallVector::Zero(n)}; }

Placement Placement::operator*(const Placement& inner) const { return {R * inner.R, R * inner.t + t}; }

Placement make_placement(const Eigen::Ref<const Eigen::MatrixXd>& R, const ConstVectorRef& t) {
  const Eigen::Index n = t.size();
  if (R.rows() != n || R.cols() != n || n < 1 || n > kMostSceneDimensions) {
    throw DimensionMismatchError("pose: a rotation of " + std::to_string(R.rows()) + " x " +
                                 std::to_string(R.cols()) + " with a translation of " + std::to_string(n) +
                                 " numbers");
  }
  if (!R.allFinite() || !t.allFinite()) throw NonFiniteError("pose: a number is not finite");
  constexpr double kOrthogonality = 1e-9;  // what printing a rotation with 10 digits loses
  const double defect = (R.transpose() * R - Eigen::MatrixXd::Identity(n, n)).cwiseAbs().maxCoeff();
  if (defect > kOrthogonality) {
    throw InvalidParameterError("pose: the matrix is not a rotation: RᵀR differs from 1 by " +
                                std::to_string(defect));
  }
  if (R.determinant() < 0) throw InvalidParameterError("pose: the matrix is a reflection, not a rotation");
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(R, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {svd.matrixU() * svd.matrixV().transpose(), t};
}

SmallMatrix rotation_about(const Eigen::Vector3d& r) {
  const double angle = r.norm();
  if (angle == 0) return SmallMatrix::Identity(3, 3);
  return Eigen::AngleAxisd(angle, r / angle).toRotationMatrix();
}

SmallMatrix plane_rotation(double angle) {
  SmallMatrix R(2, 2);
  R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return R;
}

double PlacedSet::do_support(const double* u, double* point) const {
  Small x{};
  const Small v = turned_back(where_.R, u);
  double value = S_->support_unchecked(v.data(), x.data());
  const Small y = turned(where_.R, x.data());
  for (int k = 0; k < dimension(); ++k) {
    point[k] = y[static_cast<std::size_t>(k)] + where_.t[k];
    value += u[k] * where_.t[k];
  }
  return value;
}

void PlacedSet::do_center(double* point) const {
  Small x{};
  S_->center_unchecked(x.data());
  const Small y = turned(where_.R, x.data());
  for (int k = 0; k < dimension(); ++k) point[k] = y[static_cast<std::size_t>(k)] + where_.t[k];
}

// Twice: the products with R lose as much again as S does.
void PlacedSet::do_magnitude(double* magnitude) const {
  Small inner{};
  S_->magnitude_unchecked(inner.data());
  for (int k = 0; k < dimension(); ++k) {
    magnitude[k] = std::fabs(where_.t[k]);
    for (int j = 0; j < dimension(); ++j) {
      magnitude[k] += 2 * std::fabs(where_.R(k, j)) * inner[static_cast<std::size_t>(j)];
    }
  }
}

// R is orthogonal but for rounding: the preimage of c is off by less than 64 rounding units of what it is
// computed from, and lengths by as much.
double PlacedSet::do_inner_radius(const double* c) const {
  constexpr double kRounding = 64 * kRoundoff<double>;
  Small shifted{};
  double size = 0;
  for (int k = 0; k < dimension(); ++k) {
    shifted[static_cast<std::size_t>(k)] = c[k] - where_.t[k];
    size += std::fabs(c[k]) + std::fabs(where_.t[k]);
  }
  const Small x = turned_back(where_.R, shifted.data());
  const double radius = S_->inner_radius_unchecked(x.data());
  return std::max(0.0, radius * (1 - kRounding) - kRounding * size);
}

void PlacedSet::do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const {
  const int n = dimension();
  const Small v = turned_back(where_.R, u);
  S_->support_pieces_unchecked(v.data(), pieces, SupportPieces::kCapacity - capacity);
  double shift = 0;
  for (int k = 0; k < n; ++k) shift += u[k] * where_.t[k];
  for (int i = 0; i < pieces.count; ++i) {
    pieces.value[static_cast<std::size_t>(i)] += shift;
    const Small y = turned(where_.R, pieces.point(i));
    for (int k = 0; k < n; ++k) pieces.point(i)[k] = y[static_cast<std::size_t>(k)] + where_.t[k];
    double* H = pieces.hessian(i);  // becomes R H Rᵀ: columns first, then rows
    for (int j = 0; j < n; ++j) {
      const Small column = turned(where_.R, H + std::ptrdiff_t{j} * n);
      std::copy_n(column.data(), n, H + std::ptrdiff_t{j} * n);
    }
    for (int j = 0; j < n; ++j) {
      const Small row = turned(where_.R, H + j, n);
      for (int k = 0; k < n; ++k) H[std::ptrdiff_t{k} * n + j] = row[static_cast<std::size_t>(k)];
    }
  }
}

}  // namespace raygauge
