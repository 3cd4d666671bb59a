// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "raygauge/scene/continuous.h"
#include "scene/queries/pair_solver.h"

namespace raygauge {

/// What a look at one pair of bodies at one time has shown, of the exact motion.
struct PartLook {
  double time = 0;
  double lower = 0;    ///< no more than the distance
  double upper = 0;    ///< no less than the distance
  bool meets = false;  ///< the bodies share a point, however the placements are rounded
  SmallVector normal;
  PairAnswer answer;  ///< of the computed placements
};

/// One convex part of each of two bodies, as bodies of their own.
struct PartPair {
  Body a, b;
  PartNumbers numbers;

  /// `answer`, about these bodies, is about these parts from now on.
  void name_in(PairAnswer& answer) const { answer.part_a = numbers.a, answer.part_b = numbers.b; }
};

/// The pairs of parts of two bodies, those nearest at `t` first.
std::vector<PartPair> part_pairs(const Body& a, const Body& b, double t);

/// One pair of convex parts on its way, seen at any time; what a look finds out starts the next one.
class PartWatch {
 public:
  /// Distances on the way need no more digits than a step does.
  static constexpr double kStepTolerance = 1e-3;

  /// All must outlive the watch, which binds the solver. Only at() is for bodies of several parts.
  PartWatch(PairSolver& solver, const Body& a, const Body& b, const SceneMetric& metric,
            const Body* metric_body);

  PartLook at(double t, bool closest_points = false);

  /// How far apart the bodies are at t between planes across the unit vector u, at least; not above 0
  /// where they may overlap. Euclidean. `arm_a` and `arm_b`: from the origins of the bodies to points on the
  /// planes.
  double apart_along(double t, const SmallVector& u, SmallVector& arm_a, SmallVector& arm_b);

  /// Both bodies as they are at t from now on.
  void place(double t);
  const Placement& placement_a() const noexcept { return solver_.placement_a(); }
  const Placement& placement_b() const noexcept { return solver_.placement_b(); }

  /// How far computed placements are from those of the exact motions, at most.
  const PlacementError& error_a() const noexcept { return error_a_; }
  const PlacementError& error_b() const noexcept { return error_b_; }

  /// How much nearer to each other, or farther apart, points of both bodies may be than computed.
  double slack() const noexcept { return slack_; }

  /// The end of the piece of the motions that t is in, at most `to`.
  double end_of_piece(double t, double to) const;

  /// How fast the pair can close along u, at most, over [from, to]; of a mesh, which may be met from any
  /// side, in any direction.
  double closing_speed(const SmallVector& u, double from, double to) const;
  double closing_speed(const SmallVector& u, const MotionBound& a, const MotionBound& b) const;

  /// False where a part is a mesh: planes prove nothing of it.
  bool is_convex() const noexcept { return convex_; }

  const Body& a() const noexcept { return a_; }
  const Body& b() const noexcept { return b_; }
  const SceneMetric& metric() const noexcept { return metric_; }
  const Body* metric_body() const noexcept { return metric_body_; }

 private:
  bool meets_wherever_shifted(const PairAnswer& unmoved);
  double slack_in_metric();

  bool convex_;
  PairSolver& solver_;
  const Body& a_;
  const Body& b_;
  const SceneMetric& metric_;
  const Body* metric_body_;
  PairMemory memory_;
  double placed_at_;
  PlacementError error_a_, error_b_;
  double slack_ = 0;
  double longest_unit_ = 0;  ///< the metric's length of a vector of length 1, at most; 0: not known yet
};

}  // namespace raygauge
