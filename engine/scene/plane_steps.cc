// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/scene/plane_steps.h"

#include <algorithm>
#include <cmath>

namespace raygauge {
namespace {

constexpr double kOutward = 1 + 1e-12;  // of a few operations
constexpr int kTrials = 4;

// Seen from the body the unit vector u turns, w' = w × spin, and the height is h(w), convex and at most reach
// |w| for the core: its excess over the chord is reach times that of w, |w''| T²/8 with |w''| = |spin| |spin
// × u|.
double turning_curvature(const MotionBound& bound, double reach, const SmallVector& u) {
  return bound.turning(u) * bound.spin.norm() * reach / 8;
}

// An angular velocity that differs from the spin by e adds 2 e T reach at most, a velocity e T/2.
double drift_of(const MotionBound& bound, double reach) {
  return bound.velocity_error / 2 + 2 * bound.spin_error * reach;
}

// u, which is carried by a body from one placement to another.
SmallVector carried(const SmallVector& u, const Placement& from, const Placement& to) {
  const SmallVector seen = from.R.transpose() * u;
  return to.R * seen;
}

}  // namespace

double PlaneSteps::Bulge::over(double T) const { return (curvature * T + drift) * T * kOutward; }

void PlaneSteps::look_along(double t, Planes& planes) {
  planes.apart = watch_.apart_along(t, planes.u, planes.arm_a, planes.arm_b);
  planes.at_a = watch_.placement_a();
  planes.at_b = watch_.placement_b();
}

// `places`: |p_b - p_a| at most. Seen from the body that does not carry the planes w = Rᵀu has
// w'' = Rᵀ((ω_c - ω) × (ω_c × u) - ω × ((ω_c - ω) × u)), ω its own angular velocity and ω_c the carrier's.
PlaneSteps::Bulge PlaneSteps::bulge(const PairMotion& motion, double places, Carrier carrier) const {
  const double reach_a = watch_.a().core_reach, reach_b = watch_.b().core_reach;
  const SmallVector& u = now_.u;
  if (carrier == Carrier::space) {
    return {turning_curvature(motion.a, reach_a, u) + turning_curvature(motion.b, reach_b, u),
            drift_of(motion.a, reach_a) + drift_of(motion.b, reach_b)};
  }
  const bool by_a = carrier == Carrier::a;
  const MotionBound& own = by_a ? motion.a : motion.b;
  const MotionBound& other = by_a ? motion.b : motion.a;
  const double turning = own.turning(u);
  const double of_other =
      (own.spin - other.spin).norm() * (turning + other.spin.norm()) * (by_a ? reach_b : reach_a);
  const double of_way = (2 * (own.velocity - other.velocity).norm() + places * own.spin.norm()) * turning;
  return {(of_other + of_way) / 8, 0};
}

// Of the planes, now.
double PlaneSteps::closing_speed(const PairMotion& motion, Carrier carrier) const {
  const SmallVector way = now_.at_b.t - now_.at_a.t;
  const SmallVector arm_a = carrier == Carrier::a ? SmallVector(now_.arm_b + way) : now_.arm_a;
  const SmallVector arm_b = carrier == Carrier::b ? SmallVector(now_.arm_a - way) : now_.arm_b;
  return motion.b.velocity_of(arm_b).dot(now_.u) - motion.a.velocity_of(arm_a).dot(now_.u);
}

// Where the closing speed leads to, less what the turning of the bodies may take at both ends.
double PlaneSteps::predicted(const PairMotion& motion, double longest, Carrier carrier) const {
  const Bulge bulge_now = bulge(motion, (now_.at_b.t - now_.at_a.t).norm(), carrier);
  const double v = closing_speed(motion, carrier) + bulge_now.drift;
  const double root = std::sqrt(v * v + 32 * bulge_now.curvature * now_.apart);
  return v + root > 0 ? std::min(longest, 2 * now_.apart / (v + root)) : longest;
}

// The body on whose surface the plane that stands still has slid farther towards the other body.
PlaneSteps::Carrier PlaneSteps::of_turned_face() const {
  const SmallVector& u = now_.u;
  const double slid_a = u.dot(carried(now_.arm_a, now_.at_a, then_.at_a) - then_.arm_a);
  const double slid_b = u.dot(then_.arm_b - carried(now_.arm_b, now_.at_b, then_.at_b));
  return slid_a > slid_b ? Carrier::a : Carrier::b;
}

double PlaneSteps::next(const PartLook& look, const PairMotion& motion, double safe, double end,
                        double& apart) {
  const double t = look.time;
  now_.u = look.normal / look.normal.norm();
  look_along(t, now_);
  if (!(now_.apart > 0)) return safe;
  const bool varies = motion.varies();
  if (varies) carrier_ = Carrier::space;
  double time = predicted(motion, end - t, carrier_);
  for (int trial = 0; trial < kTrials && t + time > safe; ++trial) {
    const double until = std::min(t + time, end);
    watch_.place(until);
    then_.u = carrier_ == Carrier::space ? now_.u
              : carrier_ == Carrier::a   ? carried(now_.u, now_.at_a, watch_.placement_a())
                                         : carried(now_.u, now_.at_b, watch_.placement_b());
    look_along(until, then_);
    const double places = std::max((now_.at_b.t - now_.at_a.t).norm(), (then_.at_b.t - then_.at_a.t).norm());
    const Bulge bulge_then = bulge(varies ? PairMotion(watch_, t, until) : motion, places, carrier_);
    const double over = bulge_then.over(until - t) + (carrier_ == Carrier::space ? 0.0 : watch_.slack());
    if (std::min(now_.apart, then_.apart) > over) {
      apart = then_.apart;
      return until;
    }
    time *= std::clamp((now_.apart - 3 * over) / (now_.apart - then_.apart), 0.25, 0.9);
    if (varies) continue;
    const Carrier other = carrier_ == Carrier::space ? of_turned_face() : Carrier::space;
    const double by_other = predicted(motion, end - t, other);
    if (by_other <= time) continue;
    carrier_ = other;
    time = by_other;
  }
  return safe;
}

}  // namespace raygauge
