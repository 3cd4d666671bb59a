// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/column_generation/support_oracle.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/proof/certificate.h"
#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// The pieces of h_S(sign · u) at one u: values, points of S, and their weights in a combination. Real is
/// double or Quad, here and in what works with such lists.
template <class Real>
struct PieceList {
  int n = 0;
  int count = 0;
  bool curved = false;              ///< whether Hessians belong to it; those of a polytope are zero
  int best = 0;                     ///< the piece of greatest value
  bool warm = false;                ///< whether `weight` holds those of the step before
  BasicSupportValue<Real> support;  ///< h_S(sign · u)
  AlignedBuffer<Real> value, weight, points, hessians;
  AlignedBuffer<int> active;  ///< the pieces that carry weight, or may; the first is the reference
  int active_count = 0;

  const Real* point(int i) const noexcept { return points.data() + std::ptrdiff_t{i} * n; }
  Real* point(int i) noexcept { return points.data() + std::ptrdiff_t{i} * n; }
  const Real* hessian(int i) const noexcept { return hessians.data() + std::ptrdiff_t{i} * n * n; }
};

/// One set of a pair as a maximum of smooth pieces. A `smooth` set has its pieces at any u; a `polytope` is
/// known through the vertices met so far, which are remembered.
template <class Real>
class SqpOracle {
 public:
  /// `sign` is that of h_S(sign · u); S is asked through `pairs` if that is not null. False if the set has no
  /// pieces to offer.
  bool bind(const ConvexSet& S, double sign, const Kernels& kernels, SupportPairs* pairs = nullptr);

  /// One support query: the pieces at u. False where they are more than the set can list.
  bool evaluate(const Real* u, PieceList<Real>& list);

  /// Replaces the pieces at u, the normal of a flat face, by the point of that face nearest to `target`.
  void replace_by_facet_point(const Real* u, const Real* target, PieceList<Real>& list);

  /// FlatFaces::normal in terms of u.
  bool facet_normal(const Real* u, const Real* v, Real* normal);

  /// Whether Hessians are to be as BasicSupportPieces::graded says.
  void grade(bool graded) noexcept { graded_ = graded; }

  double coordinate_error() const noexcept { return coordinate_error_; }
  const ConvexSet& set() const noexcept { return *set_; }

 private:
  void evaluate_smooth(const Real* u, PieceList<Real>& list);
  void evaluate_polytope(const Real* u, PieceList<Real>& list);
  void remember(const double* vertex);
  void make_room(PieceList<Real>& list, int count);

  const ConvexSet* set_ = nullptr;
  const SmoothSupport* smooth_ = nullptr;  // capabilities of *set_
  const FlatFaces* flat_faces_ = nullptr;
  SupportPairs* pairs_ = nullptr;
  double sign_ = 1;
  int n_ = 0;
  bool curved_ = false;
  bool graded_ = false;
  SupportOracle vertices_;
  int remembered_ = 0;
  int next_ = 0;  // slot of the vertex to forget once all are taken
  double coordinate_error_ = 0;
  AlignedBuffer<double> memory_;
  AlignedBuffer<Real> direction_;
  AlignedBuffer<Real> other_;
  AlignedBuffer<double> nearest_;  // double precision: a direction near u, and the vertex there
  AlignedBuffer<double> vertex_;
  AlignedBuffer<double> magnitude_;
};

}  // namespace raygauge
