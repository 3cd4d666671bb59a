// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "raygauge/scene/motion.h"

namespace raygauge {

/// From `start` on, until the next piece: the motion TwistMotion(first, rates, start).
struct MotionPiece {
  double start = 0;
  Placement first;
  TwistMotion::Rates rates;
};

/// A motion of pieces, each of constant acceleration and constant angular velocity: what a simulation stores.
/// Where one piece ends the next one begins, to rounding.
class PiecewiseMotion final : public Motion {
 public:
  /// Throws InvalidParameterError (no piece, starts that do not rise, the last not before `stop`), and what
  /// TwistMotion throws.
  PiecewiseMotion(std::vector<MotionPiece> pieces, double stop);

  /// The velocity of the origin at t, of the later piece where one ends, and the angular velocity.
  Eigen::Vector3d velocity(double t) const;
  Eigen::Vector3d spin(double t) const;

 private:
  const MotionPiece& piece_of(double t) const;
  TwistMotion motion_of(double t) const;
  Placement do_at(double t) const override { return motion_of(t).at(t); }
  MotionBound do_bound(double from, double to) const override { return motion_of(from).bound(from, to); }
  PlacementError do_error_at(double t) const override { return motion_of(t).error_at(t); }
  double do_next_break(double t) const override;

  std::vector<MotionPiece> pieces_;
};

}  // namespace raygauge
