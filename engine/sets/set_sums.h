// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sets/convex_set.h"

namespace raygauge {

// What S + T (sign = 1) and S - T (sign = -1) have in common:
//
//     h(u) = h_S(u) + h_T(sign u),      s(u) = s_S(u) + sign s_T(sign u).

/// The support function of S ± T; s(u) in `point` and s_T(sign u) in `of_T`, n doubles each.
double sum_support(const ConvexSet& S, const ConvexSet& T, double sign, const double* u, double* point,
                   double* of_T);

/// c_S ± c_T.
void sum_center(const ConvexSet& S, const ConvexSet& T, double sign, double* point);

/// The magnitudes of S and T added up.
void sum_magnitude(const ConvexSet& S, const ConvexSet& T, double* magnitude);

/// An upper bound on what a + b loses when it is rounded, with room for one more operation.
double rounding_of_sum(double a, double b) noexcept;

/// Whether S ± T is unconditional because S and T are, or one is and the other is a point. Its extents are
/// theirs added up (or 0, without its faces), less what rounding may have moved its centre: the intervals lie
/// within the faces of the exact sum.
bool sum_is_unconditional(const ConvexSet& S, const ConvexSet& T, double* extent, bool with_faces = true);

/// The pieces of S ± T, S's index running slower than T's (add_pieces). Returns how many T has; their
/// gradients are copied to `of_T` (room for kCapacity points) if that is not null.
template <class Real>
int sum_pieces(const ConvexSet& S, const ConvexSet& T, double sign, const Real* u,
               BasicSupportPieces<Real>& pieces, int capacity, Real* of_T = nullptr);

/// The pieces of a sum, h_i + h_j for every pair, from those of its operands: `second` stands right behind
/// `first` in memory and enters with its gradients times `sign` (-1 for the reflected operand of a
/// difference). Beyond `capacity` none are offered (first.count = 0).
template <class Real>
void add_pieces(BasicSupportPieces<Real>& first, const BasicSupportPieces<Real>& second, double sign,
                int capacity);

}  // namespace raygauge
