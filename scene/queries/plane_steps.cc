// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/queries/plane_steps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raygauge {
namespace {

constexpr double kOutward = 1 + 1e-12;  // of a few operations
constexpr double kNormalError = 4e-16;  // of a normal of a half-space, rounded to length 1
constexpr int kTrials = 4;
constexpr double kShortest = 0.25, kLongest = 0.999;  // of a time that was too long

// Seen from the body the unit vector u turns, w' = w × spin, and the height is h(w), convex and at most reach
// |w| for the core: its excess over the chord is reach times that of w, |w''| T²/8 with |w''| = |spin| |spin
// × u|.
double turning_curvature(const MotionBound& bound, double reach, const SmallVector& u) {
  const double spin = bound.spin.norm();
  return spin > 0 ? (bound.turning(u) + kNormalError * spin) * spin * reach / 8 : 0;
}

// An angular velocity that differs from the spin by e adds 2 e T reach at most, a velocity e T/2.
double drift_of(const MotionBound& bound, double reach) {
  const double of_spin = bound.spin_error > 0 ? 2 * bound.spin_error * reach : 0;
  return bound.velocity_error / 2 + of_spin;
}

}  // namespace

double PlaneSteps::Bulge::over(double T) const { return (curvature * T + drift) * T * kOutward; }

void PlaneSteps::look_along(double t, Planes& planes) {
  planes.apart = watch_.apart_along(t, planes.u, planes.arm_a, planes.arm_b);
  planes.way = watch_.placement_b().t - watch_.placement_a().t;
}

// A vector of the time of the look, to the time of the watch.
SmallVector PlaneSteps::carried(const SmallVector& u, Carrier carrier) const {
  if (carrier == Carrier::space) return u;
  const Placement& now = carrier == Carrier::a ? at_a_ : at_b_;
  const Placement& then = carrier == Carrier::a ? watch_.placement_a() : watch_.placement_b();
  return then.turned(now.turned_back(u));
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
  const double reach = by_a ? reach_b : reach_a;
  const double turning = own.turning(u);
  const double of_other = (own.spin - other.spin).norm() * (turning + other.spin.norm()) * reach;
  const double rounding = 1e-13 * (own.velocity.lpNorm<1>() + other.velocity.lpNorm<1>());
  const double of_way =
      (2 * ((own.velocity - other.velocity).norm() + rounding) + places * own.spin.norm()) * turning;
  const double drift = own.velocity_error + other.velocity_error + places * own.spin_error +
                       reach * (own.spin_error + other.spin_error);
  return {(of_other + of_way) / 8, 2 * drift};
}

// What planes that a body turns lose: its rotations now and then are rounded.
double PlaneSteps::rounding(Carrier carrier) const {
  if (carrier == Carrier::space) return 0;
  const double turn =
      carrier == Carrier::a ? error_a_.turn + watch_.error_a().turn : error_b_.turn + watch_.error_b().turn;
  return (turn + 1e-15) * (std::max(now_.way.norm(), then_.way.norm()) + watch_.a().reach + watch_.b().reach);
}

// Of the planes, now.
double PlaneSteps::closing_speed(const PairMotion& motion, Carrier carrier) const {
  const SmallVector arm_a = carrier == Carrier::a ? SmallVector(now_.arm_b + now_.way) : now_.arm_a;
  const SmallVector arm_b = carrier == Carrier::b ? SmallVector(now_.arm_a - now_.way) : now_.arm_b;
  return motion.b.velocity_of(arm_b).dot(now_.u) - motion.a.velocity_of(arm_a).dot(now_.u);
}

// Where the closing speed leads to, less what the turning of the bodies may take at both ends.
double PlaneSteps::predicted(const PairMotion& motion, double longest, Carrier carrier) const {
  const Bulge bulge_now = bulge(motion, now_.way.norm(), carrier);
  const double v = closing_speed(motion, carrier) + bulge_now.drift;
  const double root = std::sqrt(v * v + 32 * bulge_now.curvature * now_.apart);
  return v + root > 0 ? std::min(longest, 2 * now_.apart / (v + root)) : longest;
}

// The body on whose surface the plane that stands still has slid farther towards the other body.
PlaneSteps::Carrier PlaneSteps::of_turned_face() const {
  const SmallVector& u = now_.u;
  const double slid_a = u.dot(carried(now_.arm_a, Carrier::a) - then_.arm_a);
  const double slid_b = u.dot(then_.arm_b - carried(now_.arm_b, Carrier::b));
  return slid_a > slid_b ? Carrier::a : Carrier::b;
}

// Takes other planes where these are expected to lead farther than `time`.
void PlaneSteps::change_carrier(const PairMotion& motion, double longest, double& time) {
  if (!watch_.a().is_bounded() || !watch_.b().is_bounded()) return;  // it does not turn
  const Carrier other = carrier_ == Carrier::space ? of_turned_face() : Carrier::space;
  const double by_other = predicted(motion, longest, other);
  if (by_other <= time) return;
  carrier_ = other;
  time = by_other;
}

// The bodies are as at the time of the look.
void PlaneSteps::begin(const SmallVector& normal) {
  now_.u = normal / normal.norm();
  at_a_ = watch_.placement_a();
  at_b_ = watch_.placement_b();
  error_a_ = watch_.error_a();
  error_b_ = watch_.error_b();
  now_.way = at_b_.t - at_a_.t;
}

