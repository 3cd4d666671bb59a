// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/instance.h"

namespace raygauge {

// Balls of several norms. n >= 2, N is ignored. A distance that is no double is computed in `long double`:
// where that has 64 bits or more, the double returned is one of the two beside it.

/// `hard_tangent_disc`: Q = the ball of radius 1 around e_1, A = the point ε e_1 + e_2, in a random
/// orientation and scaled by 125; ε is rounded to a multiple of 2^-36. d = (1 + ε²)/(2ε); +infinity for ε =
/// 0, where Q touches the plane that A lies in: a cone that is not closed, so that no direction proves it.
Component<Generator> hard_tangent_disc_generator();

/// `hard_p_norm_ball`: homothets of K = {x : ‖(x_k/w_k)‖_p <= 1} (homothets.h) with centres diag(w) z, w_k
/// powers of two from ¼ to 4, z_k = ±1 … ±9. d = (t‖z‖_p - r)/s.
Component<Generator> hard_p_norm_ball_generator();

/// `hard_ellipsoid`: homothets of K = {L z : |z| <= 125} with centres L z_0, z_0 integers of length 125 and
/// L = M diag(a): M an integer similarity (similarities.h), a_k powers of two, but for the largest, which is
/// `aspect` rounded to an integer; the least is 1. d = (t - r)/s exactly.
Component<Generator> hard_ellipsoid_generator();

}  // namespace raygauge
