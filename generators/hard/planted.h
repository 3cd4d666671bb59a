// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/instance.h"

namespace raygauge {

// Instances with a planted answer λ and as many ties as wanted, at any n and N, in integers: with an integer
// vector y,
//
//     y·q_j <= K for all j,   y·q_* = K,      y·a_i >= λK for all i,   a_* = λ q_*.
//
// Then d = λ: λ q_* is in A, and by weak duality (y) no smaller multiple of Q meets A. Of the other points of
// either set the fraction `ties` lies on the hyperplane as well.

/// `hard_planted_ties`: as above. N points in each set.
Component<Generator> hard_planted_ties_generator();

/// `hard_planted_unimodular`: the same after an integer map of determinant 1 with entries up to `entry`:
/// d = λ, and hopeless conditioning.
Component<Generator> hard_planted_unimodular_generator();

/// `hard_planted_origin`: 0 in A, with λ = 0: on a face of A, the relative interior of the hull of some of
/// the points on the hyperplane, or (`place` = interior) with points of A on all sides of it; then the same
/// map. d = 0. N >= 2, for the interior N >= n + 2.
Component<Generator> hard_planted_origin_generator();

/// `hard_planted_unreachable`: y·a_i >= 1 and y·q_j <= 0, where points of Q on the hyperplane y·q = 0
/// surround the origin in it, so that no direction leaves all of Q strictly behind; then the same map. d =
/// +infinity.
Component<Generator> hard_planted_unreachable_generator();

/// `hard_duplicates`: the same with N / copies distinct points (at least one) in each set, every one of them
/// `copies` times, shuffled. d = λ.
Component<Generator> hard_duplicates_generator();

/// `hard_scaled`: the same, both sets times 2^exponent. d = λ.
Component<Generator> hard_scaled_generator();

/// `hard_scaled_object`: the same, only A times 2^exponent. d = 2^exponent λ.
Component<Generator> hard_scaled_object_generator();

}  // namespace raygauge
