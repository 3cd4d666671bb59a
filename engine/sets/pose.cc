// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/pose.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "engine/numerics/decompositions.h"
#include "engine/sets/parameters.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

constexpr double kOrthogonality = 1e-12;  // of RᵀR - 1: rounding
constexpr double kFewDigits = 1e-6;       // of an entry: printing

Eigen::Matrix3d rotation_of(const Eigen::Quaterniond& q) {
  if (!q.coeffs().allFinite()) throw NonFiniteError("pose: the quaternion is not finite");
  const double largest = q.coeffs().cwiseAbs().maxCoeff();
  if (largest == 0) throw InvalidParameterError("pose: the quaternion is zero, which is no rotation");
  const Eigen::Vector4d scaled = q.coeffs() / largest;
  return Eigen::Quaterniond(Eigen::Vector4d(scaled / scaled.norm())).toRotationMatrix();
}

int checked_dimension(int n) {
  if (n < 1) throw InvalidParameterError("pose: dimension must be at least 1, got " + std::to_string(n));
  return n;
}

bool exchanges_axes(const double* R, int n) {
  return std::all_of(R, R + std::ptrdiff_t{n} * n, [](double r) { return r == 0 || std::fabs(r) == 1; });
}

// The largest entry of RᵀR - 1, which times n bounds the spectral norm; a product of columns loses n + 2
// roundings. Not finite where R is not. N: n, or 0 where that is not known when compiled.
template <int N>
double largest_defect(const double* R, int given) {
  const int n = N > 0 ? N : given;
  double largest = 0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j <= i; ++j) {
      double product = i == j ? -1.0 : 0.0;
      for (int k = 0; k < n; ++k) product += R[i * n + k] * R[j * n + k];
      product = std::fabs(product);
      largest = product > largest || product != product ? product : largest;
    }
  }
  return largest;
}

[[noreturn]] void refuse_rotation(const std::string& name, const char* what, double number) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.3g", number);
  throw InvalidParameterError(name + ": the matrix is not a rotation: " + what + " by " + digits);
}

}  // namespace

// Newton-Schulz steps R (3 I - RᵀR) / 2: a defect d becomes 3 d²/4. (N. J. Higham, Functions of Matrices,
// 2008, Section 8.3.)
NearestRotation nearest_rotation(const std::string& name, const Eigen::Ref<const Eigen::MatrixXd>& R) {
  constexpr double kConverges = 0.1;
  constexpr int kSteps = 6;
  const Eigen::Index n = R.rows();
  check_dimension(name, "a row of R", R.cols(), static_cast<int>(n));
  check_finite_matrix(name, "R", R);
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(n, n);
  const double defect = (R.transpose() * R - one).cwiseAbs().maxCoeff();
  if (!(defect <= kConverges)) refuse_rotation(name, "RᵀR differs from 1", defect);
  if (lu_determinant(R) < 0) {
    throw InvalidParameterError(name +
                                ": the matrix is a reflection (its determinant is -1), not a rotation");
  }
  if (defect <= kOrthogonality) return {R, 0};
  Eigen::MatrixXd nearest = R;
  for (int k = 0; k < kSteps; ++k) nearest = nearest * (1.5 * one - 0.5 * nearest.transpose() * nearest);
  const double off = (R - nearest).cwiseAbs().maxCoeff();
  if (!(off <= kFewDigits)) refuse_rotation(name, "it differs from the nearest one", off);
  return {nearest, off};
}

Pose::Pose(int n) : dimension_(checked_dimension(n)) {
  const auto size = static_cast<std::size_t>(n);
  if (n > 3) large_.resize(size * size + size);
  for (int k = 0; k < n; ++k) rotation_data()[k * n + k] = 1;
}

Pose::Pose(const Eigen::Ref<const Eigen::MatrixXd>& R, const ConstVectorRef& t)
    : dimension_(checked_dimension(static_cast<int>(t.size()))) {
  assign(R, t);
}

Pose::Pose(const Eigen::Quaterniond& q, const Eigen::Vector3d& t) : dimension_(3) {
  assign(rotation_of(q), t);
}

Pose::Pose(const Eigen::Isometry3d& pose) : dimension_(3) { assign(pose.linear(), pose.translation()); }

Pose::Pose(const Eigen::Isometry2d& pose) : dimension_(2) { assign(pose.linear(), pose.translation()); }

void Pose::assign(const Eigen::Ref<const Eigen::MatrixXd>& R, const ConstVectorRef& t) {
  const int n = dimension_;
  if (R.rows() != n || R.cols() != n) {
    check_dimension("pose", "a column of R", R.rows(), n);
    check_dimension("pose", "a row of R", R.cols(), n);
  }
  const auto size = static_cast<std::size_t>(n);
  if (n > 3) large_.resize(size * size + size);
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) rotation_data()[j * n + i] = R(i, j);
  }
  std::copy_n(t.data(), n, translation_data());
  check();
}

void Pose::assign(const double* R, const double* t) {
  std::copy_n(R, dimension_ * dimension_, rotation_data());
  std::copy_n(t, dimension_, translation_data());
  check();
}

void Pose::assign_checked(const double* R, const double* t, double defect) noexcept {
  std::copy_n(R, dimension_ * dimension_, rotation_data());
  std::copy_n(t, dimension_, translation_data());
  defect_ = defect;
  axis_exchange_ = defect == 0;  // only then: see defect_of()
}

void Pose::check() {
  const int n = dimension_;
  measure();
  const double* t = translation_data();
  const bool is_finite = std::all_of(t, t + n, [](double t_k) { return std::isfinite(t_k); });
  // A defect that is no number comes from entries that are not finite.
  if (!is_finite) checked_finite("pose", "t", translation());
  replaced_ = 0;
  if (!(defect_ <= n * kOrthogonality)) return take_nearest_rotation();
  const double handedness = n == 2   ? Eigen::Matrix2d::Map(rotation_data()).determinant()
                            : n == 3 ? Eigen::Matrix3d::Map(rotation_data()).determinant()
                                     : lu_determinant(rotation());
  if (handedness < 0) {
    throw InvalidParameterError("pose: the matrix is a reflection (its determinant is -1), not a rotation");
  }
}

void Pose::take_nearest_rotation() {
  const NearestRotation nearest = nearest_rotation("pose", rotation());
  replaced_ = nearest.off;
  std::copy_n(nearest.R.data(), dimension_ * dimension_, rotation_data());
  measure();
}

double Pose::defect_of(const double* R, int n) noexcept {
  const double largest = n == 3 ? largest_defect<3>(R, 3) : largest_defect<0>(R, n);
  if (largest == 0 && exchanges_axes(R, n)) return 0;
  return n * (largest + 2 * (n + 2) * std::numeric_limits<double>::epsilon());
}

void Pose::measure() {
  axis_exchange_ = exchanges_axes(rotation_data(), dimension_);
  defect_ = defect_of(rotation_data(), dimension_);
}

Vector Pose::apply(const ConstVectorRef& x) const {
  check_dimension("pose", "x", x.size(), dimension_);
  checked_finite("pose", "x", x);
  return Eigen::MatrixXd::Map(rotation_data(), dimension_, dimension_) * x +
         Vector::Map(translation_data(), dimension_);
}

Pose Pose::after(const Pose& inner) const {
  check_dimension("pose", "inner pose", inner.dimension_, dimension_);
  return {rotation() * inner.rotation(), apply(inner.translation())};
}

Pose Pose::inverse() const {
  const Eigen::MatrixXd transpose = rotation().transpose();
  return {transpose, -(transpose * translation())};
}

}  // namespace raygauge
