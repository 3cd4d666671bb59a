// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/newton/sqp_oracle.h"
#include "engine/numerics/aligned_buffer.h"
#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// What an unconditional set (CoordinateSymmetry) in a pair of smooth ones adds to a
/// Newton step. Coordinate k of its support points answers to u_k as a power does,
///
///     |s_k - c_k| ~ |u_k|^a,      a = u_k H_kk / |s_k - c_k|,
///
/// with a = 1/(p - 1) for balls of a p-norm, which no straight step along u describes: a step d is taken in
/// the coordinates |u_k|^a instead, u_k (1 + a d_k/u_k)^(1/a), the same to first order; a as it is for both
/// sets together. Where the sets touch on faces across u_k = 0, the contact point within the faces may belong
/// to no u_k != 0 that is representable.
template <class Real>
class PowerSteps {
 public:
  /// False if neither set is known to be unconditional, or one is not smooth.
  bool bind(const ConvexSet& A, const ConvexSet& Q);

  /// Learns a_k from the greatest pieces at u, and finds the coordinates in which the faces of A - shift and
  /// ρQ across u_k = 0 meet; where u_k = 0, both points are moved to where they do, if they are the only
  /// pieces.
  void move_contact_along_faces(const Real* u, Real ratio, Real shift, const double* shift_direction,
                                PieceList<Real>& A, PieceList<Real>& Q);

  /// Whether faces meet, in some coordinates but not in all.
  bool has_flats() const noexcept { return 0 < meeting_ && meeting_ < n_; }

  /// The way from u along share · step, n numbers; with `flat` to u_k = 0 where faces meet. No step tells how
  /// far away from a face: where one that had led there turns out to have been wrong, u_k returns to what it
  /// was before, or for a smaller share so much of that way.
  void advance(const Real* u, const Real* step, Real share, bool flat, Real* next);

 private:
  struct Side {
    const ConvexSet* set = nullptr;
    double sign = 1;
    bool unconditional = false;
    bool in_part = false;  // a sum with unconditional summands
    AlignedBuffer<double> center, extent;
    AlignedBuffer<double> direction, reach, change;  // of the summands at u
    bool bind(const ConvexSet& S, double u_sign);
    void look_along(const Real* u, int n);
  };
  struct Coordinate {
    Real middle, extent;  ///< of the face across u_k = 0
    Real reach;           ///< |s_k - c_k|
  };
  Real advance(Real u_k, Real d, Real share, std::size_t k) const;
  Coordinate coordinate(const Side& side, Real s_k, Real change, std::size_t k) const;

  int n_ = 0;
  int meeting_ = 0;  // coordinates
  Side A_, Q_;
  AlignedBuffer<double> exponent_;
  AlignedBuffer<int> meets_;
  AlignedBuffer<Real> before_;  // |u_k| before the step that led to the face; 0 where it is not there
};

}  // namespace raygauge
