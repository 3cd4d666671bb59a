// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "generators/component.h"

namespace raygauge {

/// `bodies`: two bodies of R^n, n >= 2, of given kinds, A = body_2 - body_1 and Q the unit ball, at a planted
/// Euclidean distance. With a random unit vector u, body 2 is moved until its support point at -u is that of
/// body 1 at u plus gap·u: then the planes through the two points separate the bodies, and the points are the
/// closest ones. Other quantities: the growth distance is planted likewise, the depth where one of the bodies
/// is rounded.
Component<Generator> bodies_generator();

}  // namespace raygauge
