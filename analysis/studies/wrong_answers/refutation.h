// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <variant>

#include "analysis/studies/wrong_answers/body_pieces.h"
#include "raygauge/sweep/instance.h"

namespace raygauge {

/// A direction from the first body to the second: every two of their points are at least
/// (-h_2(-u) - h_1(u))/|u| apart.
struct SeparatingNormal {
  Vector normal;
};

/// A point of each body: the bodies are at most as far apart as these.
struct ClosePoints {
  PointOfPieces first, second;
};

/// Why a distance that somebody claims of two bodies cannot be: with the bodies and one proof, which can be
/// checked without raygauge.
struct Refutation {
  BodyPieces first, second;
  std::variant<SeparatingNormal, ClosePoints> proof;
  double distance =
      0;  ///< at least that of the normal; at most that of the points; the depth along the way; in doubles
};

/// Refutes that the bodies A1 and A2 of an instance, A = A2 - A1 and Q the unit ball, are `answer` apart, by
/// more than `slack`. Empty where the answer is within slack of the truth, or where no proof is found: of
/// bodies that pieces_of() does not know, or that touch.
std::optional<Refutation> refute(const Instance& instance, double claim, double slack);

}  // namespace raygauge
