// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "scene/queries/part_watch.h"

namespace raygauge {

/// How both bodies of a watch move over an interval of time within a piece of either motion.
struct PairMotion {
  MotionBound a, b;

  PairMotion(const PartWatch& watch, double from, double to)
      : a(watch.a().motion->bound(from, to)), b(watch.b().motion->bound(from, to)) {}

  /// Whether bounds over less time may be better.
  bool varies() const { return a.velocity_error + a.spin_error + b.velocity_error + b.spin_error > 0; }
};

/// Steps in time that two parallel planes between the bodies prove to be without contact: they touch the
/// bodies and are apart, at both ends of the step, by more than they can approach each other in between.
/// Their normal u stands still in space, or turns with one of the bodies: a face of that body then stays a
/// face.
///
/// What is between the planes is at least its linear interpolation over the time T of the step, less c T²/8:
///   planes that stand still:   c = Σ reach |ω| |ω × u|, each body's own,
///   planes that turn with A:   c = reach_B |ω_A - ω_B| (|ω_A × u| + |ω_B|)
///                                  + (2 |v_B - v_A| + |p_B - p_A| |ω_A|) |ω_A × u|,
///   planes that turn at ω:     c = Σ reach |ω - ω_i| (|ω| + |ω_i|) + (2 |v_B - v_A| + |p_B - p_A| |ω|) |ω|,
///                              each body's own ω_i, ω across u,
/// p the places of the bodies' origins, v their velocities, ω their angular velocities, reach as in
/// BodyPart::core_reach. Where velocities are known to an error e_v and angular velocities to e_ω only, what
/// is between the planes differs after the time T by at most D T from that of constant velocities, which
/// takes 2 D T:
///   planes that stand still:   D = Σ (e_v / 4 + reach e_ω),
///   planes that turn with A:   D = e_v,A + e_v,B + |p_B - p_A| e_ω,A + reach_B (e_ω,A + e_ω,B),
///   planes that turn at ω:     D = Σ (e_v + reach e_ω).
class PlaneSteps {
 public:
  explicit PlaneSteps(PartWatch& watch) : watch_(watch) {}

  /// A time up to which nothing touches, at most `end`; `safe` if planes prove no later one. The bodies are
  /// as at the time of the look, which has closest points.
  double next(const PartLook& look, const PairMotion& motion, double safe, double end);

  /// A lower bound on the distance from `look` until `end`, a later or an earlier moment of the same piece,
  /// by planes across the normal of the look, which `motion` bounds in between; 0 where none is proven.
  double least_until(const PartLook& look, double end, const PairMotion& motion);

  /// The same across the vector u at the time `from`, of bodies that may overlap too: of these it is a lower
  /// bound on the signed distance, minus the depth.
  double least_along(const SmallVector& u, double from, double end, const PairMotion& motion);

  /// The same by planes that turn from `u` to `u_end` at a constant rate: two edges that cross stay in them.
  /// -infinity where these are 60 degrees apart or more, or a body is not bounded.
  double least_turning(const SmallVector& u, const SmallVector& u_end, double from, double end,
                       const PairMotion& motion);

 private:
  enum class Carrier : std::uint8_t { space, a, b };

  struct Planes {
    SmallVector u;             // of length 1, from b to a
    SmallVector arm_a, arm_b;  // from the origins of the bodies to where the planes touch
    SmallVector way;           // between the origins, from a to b
    double apart = 0;
  };

  // What is between the planes may be less than its linear interpolation by curvature T² + drift T.
  struct Bulge {
    double curvature = 0, drift = 0;
    double over(double T) const;
  };

  void begin(const SmallVector& normal);
  double least_from(double from, double end, const PairMotion& motion, double least);
  void look_along(double t, Planes& planes);
  double predicted(const PairMotion& motion, double longest, Carrier carrier) const;
  double closing_speed(const PairMotion& motion, Carrier carrier) const;
  Bulge bulge(const PairMotion& motion, double places, Carrier carrier) const;
  double rounding(Carrier carrier) const;
  Carrier of_turned_face() const;
  void change_carrier(const PairMotion& motion, double longest, double& time);

  SmallVector carried(const SmallVector& u, Carrier carrier) const;

  PartWatch& watch_;
  Placement at_a_, at_b_;             // at the time of the look
  PlacementError error_a_, error_b_;  // of these
  Carrier carrier_ = Carrier::space;  // of the last step
  Planes now_, then_;
};

}  // namespace raygauge
