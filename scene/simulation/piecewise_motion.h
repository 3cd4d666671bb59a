// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "raygauge/scene/motion.h"

namespace raygauge {

/// A vector of the plane or of space, with zeros behind it.
inline Eigen::Vector3d in_space(const SmallVector& v) {
  Eigen::Vector3d all = Eigen::Vector3d::Zero();
  all.head(v.size()) = v;
  return all;
}

/// A rotation of the plane or of space, in space.
inline Eigen::Matrix3d in_space(const SmallMatrix& R) {
  Eigen::Matrix3d all = Eigen::Matrix3d::Identity();
  all.topLeftCorner(R.rows(), R.cols()) = R;
  return all;
}

/// From `start` on, until the next piece: the motion TwistMotion(first(), rates(), start). In few bytes: a
/// run has millions.
struct MotionPiece {
  MotionPiece() = default;
  MotionPiece(double begin, const Placement& first, const TwistMotion::Rates& rates);

  double start = 0;
  int dimension = 3;
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d x = Eigen::Vector3d::Zero(), velocity = x, acceleration = x, spin = x;

  Placement first() const;
  TwistMotion::Rates rates() const;
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
