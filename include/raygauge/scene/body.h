// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "raygauge/scene/motion.h"
#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// {x : |x - center| <= radius}, proven to contain a part or a body.
struct BoundingBall {
  SmallVector center;
  double radius = 0;
};

/// A ball around S, proven: around the middle of its box, at most 13 % larger than the least one about that
/// point; exact for point sets. 2n support queries, in 3 dimensions 26.
BoundingBall bounding_ball(const ConvexSet& S);

/// One convex part of a body, in the frame of the body. For a half-space, ball and reach are infinite, and
/// the magnitude is its normal.
struct BodyPart {
  std::shared_ptr<const ConvexSet> set;
  BoundingBall ball;
  double reach = 0;             ///< no point of the part is farther from the body's origin
  double core_reach = 0;        ///< the same for its core, without the radius that surrounds it
  SmallVector magnitude;        ///< ConvexSet::magnitude_unchecked
  double turned_magnitude = 0;  ///< bounds it in every rotation of the part
};

/// 2 √n |m|: an upper bound on the magnitude of a set of magnitude m in any rotation.
double turned_magnitude(const SmallVector& magnitude);

class PartTree;

/// A rigid body: the union of convex parts, under a motion.
struct Body {
  std::string name;
  std::vector<BodyPart> parts;
  std::shared_ptr<const PartTree> tree;  ///< of balls around many parts; null: there are few
  MotionPointer motion;
  BoundingBall ball;  ///< around all parts
  double reach = 0;   ///< the greatest of the parts'
  double core_reach = 0;

  int dimension() const noexcept { return motion->dimension(); }

  /// False for a half-space.
  bool is_bounded() const noexcept { return reach < std::numeric_limits<double>::infinity(); }
};

/// The body of these parts; a half-space is the only part of its body. Throws EmptySetError (no part),
/// InvalidParameterError (a null pointer, a half-space beside another part) or DimensionMismatchError.
Body make_body(std::string name, const std::vector<std::shared_ptr<const ConvexSet>>& parts,
               MotionPointer motion);

}  // namespace raygauge
