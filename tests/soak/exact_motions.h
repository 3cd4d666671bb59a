// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "generators/random.h"
#include "raygauge/numerics/quad.h"
#include "raygauge/scene/continuous.h"

namespace raygauge::soak {

/// A ball whose place is known in quadruple precision at any time, before a box that stands: what decides
/// whether they touch is far below the rounding of the terms that the ball's place is computed of.
class ExactMotion {
 public:
  /// A ball that rests, reverses, turns about a far origin, or hangs on a chain of links that folds back; the
  /// face of the box at a gap of 1e-20 to 1e-6 of all terms before or behind the nearest point of its way.
  explicit ExactMotion(RandomStream& stream);

  /// What is false of its time of impact or its clearance, or nothing. `undecided` is set where the time of
  /// impact is.
  std::optional<std::string> check(bool& undecided);

  const std::string& kind() const noexcept { return kind_; }

 private:
  using Place = std::function<std::array<Quad, 3>(Quad)>;  // of the ball's centre

  Place draw_rest(RandomStream& stream);
  Place draw_reversal(RandomStream& stream);
  Place draw_turn(RandomStream& stream);
  Place draw_chain(RandomStream& stream);
  double farthest(double from, double to) const;
  Quad distance(double t) const;
  std::string text(const ImpactResult& impact, const ClearanceResult& found) const;

  std::string kind_;
  double stop_ = 1, terms_ = 1, nearest_ = 0;
  MotionPointer motion_;
  Eigen::Vector3d center_ = Eigen::Vector3d::Zero();  // of the ball, in the frame of its body
  double radius_ = 0.5, face_ = 0;
  Place place_;
};

}  // namespace raygauge::soak
