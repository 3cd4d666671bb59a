// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <variant>
#include <vector>

#include "analysis/studies/wrong_answers/body_pieces.h"
#include "raygauge/sweep/instance.h"

namespace raygauge {

/// A direction from the first body to the second: every two of their points are at least
/// (-h_2(-u) - h_1(u))/|u| apart.
struct SeparatingNormal {
  Vector normal;
};

/// A point of each body: the bodies are at most as far apart as these. Of a growth distance: both scaled by
/// it about their centres, the points become one.
struct ClosePoints {
  PointOfPieces first, second;
};

/// Points of the difference A2 - A1, given by a point of each body, and a closed surface of triangles of them
/// around the origin, which is seen from outside counterclockwise everywhere: the depth is at least the least
/// distance of a plane of a triangle from the origin.
struct SurfaceAround {
  std::vector<ClosePoints> corners;
  std::vector<std::array<int, 3>> triangles;
};

/// Why what somebody claims of two bodies cannot be: with the bodies and one proof, which can be checked
/// without raygauge.
struct Refutation {
  BodyPieces first, second;
  std::variant<SeparatingNormal, ClosePoints, SurfaceAround> proof;
  double proven = 0;  ///< what the proof tells of the quantity, in doubles: a bound on the side of the truth
  Vector center_1, center_2;  ///< of growth distances
};

/// Refutes that the quantity of the bodies A1 and A2 of an instance, A = A2 - A1 and Q the unit ball, is
/// `answer`, by more than `slack`. Empty where the answer is within slack of the truth, or where no proof is
/// found: of bodies that pieces_of() does not know, or that touch; of depths that are too small, outside of
/// R^3, where 4000 points do not suffice, and of some polytopes many of whose facets are in one plane.
std::optional<Refutation> refute(const Instance& instance, double claim, double slack);

}  // namespace raygauge
