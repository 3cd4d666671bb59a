// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/sets/minkowski_view.h"
#include "raygauge/sets/pose.h"

namespace raygauge {

/// B = (Q - c_Q) - (A - c_A), the set that the rays of the growth distance are shot at: A and Q, each scaled
/// by σ about its own centre, meet if and only if c_A - c_Q is in σB. A view of two sets for the time of a
/// solve.
///
///     h(u) = h_Q(u) - u·c_Q + h_A(-u) + u·c_A,      s(u) = s_Q(u) - c_Q - s_A(-u) + c_A,      centre 0.
class GrowthBody final : public MinkowskiView {
 public:
  /// The sets must outlive the object, and so must the numbers of c_A and c_Q, points of theirs. `c_Q_in_Q`
  /// says whether c_Q is known to be a point of Q: the origin need not be.
  GrowthBody(const ConvexSet& A, const TwofoldPoint& c_A, const ConvexSet& Q, const TwofoldPoint& c_Q,
             bool c_Q_in_Q = true);

 private:
  void do_center(double* point) const override;
  double do_inner_radius(const double* c) const override;

  const double* c_A_;  // as rounded: the balls about them are smaller by more
  const double* c_Q_;
  bool c_Q_in_Q_;
};

/// R c + t, c the centre of a set in a pose, as an unevaluated sum of two doubles for each coordinate, with
/// an error of 2⁻¹⁰⁶ of its terms: what is rounded in it would show where needles are long.
class PosedCenter {
 public:
  void assign(const Posed& S);
  void assign_origin(int n);

  TwofoldPoint point() const noexcept { return {high_.data(), low_.data()}; }

 private:
  std::vector<double> high_, low_, local_;
};

/// {p - from}: a point as a set, seen where it stands. The difference is not rounded: its magnitude covers
/// that in doubles, and quadruple precision holds it.
class PointView final : public ConvexSet, private SmoothSupport {
 public:
  using Point = TwofoldPoint;
  PointView(const Point& p, int n, const Point& from = {}) : ConvexSet(n), p_(p), from_(from) {}

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  SupportStructure do_structure() const noexcept override { return SupportStructure::point; }
  const SmoothSupport* do_smooth() const noexcept override { return this; }
  void do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const override;
  void do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const override;

  template <class Real>
  void list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const;

  template <class Real>
  void write(Real* point) const;

  Point p_;
  Point from_;
};

}  // namespace raygauge
