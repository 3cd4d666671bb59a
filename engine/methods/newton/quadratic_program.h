// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/newton/sqp_oracle.h"
#include "engine/numerics/aligned_buffer.h"

namespace raygauge {

/// The convex function that a Newton step minimises over u,
///
///     φ(u) = w_A h_A(u) + w_Q h_Q(-u) + l·u,
///
/// homogeneous of degree one. Its minimum over a plane {u + d : u·d = 0} is modelled by one step of
/// sequential quadratic programming: with the pieces h_i of A and h_j of Q at u,
///
///     minimize  ½ dᵀHd + w_A max_i (h_i + s_i·d) + w_Q max_j (h_j - s_j·d) + l·d,
///     H = w_A Σ α_i ∇²h_i + w_Q Σ β_j ∇²h_j,     α, β the weights of the step before.
///
/// The pieces that attain the two maxima form the active set; their multipliers are the weights α, β, with
/// which Σ α_i s_i is a point of A and Σ β_j s_j one of Q.
template <class Real>
class QuadraticProgram {
 public:
  struct Objective {
    Real weight_A = 1;
    Real weight_Q = 1;
    const Real* linear = nullptr;  ///< l; nullptr for zero
    bool graded = false;           ///< H = D H' D, the entries of the diagonal D as different as they like
  };

  /// Writes the weights of both lists and returns the step d, n doubles; nullptr if no active set was found.
  const Real* solve(const Real* u, const Objective& objective, PieceList<Real>& A, PieceList<Real>& Q);

  std::int64_t systems() const noexcept { return systems_; }
  void begin(int n);

 private:
  void warm_start(PieceList<Real>& list);
  bool solve_system(const Real* u, const Objective& objective, PieceList<Real>& A, PieceList<Real>& Q);
  bool solve_system(const Real* u, const Objective& objective, PieceList<Real>& A, PieceList<Real>& Q,
                    Real slack);
  void add_curvature(const PieceList<Real>& list, Real weight);
  void add_differences(const PieceList<Real>& list, int sign, int row, Real along);
  bool eliminate(int size, bool graded);
  template <class Size>
  bool eliminate_sized(Size size, bool graded);
  void exchange_rows(int p, int size);
  void read_weights(PieceList<Real>& list, Real scale, int row) const;
  bool drop_negative(PieceList<Real>& list) const;
  bool add_violated(PieceList<Real>& list, int sign) const;
  Real model(const PieceList<Real>& list, int i, int sign) const;

  int n_ = 0;
  int columns_ = 0;
  std::int64_t systems_ = 0;
  bool flat_ = false;            // no curvature in the last system
  AlignedBuffer<Real> system_;   // rows of the KKT system, right-hand side last
  AlignedBuffer<Real> step_;     // d, then the scaled multipliers
  AlignedBuffer<Real> stretch_;  // of the rows from n on
};

}  // namespace raygauge
