// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/scene/motion.h"

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "raygauge/exceptions.h"
#include "raygauge/sets/pose.h"

namespace raygauge {

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
  if (!t.allFinite()) throw NonFiniteError("pose: a number is not finite");
  const SmallMatrix near = nearest_rotation("pose", R).R;
  return {near * (1.5 * SmallMatrix::Identity(n, n) - 0.5 * near.transpose() * near), t};
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

}  // namespace raygauge
