// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// A rotation, and how far the matrix that it was made of is from it: the largest difference of an entry, and
/// 0 where the matrix itself is the rotation.
struct NearestRotation {
  DenseMatrix R;
  double off = 0;
};

/// The rotation that a matrix stands for: itself where RᵀR = 1 to 1e-12, else the nearest rotation, if no
/// entry is farther than 1e-6 from it: what printing with 6 digits loses. `name` is what an error calls the
/// matrix. Throws DimensionMismatchError (not square), NonFiniteError or InvalidParameterError.
NearestRotation nearest_rotation(const std::string& name, const Eigen::Ref<const Eigen::MatrixXd>& R);

/// A rigid motion x -> R x + t of R^n, the pose of a body in the world. The constructor checks it; queries do
/// not check it again. R is used as given where RᵀR = 1 to 1e-12: a set in this pose is {R x + t : x in S}
/// for the stored R and t. So a query makes no error where RᵀR differs from the identity by rounding. A
/// rotation with fewer digits is replaced by the nearest one, see nearest_rotation().
///
/// Poses of R^2 and R^3 hold their numbers inside; a pose of a larger space allocates when it is made.
class Pose {
 public:
  /// The identity of R^n. Throws InvalidParameterError unless n >= 1.
  explicit Pose(int n);

  /// Throws DimensionMismatchError (R not n × n for n = size of t), NonFiniteError, or InvalidParameterError
  /// where nearest_rotation() does.
  Pose(const Eigen::Ref<const Eigen::MatrixXd>& R, const ConstVectorRef& t);

  /// The rotation of q/|q|. Throws NonFiniteError, or InvalidParameterError for |q| = 0.
  Pose(const Eigen::Quaterniond& q, const Eigen::Vector3d& t);

  /// The same checks as for a matrix; implicit, as these are poses already.
  Pose(const Eigen::Isometry3d& pose);  // NOLINT(google-explicit-constructor)
  Pose(const Eigen::Isometry2d& pose);  // NOLINT(google-explicit-constructor)

  /// The pose with this R, n × n by columns, and this t, n numbers, in the same space; no allocation unless R
  /// is replaced. Throws as the constructors do; the pose must not be used after that.
  void assign(const double* R, const double* t);

  /// The same for numbers that a pose was made of before, when its defect() was `defect`: they are not
  /// checked again.
  void assign_checked(const double* R, const double* t, double defect) noexcept;

  int dimension() const noexcept { return dimension_; }

  /// R, n × n, by columns; t, n doubles.
  const double* rotation_data() const noexcept { return dimension_ <= 3 ? small_.data() : large_.data(); }
  const double* translation_data() const noexcept {
    return dimension_ <= 3 ? small_.data() + 9
                           : large_.data() + static_cast<std::ptrdiff_t>(dimension_) * dimension_;
  }
  DenseMatrix rotation() const { return DenseMatrix::Map(rotation_data(), dimension_, dimension_); }
  Vector translation() const { return Vector::Map(translation_data(), dimension_); }

  /// R x + t. Throws DimensionMismatchError or NonFiniteError.
  Vector apply(const ConstVectorRef& x) const;

  /// The pose x -> (*this)(inner(x)). Throws DimensionMismatchError.
  Pose after(const Pose& inner) const;

  /// x -> Rᵀ(x - t), the inverse, up to the defect.
  Pose inverse() const;

  /// An upper bound on ‖RᵀR - 1‖ in the spectral norm, rounding errors included.
  double defect() const noexcept { return defect_; }

  /// How far the matrix that was given is from R: NearestRotation::off.
  double replaced() const noexcept { return replaced_; }

  /// The defect of any R, n × n by columns.
  static double defect_of(const double* R, int n) noexcept;

  /// Whether R only exchanges axes and turns them about: all its entries are 0 and ±1.
  bool is_axis_exchange() const noexcept { return axis_exchange_; }

 private:
  double* rotation_data() noexcept { return dimension_ <= 3 ? small_.data() : large_.data(); }
  double* translation_data() noexcept {
    return dimension_ <= 3 ? small_.data() + 9
                           : large_.data() + static_cast<std::ptrdiff_t>(dimension_) * dimension_;
  }
  void assign(const Eigen::Ref<const Eigen::MatrixXd>& R, const ConstVectorRef& t);
  void check();
  void take_nearest_rotation();
  void measure();

  int dimension_;
  bool axis_exchange_ = true;
  double defect_ = 0;
  double replaced_ = 0;
  std::array<double, 12> small_{};  // R, then t, for n <= 3
  std::vector<double> large_;       // the same for n > 3
};

/// A set in a pose, for the time of a query: solve({A, pose_A}, {Q, pose_Q}). Nothing is copied; both must
/// outlive the call. A set without a pose is taken as it is.
struct Posed {
  Posed(const ConvexSet& S) : set(S) {}  // NOLINT(google-explicit-constructor): a set is a posed set
  Posed(const ConvexSet& S, const Pose& where) : set(S), pose(&where) {}

  const ConvexSet& set;
  const Pose* pose = nullptr;  ///< nullptr: the identity

  int dimension() const noexcept { return set.dimension(); }
};

}  // namespace raygauge
