// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/instance.h"

namespace raygauge {

// Lengths of very different size in one instance, or a distance next to a threshold. N is ignored; the axes
// are turned at random.

/// `hard_needle`: Q = conv{±e_1, …, ±e_{n-1}, ±e_n/aspect}, A = {(¼, ¼, 0, …, 0, 1/aspect)} (one ¼ for n = 2,
/// none for n = 1). d = 1 + ½ (1 + ¼, 1). With `sheared`, x_n += x_1 is applied to both: d is the same where
/// the aspect is a power of two, else it is that of the rounded points, and not stated.
Component<Generator> hard_needle_generator();

/// `hard_near_face`: A = conv{(δ, ±e_k), (1, 0)}, a facet at distance δ from the origin. d = δ. n >= 2.
Component<Generator> hard_near_face_generator();

/// `hard_contact`: d = 1 + ulps · 2^-52 exactly: contact, or one rounding error away from it, all of A or a
/// facet of it optimal. Against the cross-polytope A = conv{d e_1, (d - 1) e_1 + e_k}, against the cube
/// conv{(d, ±e_k), (2, 0)}. n >= 2.
Component<Generator> hard_contact_generator();

/// `hard_origin_near_facet`: Q = conv{(-δ, ±e_k), (1, 0)}: 0 at distance δ inside a facet; A = {-e_1}.
/// d = 1/δ, correctly rounded. n >= 2.
Component<Generator> hard_origin_near_facet_generator();

}  // namespace raygauge
