// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

#include "raygauge/numerics/dense.h"
#include "raygauge/numerics/quad.h"

namespace raygauge {

// What a convex set may offer beyond its support mapping. A set has a capability if it derives from its class
// and returns itself where ConvexSet asks for it (do_smooth and the others); the methods do without those
// that are missing. Arrays are n numbers each. Nothing is checked and nothing is allocated. docs/sets.md says
// which combinator passes on which capability of its operands.

/// The smooth pieces h_i of a support function h(u) = max_i h_i(u) at one direction u: value h_i(u), gradient
/// (a point of S) and Hessian, n × n. A gradient's Hessian times u is zero, since h_i is homogeneous.
template <class Real>
struct BasicSupportPieces {
  static constexpr int kCapacity = 8;

  int dimension = 0;
  int count = 0;
  bool graded = false;  ///< wanted: Hessians of unconditional sets, with diagonals as large as they are
  std::array<Real, kCapacity> value{};
  Real* points = nullptr;    ///< room for kCapacity points, n numbers each
  Real* hessians = nullptr;  ///< room for kCapacity Hessians, n² numbers each

  Real* point(int i) const noexcept { return points + std::ptrdiff_t{i} * dimension; }
  Real* hessian(int i) const noexcept { return hessians + std::ptrdiff_t{i} * dimension * dimension; }

  /// The pieces from number `first` on, as a list of their own.
  BasicSupportPieces rest(int first) const noexcept {
    BasicSupportPieces view;
    view.dimension = dimension;
    view.graded = graded;
    view.points = point(first);
    view.hessians = hessian(first);
    return view;
  }
};

using SupportPieces = BasicSupportPieces<double>;
using QuadSupportPieces = BasicSupportPieces<Quad>;

/// Second-order information: what the method `newton` needs of a set.
class SmoothSupport {
 public:
  /// The pieces at u != 0; the greatest value is h_S(u). count = 0 where there is none. At most
  /// pieces.kCapacity - `used` pieces are written.
  void pieces(const double* u, SupportPieces& pieces, int used = 0) const {
    pieces.count = 0;
    do_support_pieces(u, pieces, SupportPieces::kCapacity - used);
  }

  /// The same in quadruple precision, for bounds that double precision cannot prove, with errors of
  /// rounding_error<Quad>(n). count = 0 where the set has double precision only, as by default.
  void pieces(const Quad* u, QuadSupportPieces& pieces, int used = 0) const {
    pieces.count = 0;
    do_quad_pieces(u, pieces, SupportPieces::kCapacity - used);
  }

 protected:
  ~SmoothSupport() = default;

 private:
  virtual void do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const = 0;
  virtual void do_quad_pieces(const Quad* /*u*/, QuadSupportPieces& /*pieces*/, int /*capacity*/) const {}
};

/// Flat faces of a `smooth` set, at whose normals its pieces have a kink.
class FlatFaces {
 public:
  /// If the way from u to v passes near the normal of a flat face, writes this normal and returns true. In
  /// quadruple precision false by default.
  bool normal(const double* u, const double* v, double* normal) const {
    return do_facet_normal(u, v, normal);
  }
  bool normal(const Quad* u, const Quad* v, Quad* normal) const { return do_quad_facet_normal(u, v, normal); }

  /// A point of the face across `normal`, which normal() returned: the nearest to `target` that the set
  /// finds.
  void point(const double* normal, const double* target, double* point) const {
    do_facet_point(normal, target, point);
  }
  void point(const Quad* normal, const Quad* target, Quad* point) const {
    do_quad_facet_point(normal, target, point);
  }

 protected:
  ~FlatFaces() = default;

 private:
  virtual bool do_facet_normal(const double* u, const double* v, double* normal) const = 0;
  virtual void do_facet_point(const double* normal, const double* target, double* point) const = 0;
  virtual bool do_quad_facet_normal(const Quad* /*u*/, const Quad* /*v*/, Quad* /*normal*/) const {
    return false;
  }
  virtual void do_quad_facet_point(const Quad* /*normal*/, const Quad* /*target*/, Quad* /*point*/) const {}
};

/// Formulas for the gauge min {t >= 0 : x in tS}. A set may have some of them only.
class GaugeFormula {
 public:
  /// An upper bound on the gauge of S at x, rounding errors included, and in `normal` the outer normal of tS
  /// at x, of any length; +infinity where there is no formula for it.
  double bound(const double* x, double* normal) const { return do_gauge(x, normal); }

  /// The normal alone, in quadruple precision; false where there is no formula. A first direction for
  /// newton where Q is long and thin: for the centre of a homothet of Q, or for a point, it is the optimal
  /// one.
  bool normal(const Quad* x, Quad* normal) const { return do_quad_gauge_normal(x, normal); }

  /// True where it is proven, without a rounding error, that the origin is the only point of S with u·x >= 0.
  /// Then no multiple of S contains a point x != 0 with u·x >= 0. Writes u.
  bool touches_origin(double* u) const { return do_touches_origin(u); }

 protected:
  ~GaugeFormula() = default;

 private:
  virtual double do_gauge(const double* /*x*/, double* /*normal*/) const {
    return std::numeric_limits<double>::infinity();
  }
  virtual bool do_quad_gauge_normal(const Quad* /*x*/, Quad* /*normal*/) const { return false; }
  virtual bool do_touches_origin(double* /*u*/) const { return false; }
};

/// A `smooth` set that is unconditional about its centre c: with c + x it has every c + diag(±1, ..., ±1) x.
/// Or a sum of which some summands are.
class CoordinateSymmetry {
 public:
  /// The extents e_k of its faces along the axes, as a p-norm ball of large p has them; negative where c is
  /// known too inexactly. If u_k = 0 and s is on the face across u, s stays on it for any s_k in [c_k - e_k,
  /// c_k + e_k], up to a rounding error of Quad. False if the set is not known to be unconditional.
  bool extents(double* extent) const { return do_is_unconditional(extent); }

  /// Of the unconditional summands at u: reach_k = Σ |s_k - c_k|, with s a support point and c the centre of
  /// each, and change_k = Σ |u_k H_kk|. Their support points vary with u_k as its power change_k / reach_k.
  /// False, the default, where the set knows of none.
  bool summands(const double* u, double* reach, double* change) const {
    return do_summands(u, reach, change);
  }

 protected:
  ~CoordinateSymmetry() = default;

 private:
  virtual bool do_is_unconditional(double* extent) const = 0;
  virtual bool do_summands(const double* /*u*/, double* /*reach*/, double* /*change*/) const { return false; }
};

using ConstVectorRef = Eigen::Ref<const Eigen::VectorXd>;

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

/// The set of a user's own support mapping: S = conv{s(u) : u in R^n}.
///
///     h(u) = u·s(u),      s(u) as the callable gives it.
class SupportMappingSet final : public ConvexSet {
 public:
  /// Writes s(u), n doubles, to `point`. It must give the same point for the same u, be safe to call from
  /// several threads at once, and accept u = 0; what it throws passes through the solver.
  using Mapping = std::function<void(const double* u, double* point)>;

  /// `center` is a point of S, in its interior if it has one; n is its size. The mapping is tried along ±e_k,
  /// to find gross mistakes early: throws InvalidParameterError (n < 1, empty callable, center beyond a
  /// support plane) or NonFiniteError.
  SupportMappingSet(const ConstVectorRef& center, Mapping mapping);

  const Mapping& mapping() const noexcept { return mapping_; }

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;

  Vector center_;
  Mapping mapping_;
};

}  // namespace raygauge
