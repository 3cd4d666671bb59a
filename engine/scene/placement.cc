// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/scene/placement.h"

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "raygauge/exceptions.h"
#include "raygauge/sets/pose.h"

namespace raygauge {
namespace {

// The orthogonal factor of a matrix near it, by a Newton-Schulz step, R (3 I - RᵀR) / 2: a defect d becomes 3
// d^2 / 4, below 1e-18 where make_placement() asks. (N. J. Higham, Functions of Matrices, 2008, Section 8.3.)
SmallMatrix nearest_rotation(const SmallMatrix& R) {
  const int n = static_cast<int>(R.rows());
  return R * (1.5 * SmallMatrix::Identity(n, n) - 0.5 * R.transpose() * R);
}

}  // namespace

Placement Placement::identity(int n) { return {SmallMatrix::Identity(n, n), SmallVector::Zero(n)}; }

SmallVector Placement::turned(const SmallVector& u) const {
  if (dimension() == 3) return Eigen::Matrix3d::Map(R.data()) * Eigen::Vector3d::Map(u.data());
  return R * u;
}

SmallVector Placement::turned_back(const SmallVector& u) const {
  if (dimension() == 3) return Eigen::Matrix3d::Map(R.data()).transpose() * Eigen::Vector3d::Map(u.data());
  return R.transpose() * u;
}

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
  return {nearest_rotation(R), t};
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

void PlacedSet::place(const ConvexSet& S, const Placement& where) noexcept {
  where_ = where;
  Map map = make_map(where_.R.data(), where_.t.data(), dimension());
  map.defect = Pose::defect_of(where_.R.data(), dimension());
  look_at(S, map);
}

}  // namespace raygauge
