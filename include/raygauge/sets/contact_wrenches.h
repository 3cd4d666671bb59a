// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

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

}  // namespace raygauge
