// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/method.h"
#include "engine/methods/spatial/contact_program.h"
#include "engine/sets/cores/core.h"
#include "raygauge/numerics/vector3.h"

namespace raygauge {

/// The method `newton` in fixed size, for two sets of R^3 out of balls, capsules, ellipsoids, cylinders and
/// truncated cones as they stand:
///
///     d_Q(A) = max_u -h_A(u) / h_Q(-u).
///
/// At u with ratio ρ the pieces of both support functions are known: the rims of a frustum, the ends of a
/// segment, or one. A step d across u minimises  max_ij (a_i + ρ q_j)·(u + d) + dᵀHd/2,  a_i and q_j the
/// points of the pieces and H their Hessians with the weights of the step before. Contacts within a disc have
/// its normal, which is tried once. The certificates are those of Newton: the ratio rounded down, and with
/// the weights w of the step
///
///     d <= ρ + |Σ w_ij (a_i - ρ q_j)| / R,      R the radius of a ball around 0 in Q,
///
/// the rounding errors of both sets outward.
class SpatialGauge : public Method {
 public:
  bool solve(const Problem& problem, DistanceResult& result) override;
  DistanceCounters counters() const override;

 private:
  // One of the sets with the points of its pieces that are highest for the direction last asked for.
  struct Side {
    const SpatialShape* shape = nullptr;
    Matrix3 form;      // of a curved core
    double error = 0;  // of a height, and of a point
    int count = 0;     // pieces
    Vector3 point[2];  // balls included
    double height[2] = {0, 0};
    CoreCurvature curvature[2];
    int top = 0;         // the higher piece
    bool tried = false;  // its discs

    bool bind(const ConvexSet& S);
    Matrix3 second_moment() const;
    void look(const Vector3& v);
    void add_hessian(int piece, double weight, const Vector3* tangents, double* h) const;
  };

  bool begin(const Problem& problem);
  Vector3 rough_normal() const;
  bool descend();
  void look(const Vector3& u);
  void gather(const Vector3* tangents, double* h);
  bool conclude(const ContactStep<double>& found);
  bool step();
  bool shorten();
  bool is_on_disc();
  bool try_disc(Side& flat, Side& other, double sign);
  bool closes(const Vector3& a, const Vector3& q);
  void report(const Problem& problem, DistanceResult& result);

  Side A_, Q_;
  double tolerance_ = 0;
  double radius_ = 0;  // R
  Vector3 u_;
  double ratio_ = 0;
  double weight_[2][2] = {{0, 0}, {0, 0}};  // of piece i of A with piece j of Q
  int pair_[4] = {0, 0, 0, 0}, pairs_ = 0;  // 2i + j of those that there are
  Vector3 from_, way_;                      // the point before, and the step taken from there
  double from_ratio_ = 0, share_ = 1, last_step_ = 1;
  Bounds bounds_;
  double estimate_ = 0;
  Vector3 normal_, contact_;
  std::int64_t evaluations_ = 0, steps_ = 0, contacts_ = 0;
};

}  // namespace raygauge
