// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <utility>

#include "raygauge/numerics/dense.h"
#include "raygauge/numerics/quad.h"
#include "raygauge/sets/capabilities.h"

namespace raygauge {

using ConstVectorRef = Eigen::Ref<const Eigen::VectorXd>;
using VectorRef = Eigen::Ref<Eigen::VectorXd>;

struct SpatialShape;

/// What is known of a support function beyond its values.
enum class SupportStructure : std::uint8_t {
  unknown,   ///< nothing
  point,     ///< the set is one point: it has what the other two have
  polytope,  ///< piecewise linear: support points are vertices, of which there are finitely many
  smooth,    ///< the maximum of a few twice differentiable pieces, which ConvexSet::smooth gives
};

/// What is known of the support function of a sum or a difference.
constexpr SupportStructure structure_of_sum(SupportStructure a, SupportStructure b) noexcept {
  if (a == b || b == SupportStructure::point) return a;
  return a == SupportStructure::point ? b : SupportStructure::unknown;
}

/// A nonempty compact convex set S in R^n, known through its support function and support mapping, equation
/// (6) of Zheng & Yamane:
///
///     h_S(u) = max_{x in S} u·x,      s_S(u) = a maximiser of u·x over S.
///
/// Assumptions stated here once, for every set: S is closed, bounded and nonempty. u need not be a unit
/// vector and may be zero; then h = 0 and any point of S is a maximiser. Where several points maximise, any
/// one of them may be returned, but always the same one for the same u. Sets are immutable after construction
/// and may be shared between threads.
///
/// As the object A of a distance, no more is needed. As the gauge body Q, the origin should lie in the
/// interior of S; where it does not, the distance may be infinite (DistanceStatus::unreachable).
class ConvexSet {
 public:
  virtual ~ConvexSet() = default;
  ConvexSet(const ConvexSet&) = delete;
  ConvexSet& operator=(const ConvexSet&) = delete;

  /// n, the dimension of the space.
  int dimension() const noexcept { return dimension_; }

  /// h_S(u). Throws DimensionMismatchError or NonFiniteError.
  double support_function(const ConstVectorRef& u) const;

  /// s_S(u). Throws DimensionMismatchError or NonFiniteError.
  Vector support_mapping(const ConstVectorRef& u) const;

  /// A point deep inside S: the centre a_c of (7). It lies in S, and in the interior where S has one.
  Vector center() const;

  /// h_S(u), with s_S(u) written to `point`; both are arrays of dimension() doubles. The hot path: nothing is
  /// checked and nothing is allocated.
  double support_unchecked(const double* u, double* point) const { return do_support(u, point); }

  /// center() written to `point`, dimension() doubles; nothing is allocated.
  void center_unchecked(double* point) const { do_center(point); }

  /// Writes the sizes m_k of the numbers from which coordinate k of a support point is computed, dimension()
  /// doubles. For c + r u/|u| that is |c_k| + r, however small the sum of the two may be. It is the scale of
  /// rounding errors,
  ///
  ///     |computed h(u) - h(u)| <= rounding_error(n) Σ_k |u_k| m_k,
  ///     each coordinate of the computed s(u) within rounding_error(n) m_k of that of a point of S.
  void magnitude_unchecked(double* magnitude) const { do_magnitude(magnitude); }

  /// A radius R with {x : |x - c| <= R} inside S, proven, rounding errors of its computation included; 0, the
  /// default, where none is known. It need not be the largest. It turns a residual into a bound: gauge_S(r)
  /// <= |r|/R for c = 0.
  double inner_radius_unchecked(const double* c) const { return do_inner_radius(c); }

  SupportStructure structure() const noexcept { return do_structure(); }

  /// What fixed-size code needs of a set of R^2 or R^3; nullptr for all other sets.
  const SpatialShape* spatial_shape() const noexcept { return shape_.get(); }

  /// The optional capabilities, each nullptr where S does not have it, as by default. They live as long as S.
  const SmoothSupport* smooth() const noexcept { return do_smooth(); }
  const FlatFaces* flat_faces() const noexcept { return do_flat_faces(); }
  const GaugeFormula* gauge() const noexcept { return do_gauge_formula(); }
  const CoordinateSymmetry* symmetry() const noexcept { return do_symmetry(); }

  /// (2n + 8) rounding units: what a support function of R^n may lose, see magnitude_unchecked.
  template <class Real = double>
  static constexpr double rounding_error(int n) noexcept {
    return (2 * n + 8) * kRoundoff<Real>;
  }

 protected:
  /// Throws InvalidParameterError unless dimension >= 1.
  explicit ConvexSet(int dimension);

  /// What spatial_shape() is from now on: constructors set it.
  void set_spatial_shape(std::shared_ptr<const SpatialShape> shape) noexcept { shape_ = std::move(shape); }

 private:
  virtual double do_support(const double* u, double* point) const = 0;
  virtual void do_center(double* point) const = 0;

  /// By default max |x_k| over S, from 2n support queries, and that of the centre. This is right if no number
  /// larger than the set itself cancels.
  virtual void do_magnitude(double* magnitude) const;

  virtual double do_inner_radius(const double* c) const;
  virtual SupportStructure do_structure() const noexcept { return SupportStructure::unknown; }
  virtual const SmoothSupport* do_smooth() const noexcept { return nullptr; }
  virtual const FlatFaces* do_flat_faces() const noexcept { return nullptr; }
  virtual const GaugeFormula* do_gauge_formula() const noexcept { return nullptr; }
  virtual const CoordinateSymmetry* do_symmetry() const noexcept { return nullptr; }

  int dimension_;
  std::shared_ptr<const SpatialShape> shape_;
};

}  // namespace raygauge
