// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/method.h"
#include "engine/methods/newton/power_steps.h"
#include "engine/methods/newton/quadratic_program.h"
#include "engine/methods/newton/sqp_oracle.h"
#include "engine/numerics/aligned_buffer.h"

namespace raygauge {

/// The ball of Q, about c and of radius R, that covers residuals. In quadruple precision c need not be the
/// origin, for targets moved by -δc.
template <class Real>
class ResidualBall {
 public:
  /// `rounding`: that of a point of A. False where Q knows of no such ball.
  bool choose(const ConvexSet& Q, Real rounding);

  /// δ: what covers the rounding errors of a combination, and little more.
  void enlarge_shift(Real rounding);

  double radius() const noexcept { return radius_; }
  Real shift() const noexcept { return shift_; }  ///< δ; 0 where c is the origin
  const double* center() const noexcept { return center_.data(); }

  /// The support function of A - δc at u, from that of A.
  Real shifted(Real value, const Real* u, int n) const;

 private:
  double radius_ = 0;
  Real shift_ = 0;
  AlignedBuffer<double> center_;
};

/// The method `newton`: sequential quadratic programming on the dual
///
///     d_Q(A) = max_u -h_A(u) / h_Q(-u),
///
/// for sets that are maxima of smooth pieces (ConvexSet::structure). At u with ratio ρ one step d minimises
/// the second-order model of φ(u) = h_A(u) + ρ h_Q(-u), which is zero at u and negative wherever the ratio is
/// larger (Dinkelbach); steps that do not raise the ratio are shortened. Convergence is quadratic, across
/// edges where several pieces meet too. Where a step passes the normal of a flat face, that normal is tried.
/// Sets whose support points answer to u as powers do have steps of their own (PowerSteps).
///
/// Certificates at every u: the ratio itself, rounded down, and with the weights α, β of the pieces
///
///     d <= ρ + |Σ α_i s_i - ρ Σ β_j s_j| / R,      R the radius of a ball around 0 in Q,
///
/// rounding errors of the sets and of the sum added to the residual. In quadruple precision (Real = Quad)
/// this gives certificates where those errors are too large for doubles: long thin sets, powers, many
/// dimensions. There Q may also have the origin on its boundary: the target of A is moved by -δc, c the
/// centre of Q and δ tiny, and where |r| <= δR, R the radius of a ball around c in Q, d <= ρ + δ. From a
/// start with h_A(u) >= 0 the ratio -a_c·u / (h_A(u) - a_c·u + h_Q(-u)) of the growth distance (8) leads to
/// where h_A(u) < 0.
template <class Real>
class Newton : public Method {
 public:
  bool solve(const Problem& problem, DistanceResult& result) override;
  Bounds bounds() const override { return bounds_; }
  void write(DistanceStatus status, Effects effects, DistanceResult& result) override;
  DistanceCounters counters() const override;
  void contact_combination(WeightedPoints& combination) const override;

  /// The direction of the last solve's lower bound; nullptr where that is 0.
  const double* direction() const noexcept { return bounds_.lower() > 0 ? normal_.data() : nullptr; }

 private:
  struct Point {
    PieceList<Real> A, Q;
    AlignedBuffer<Real> u;
    Real ratio = 0;  ///< of the phase: of `newton` or of the growth distance
  };

  bool begin(const Problem& problem);
  void choose_start(const ConvexSet& Q);
  Real coordinate_rounding(Real ratio) const;
  Real ratio_of(const Point& point) const;
  bool evaluate(Point& point);
  void bound_by_ratio(const Point& point);
  void bound_by_weights();
  typename QuadraticProgram<Real>::Objective objective();
  const Real* leave_facet();
  void move(const Real* step, Real share, bool flat);
  void set_growing(bool growing);
  bool advance(const Real* step, const Stopwatch& stopwatch);
  bool try_facet(const Real* step);
  void choose_facet_point(bool of_A);
  bool shares_facet();
  void choose_facet_point_near_center();
  bool accepts(const Point& candidate) const;
  void keep(bool weights);
  DistanceStatus iterate(const Stopwatch& stopwatch);

  int n_ = 0;
  Goal goal_;
  std::int64_t max_evaluations_ = 0;
  std::int64_t evaluations_ = 0;
  std::int64_t witness_evaluations_ = 0;
  SqpOracle<Real> oracle_A_, oracle_Q_;
  QuadraticProgram<Real> program_;
  Point points_[2];
  Point* now_ = nullptr;
  Point* next_ = nullptr;
  bool growing_ = false;  // still in search of h_A(u) < 0
  int facets_tried_ = 0;
  bool keeps_combination_ = false;
  WeightedPoints combination_;
  ResidualBall<Real> ball_;
  Bounds bounds_;
  double estimate_ = 0;    // the ratio that the lower one is, rounded down
  Real residual_ = 0;      // |r|, r = Σ α s - δc - ρ Σ β s at now_
  bool on_facet_ = false;  // now_ is the normal of a flat face
  bool unconditional_ = false;
  bool graded_ = false;    // BasicSupportPieces::graded
  PowerSteps<Real> pair_;  // where unconditional_
  AlignedBuffer<double> center_, normal_, contact_, point_;
  AlignedBuffer<Real> linear_, target_, residual_vector_, descent_;
};

}  // namespace raygauge
