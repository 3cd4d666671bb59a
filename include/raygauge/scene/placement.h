// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// The most dimensions a scene may have: 2 and 3 for bodies that move, 6 for wrenches.
inline constexpr int kMostSceneDimensions = 6;

/// Vectors and matrices of at most six rows, which need no heap.
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostSceneDimensions, 1>;
using SmallMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostSceneDimensions, kMostSceneDimensions>;

/// x ↦ R x + t: where a body stands, R its rotation and t the place of its origin.
struct Placement {
  SmallMatrix R;
  SmallVector t;

  static Placement identity(int n);

  int dimension() const noexcept { return static_cast<int>(t.size()); }

  /// First `inner`, then this.
  Placement operator*(const Placement& inner) const;
};

/// The placement with these. Throws DimensionMismatchError, NonFiniteError, or InvalidParameterError unless
/// RᵀR = 1 to 1e-9 and det R = 1. What RᵀR is off by is then removed.
Placement make_placement(const Eigen::Ref<const Eigen::MatrixXd>& R, const ConstVectorRef& t);

/// The rotation of 3-space by |r| radians about r.
SmallMatrix rotation_about(const Eigen::Vector3d& r);

/// The rotation of the plane by `angle` radians.
SmallMatrix plane_rotation(double angle);

/// R S + t, a set under a placement. A view: the set must outlive it; place() moves it without a copy.
class PlacedSet final : public ConvexSet {
 public:
  explicit PlacedSet(int dimension) : ConvexSet(dimension), where_(Placement::identity(dimension)) {}

  void place(const ConvexSet& S, const Placement& where) noexcept {
    S_ = &S;
    where_ = where;
  }

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  double do_inner_radius(const double* c) const override;
  SupportStructure do_structure() const noexcept override { return S_->structure(); }
  void do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const override;

  const ConvexSet* S_ = nullptr;
  Placement where_;
};

}  // namespace raygauge