double PlaneSteps::least_until(const PartLook& look, double end, const PairMotion& motion) {
  if (!(look.lower > 0)) return 0;
  watch_.place(look.time);
  begin(look.normal);
  now_.apart = look.lower;
  return least_from(look.time, end, motion, 0);
}

double PlaneSteps::least_along(const SmallVector& u, double from, double end, const PairMotion& motion) {
  watch_.place(from);
  begin(u);
  look_along(from, now_);
  return least_from(from, end, motion, -std::numeric_limits<double>::infinity());
}

// At least `least`, which is proven otherwise.
double PlaneSteps::least_from(double from, double end, const PairMotion& motion, double least) {
  watch_.place(end);
  const double time = std::fabs(end - from);
  const double astray = time * (motion.a.velocity_error + motion.b.velocity_error);
  const bool bounded = watch_.a().is_bounded() && watch_.b().is_bounded();
  for (const Carrier carrier : {Carrier::space, Carrier::a, Carrier::b}) {
    if (!bounded && carrier != Carrier::space) break;
    then_.u = carried(now_.u, carrier);
    look_along(end, then_);
    const double places = std::max(now_.way.norm(), then_.way.norm()) + astray;
    const double over = bulge(motion, places, carrier).over(time) + rounding(carrier);
    const double apart = std::min(now_.apart, then_.apart);
    const double found = (apart < 0 ? apart * kOutward : apart) - over;
    if (found > least) least = found;  // not where it is no number
  }
  return least;
}

// w = Rᵀu of either body as in bulge(), with ω of the planes in place of the carrier's.
double PlaneSteps::least_turning(const SmallVector& u, const SmallVector& u_end, double from, double end,
                                 const PairMotion& motion) {
  constexpr double kUnknown = -std::numeric_limits<double>::infinity();
  constexpr double kAngleError = 4e-15;  // of the angle between two vectors of length 1, rounded
  const double time = std::fabs(end - from);
  if (!watch_.a().is_bounded() || !watch_.b().is_bounded() || !(time > 0)) return kUnknown;
  watch_.place(from);
  begin(u);
  look_along(from, now_);
  watch_.place(end);
  then_.u = u_end / u_end.norm();
  look_along(end, then_);
  const double chord = (then_.u - now_.u).norm();
  if (!(chord < 1)) return kUnknown;
  Eigen::Vector3d first = Eigen::Vector3d::Zero(), last = first;
  first.head(u.size()) = now_.u;
  last.head(u.size()) = then_.u;
  const Eigen::Vector3d axis = first.cross(last - first);
  const double rate = (2 * std::asin(chord / 2) + kAngleError) / time;
  const Eigen::Vector3d spin = axis.norm() > 0 ? Eigen::Vector3d(rate / axis.norm() * axis) : axis;
  // The axis is known to the error of the chord, across the planes' path.
  const double astray = 2 * kAngleError / time;
  const auto curvature = [&](const MotionBound& body, double reach) {
    return reach * ((spin - body.spin).norm() + astray) * (rate + body.spin.norm());
  };
  const double reach_a = watch_.a().core_reach, reach_b = watch_.b().core_reach;
  const double errors = motion.a.velocity_error + motion.b.velocity_error;
  const double places = std::max(now_.way.norm(), then_.way.norm()) + time * errors;
  const double speed = (motion.b.velocity - motion.a.velocity).norm() +
                       1e-13 * (motion.a.velocity.lpNorm<1>() + motion.b.velocity.lpNorm<1>());
  const double of_turns = curvature(motion.a, reach_a) + curvature(motion.b, reach_b);
  const double of_way = (2 * speed + places * rate) * rate;
  const double drift = errors + reach_a * motion.a.spin_error + reach_b * motion.b.spin_error;
  const double over = Bulge{(of_turns + of_way) / 8, 2 * drift}.over(time);
  const double apart = std::min(now_.apart, then_.apart);
  return (apart < 0 ? apart * kOutward : apart / kOutward) - over;
}

double PlaneSteps::next(const PartLook& look, const PairMotion& motion, double safe, double end) {
  const double t = look.time;
  if (!(look.lower > 0) || look.answer.point_a.size() == 0) return safe;
  begin(look.normal);
  now_.apart = look.lower;
  now_.arm_a = look.answer.point_a - at_a_.t;
  now_.arm_b = look.answer.point_b - at_b_.t;
  const bool varies = motion.varies();
  if (varies) carrier_ = Carrier::space;
  bool may_change = !varies;
  double time = predicted(motion, end - t, carrier_);
  for (int trial = 1; trial <= kTrials && t + time > safe; ++trial) {
    const double until = std::min(t + time, end);
    watch_.place(until);
    then_.u = carried(now_.u, carrier_);
    look_along(until, then_);
    const double places = std::max(now_.way.norm(), then_.way.norm());
    const Bulge bulge_then = bulge(varies ? PairMotion(watch_, t, until) : motion, places, carrier_);
    const double over = bulge_then.over(until - t) + rounding(carrier_);
    if (now_.apart > over && then_.apart > over) return until;  // not where either is no number
    // Short of where the line through both ends leads, the more so the more often that was too far.
    const double too_far = 1 - (now_.apart - 3 * over) / (now_.apart - then_.apart);
    time *= std::clamp(1 - 2 * trial * too_far, kShortest, kLongest);
    if (may_change) change_carrier(motion, end - t, time);
    may_change = false;
  }
  return safe;
}

}  // namespace raygauge
