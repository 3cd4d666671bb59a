// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

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

}  // namespace raygauge
