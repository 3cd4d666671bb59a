// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// The wrenches (f, p × f) in R^6 that one contact with Coulomb friction can exert at p, its normal force at
/// most 1:
///
///     {(f, p × f) : f = a (n + μ t), 0 <= a <= 1, t ⟂ n, |t| <= 1}.
///
///     h(u, v) = max{0, w·n + μ |w - (w·n) n|},      w = u + v × p.
///
/// With facets m >= 3 the disc of the t is replaced by the regular m-gon inside it, as linear programs need:
/// the set is then smaller. The hull of the union of several contacts bounds the sum of their normal forces
/// by 1, their Minkowski sum each force on its own.
class ContactWrenches final : public ConvexSet {
 public:
  /// n is normalised and points into the object that is held. facets = 0: the exact cone. Throws
  /// InvalidParameterError (n = 0, μ < 0, facets 1 or 2 or negative), DimensionMismatchError or
  /// NonFiniteError.
  ContactWrenches(const ConstVectorRef& p, const ConstVectorRef& n, double mu, double facets);

  const Eigen::Vector3d& point() const noexcept { return p_; }
  const Eigen::Vector3d& normal() const noexcept { return given_; }  ///< as it was given
  double friction() const noexcept { return mu_; }
  int facets() const noexcept { return facets_; }

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  SupportStructure do_structure() const noexcept override {
    return facets_ > 0 ? SupportStructure::polytope : SupportStructure::unknown;
  }

  Eigen::Vector3d p_, n_, first_, second_;  // n, first, second: orthonormal
  Eigen::Vector3d given_;
  double mu_;
  int facets_;
};

/// A hard finger with Coulomb friction: `normal` points into the object that is held, of any length but 0.
struct GraspContact {
  Eigen::Vector3d point, normal;
  double friction = 0;
};

/// What bounds the normal forces of a grasp.
enum class GraspForces : std::uint8_t {
  sum,   ///< they sum up to 1
  each,  ///< each is at most 1
};

/// The wrenches (f, p × f) in R^6, torques about the origin, that contacts can exert on an object. With the
/// wrenches of contact i at normal force 1,
///
///     W_i = {(f, p_i × f) : f = n_i + μ_i t, t ⟂ n_i, |t| <= 1},     h_i(u, v) = w·n_i + μ_i |w - (w·n_i)
///     n_i|
///
/// for w = u + v × p_i, it is conv(∪ W_i) for GraspForces::sum, h = max h_i, and the Minkowski sum of the
/// conv({0} ∪ W_i) for GraspForces::each, h = Σ max(0, h_i): the L1 and L∞ grasps of Ferrari & Canny (1992).
/// With edges k >= 3 each disc of t is replaced by the regular k-gon inside it: the set is then smaller.
///
/// The depth of the origin in it (DepthSolver) is the least wrench, by the metric, that the contacts cannot
/// resist. A depth above 0 is force closure. In conv(∪ W_i) the origin is inside if forces of any sum up to 1
/// could balance each other; where it is not, the depth is 0, for it is below a plane.
class GraspWrenches final : public ConvexSet {
 public:
  /// Throws EmptySetError (no contact), InvalidParameterError (a normal that is 0, μ < 0, 1, 2 or fewer than
  /// 0 edges, more than 10^6 of them) or NonFiniteError.
  explicit GraspWrenches(const std::vector<GraspContact>& contacts, GraspForces forces = GraspForces::sum,
                         int edges = 0);

  int contact_count() const noexcept { return static_cast<int>(cones_.size()); }
  GraspForces forces() const noexcept { return forces_; }
  int edges() const noexcept { return edges_; }

 private:
  struct Cone {
    Eigen::Vector3d p, n, first, second;  // n, first, second: orthonormal
    double friction;
  };

  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  SupportStructure do_structure() const noexcept override {
    return edges_ > 0 ? SupportStructure::polytope : SupportStructure::unknown;
  }

  Eigen::Vector3d force_at(const Cone& cone, double x, double y) const;

  std::vector<Cone> cones_;
  std::vector<Eigen::Vector2d> corners_;  // of the k-gon
  GraspForces forces_;
  int edges_;
};

}  // namespace raygauge
