// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "generators/random.h"
#include "raygauge/sets/convex_set.h"

namespace raygauge::soak {

/// A convex set and how it was put together, e.g. "sum(ball, capsule)".
struct RandomSet {
  std::shared_ptr<const ConvexSet> set;
  std::string label;
};

/// Draws a set of every kind that the engine has, combined up to two deep, of size about `size` around
/// `center`. Half of the numbers are small multiples of size/4, so that faces, axes and radii coincide,
/// vanish or line up as they do not in general.
RandomSet draw_set(RandomStream& stream, const Vector& center, double size, int depth = 2);

/// A direction: an axis, a diagonal, or any.
Vector draw_direction(RandomStream& stream, int n);

}  // namespace raygauge::soak
