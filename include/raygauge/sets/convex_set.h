// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

#include "raygauge/numerics/dense.h"
#include "raygauge/numerics/quad.h"

namespace raygauge {

using ConstVectorRef = Eigen::Ref<const Eigen::VectorXd>;
using VectorRef = Eigen::Ref<Eigen::VectorXd>;

struct SpatialShape;

/// What is known of a support function beyond its values.
enum class SupportStructure : std::uint8_t {
  unknown,   ///< nothing
  point,     ///< the set is one point: it has what the other two have
  polytope,  ///< piecewise linear: support points are vertices, of which there are finitely many
  smooth,    ///< the maximum of a few twice differentiable pieces, which support_pieces_unchecked gives
};

/// What is known of the support function of a sum or a difference.
constexpr SupportStructure structure_of_sum(SupportStructure a, SupportStructure b) noexcept {
  if (a == b || b == SupportStructure::point) return a;
  return a == SupportStructure::point ? b : SupportStructure::unknown;
}

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

/// A nonempty compact convex set S in R^n, known through its support function and support mapping, equation
/// (6) of Zheng & Yamane:
///
///     h_S(u) = max_{x in S} u·x,      s_S(u) = a maximiser of u·x over S.
///
/// Assumptions stated here once, for every set: S is closed, bounded and nonempty; u need not be a unit
/// vector and may be zero (then h = 0 and any point of S is a maximiser); where several points maximise, any
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

  /// Writes the sizes m_k of the numbers that coordinate k of a support point is computed from, dimension()
  /// doubles: for c + r u/|u| that is |c_k| + r, however small the sum of the two may be. It is the scale of
  /// rounding errors,
  ///
  ///     |computed h(u) - h(u)| <= rounding_error(n) Σ_k |u_k| m_k,
  ///     each coordinate of the computed s(u) within rounding_error(n) m_k of that of a point of S.
  void magnitude_unchecked(double* magnitude) const { do_magnitude(magnitude); }

  /// R with {x : |x - c| <= R} inside S, proven, rounding errors of its computation included; 0 where nothing
  /// is known, as by default. It need not be the largest; it turns a residual into a bound: gauge_S(r) <=
  /// |r|/R for c = 0.
  double inner_radius_unchecked(const double* c) const { return do_inner_radius(c); }

  /// An upper bound on the gauge of S at x, min {t >= 0 : x in tS}, rounding errors included, and in `normal`
  /// the outer normal of tS at x, of any length; +infinity where the set has no formula for it, as by
  /// default.
  double gauge_unchecked(const double* x, double* normal) const { return do_gauge(x, normal); }

  /// The normal alone, in quadruple precision; false where the set has no formula. A direction to start from,
  /// good where Q is long and thin: for the centre of a homothet of Q, or for a point, it is the last one
  /// too.
  bool gauge_normal_unchecked(const Quad* x, Quad* normal) const { return do_quad_gauge_normal(x, normal); }

  /// True where it is proven, without a rounding error, that the origin is a point of S and its only one with
  /// u·x >= 0: the multiples of S fill no closed cone, and what has u·x >= 0 but not x = 0 is out of their
  /// reach. Writes u. False by default.
  bool touches_origin_unchecked(double* u) const { return do_touches_origin(u); }

  /// What fixed-size code needs of a set of R^2 or R^3; false for all others, and where there is none, as by
  /// default.
  bool spatial_shape_unchecked(SpatialShape& shape) const { return do_spatial_shape(shape); }

  SupportStructure structure() const noexcept { return do_structure(); }

  /// Second-order information at u != 0 for `smooth` sets; the greatest value is h_S(u). count = 0 where
  /// there is none. At most pieces.kCapacity - `used` pieces are written.
  void support_pieces_unchecked(const double* u, SupportPieces& pieces, int used = 0) const {
    pieces.count = 0;
    do_support_pieces(u, pieces, SupportPieces::kCapacity - used);
  }

  /// The same in quadruple precision, for what is left to prove where doubles end: values and gradients as
  /// above, with errors of rounding_error<Quad>(n). count = 0 where the set knows no more than doubles.
  void support_pieces_unchecked(const Quad* u, QuadSupportPieces& pieces, int used = 0) const {
    pieces.count = 0;
    do_quad_pieces(u, pieces, SupportPieces::kCapacity - used);
  }

  /// A `smooth` set may have flat faces, at whose normals its pieces have a kink. If the way from u to v
  /// passes near such a normal, writes it and returns true.
  bool facet_normal_unchecked(const double* u, const double* v, double* normal) const {
    return do_facet_normal(u, v, normal);
  }
  bool facet_normal_unchecked(const Quad* u, const Quad* v, Quad* normal) const {
    return do_quad_facet_normal(u, v, normal);
  }

  /// The point of the face across `normal`, one that facet_normal_unchecked gave, that is nearest to
  /// `target`.
  void facet_point_unchecked(const double* normal, const double* target, double* point) const {
    do_facet_point(normal, target, point);
  }
  void facet_point_unchecked(const Quad* normal, const Quad* target, Quad* point) const {
    do_quad_facet_point(normal, target, point);
  }

  /// True for a `smooth` set known to be unconditional about its centre c: with c + x it has every c +
  /// diag(±1, ..., ±1) x. Writes the extents e_k of its faces along the axes, for large p those of a
  /// p-norm ball, negative where rounding of c leaves none: if u_k = 0 and s is on the face across u, it is
  /// with any s_k in [c_k - e_k, c_k + e_k], but for less than a rounding error of Quad.
  bool is_unconditional_unchecked(double* extent) const { return do_is_unconditional(extent); }

  /// (2n + 8) rounding units: what a support function of R^n may lose, see magnitude_unchecked.
  template <class Real = double>
  static constexpr double rounding_error(int n) noexcept {
    return (2 * n + 8) * kRoundoff<Real>;
  }

 protected:
  /// Throws InvalidParameterError unless dimension >= 1.
  explicit ConvexSet(int dimension);

 private:
  virtual double do_support(const double* u, double* point) const = 0;
  virtual void do_center(double* point) const = 0;

  /// By default max |x_k| over S, from 2n support queries, and that of the centre: right where nothing larger
  /// than the set itself cancels.
  virtual void do_magnitude(double* magnitude) const;

  virtual double do_inner_radius(const double* c) const;
  virtual double do_gauge(const double* x, double* normal) const;
  virtual bool do_quad_gauge_normal(const Quad* x, Quad* normal) const;
  virtual bool do_touches_origin(double* u) const;
  virtual bool do_spatial_shape(SpatialShape& shape) const;
  virtual SupportStructure do_structure() const noexcept { return SupportStructure::unknown; }
  virtual void do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const;
  virtual bool do_facet_normal(const double* u, const double* v, double* normal) const;
  virtual void do_facet_point(const double* normal, const double* target, double* point) const;
  virtual bool do_is_unconditional(double* extent) const;
  virtual void do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const;
  virtual bool do_quad_facet_normal(const Quad* u, const Quad* v, Quad* normal) const;
  virtual void do_quad_facet_point(const Quad* normal, const Quad* target, Quad* point) const;

  int dimension_;
};

}  // namespace raygauge
