// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/soak/random_motions.h"

#include <cmath>
#include <limits>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/numerics/number_text.h"
#include "raygauge/sets/ball.h"
#include "tests/soak/exact_motions.h"
#include "tests/soak/random_set.h"

namespace raygauge::soak {
namespace {

using Outcome = ImpactResult::Outcome;

constexpr int kMoments = 24;       // of the grid
constexpr int kNarrowings = 28;    // of a golden section: to 1e-6 of the grid's step; of a bisection: to 4e-9
constexpr double kOverlap = 1e-9;  // bodies overlap clearly where they do so when shrunk by this share

// Limits are what only the general methods have: they send a query their way.
DistanceOptions options_of(bool general) {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  options.tolerance = 1e-6;
  if (!general) return options;
  options.time_limit = 1;
  options.max_iterations = 100000;
  return options;
}

/// A motion that can be shifted as a whole.
struct MotionDraw {
  std::vector<double> times;
  std::vector<Placement> frames;  ///< one: a twist with these rates
  TwistMotion::Rates rates;

  MotionPointer shifted(const SmallVector& by) const {
    std::vector<Placement> moved = frames;
    for (Placement& frame : moved) frame.t += by;
    if (moved.size() == 1) return std::make_shared<TwistMotion>(moved[0], rates, 0.0);
    return std::make_shared<KeyframeMotion>(times, std::move(moved));
  }
};

SmallVector draw_vector(RandomStream& stream, int n, double length) {
  return SmallVector(draw_direction(stream, n) * (length * stream.uniform()));
}

Placement draw_placement(RandomStream& stream, int n, double reach) {
  Placement where = Placement::identity(n);
  where.t = draw_vector(stream, n, reach);
  const double angle = stream.uniform() < 0.3 ? std::acos(0.0) * static_cast<double>(stream.integer(0, 3))
                                              : 6 * stream.uniform();
  where.R =
      n == 2 ? plane_rotation(angle) : rotation_about(Eigen::Vector3d(draw_direction(stream, 3) * angle));
  return where;
}

// A third of the twists spin up to ten times in the second that they last.
MotionDraw draw_motion(RandomStream& stream, int n) {
  MotionDraw motion;
  motion.frames = {draw_placement(stream, n, 4)};
  motion.rates.velocity = motion.rates.acceleration = SmallVector::Zero(n);
  const double kind = stream.uniform();
  if (kind < 0.2) return motion;
  if (kind < 0.7) {
    const double spin = stream.uniform() < 0.33 ? 60 : 6;
    motion.rates.velocity = SmallVector(-motion.frames[0].t) + draw_vector(stream, n, 3);
    motion.rates.acceleration = draw_vector(stream, n, 2);
    if (n == 2) motion.rates.spin = {0, 0, spin * (2 * stream.uniform() - 1)};
    if (n == 3) motion.rates.spin = draw_direction(stream, 3) * (spin * stream.uniform());
    return motion;
  }
  motion.times = {0, 0.2 + 0.6 * stream.uniform(), 1};
  motion.frames.push_back(draw_placement(stream, n, 1));
  motion.frames.push_back(draw_placement(stream, n, 4));
  return motion;
}

Pose pose_at(const Body& body, double t) {
  const Placement where = body.motion->at(t);
  return {where.R, where.t};
}

// How fast the bodies can approach each other at any time of [0, 1], at most.
double closing_speed(const Body& a, const Body& b) {
  double speed = 0;
  for (const Body* body : {&a, &b}) {
    double fastest = 0;
    for (double t = 0; t < 1; t = body->motion->next_break(t))
      fastest = std::max(
          fastest, body->motion->bound(t, std::min(1.0, body->motion->next_break(t))).speed(body->reach));
    speed += fastest;
  }
  return speed;
}

}  // namespace

struct RandomMotions::Pair {
  RandomSet A, B;
  MotionDraw motion_A, motion_B;
  Ball euclidean;
  bool general = false;  ///< whether the general methods are to compute the distances
  Body a, b;

  int n() const { return a.dimension(); }
  void place(const SmallVector& shift_of_B) {
    a = make_body(A.label, {A.set}, motion_A.shifted(SmallVector::Zero(A.set->dimension())));
    b = make_body(B.label, {B.set}, motion_B.shifted(shift_of_B));
  }
};

RandomMotions::RandomMotions(std::uint64_t seed)
    : seed_(seed),
      distance_(options_of(false)),
      general_distance_(options_of(true)),
      growth_(options_of(true)) {}

DistanceResult RandomMotions::distance(const Pair& pair, double t) {
  ++tally_.tests;
  ObjectDistanceSolver& solver = pair.general ? general_distance_ : distance_;
  return solver.solve({*pair.A.set, pose_at(pair.a, t)}, {*pair.B.set, pose_at(pair.b, t)}, pair.euclidean)
      .distance;
}

bool RandomMotions::overlap(const Pair& pair, double t) {
  ++tally_.tests;
  return growth_.solve_about_centers({*pair.A.set, pose_at(pair.a, t)}, {*pair.B.set, pose_at(pair.b, t)})
             .upper < 1 - kOverlap;
}

/// Near the least distance of the grid over [from, to], by a golden section beside it.
double RandomMotions::nearest_moment(const Pair& pair, double from, double to) {
  const double step = (to - from) / kMoments;
  double best = from, least = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= kMoments; ++k) {
    const double found = distance(pair, from + k * step).upper;
    if (found < least) std::tie(best, least) = std::pair(from + k * step, found);
  }
  double low = std::max(from, best - step), high = std::min(to, best + step);
  const double share = (std::sqrt(5.0) - 1) / 2;
  double inner = high - share * (high - low), outer = low + share * (high - low);
  double at_inner = distance(pair, inner).upper, at_outer = distance(pair, outer).upper;
  const double speed = closing_speed(pair.a, pair.b);
  for (int k = 0; k < kNarrowings && std::min(at_inner, at_outer) > 0; ++k) {
    if (std::min(at_inner, at_outer) > speed * (high - low)) break;  // nothing touches in between
    if (at_inner < at_outer) {
      high = std::exchange(outer, inner);
      at_outer = at_inner;
      inner = high - share * (high - low);
      at_inner = distance(pair, inner).upper;
    } else {
      low = std::exchange(inner, outer);
      at_inner = at_outer;
      outer = low + share * (high - low);
      at_outer = distance(pair, outer).upper;
    }
  }
  if (at_inner < least) std::tie(best, least) = std::pair(inner, at_inner);
  return at_outer < least ? outer : best;
}

/// Bisects down to the first moment of a clear overlap, given that there is one at `last`.
double RandomMotions::first_overlap(const Pair& pair, double last) {
  double low = 0, high = last;
  for (int k = 0; k <= kMoments; ++k) {
    const double t = last * k / kMoments;
    if (overlap(pair, t)) {
      high = t;
      break;
    }
    low = t;
  }
  for (int k = 0; k < kNarrowings && low < high; ++k) {
    const double middle = low + (high - low) / 2;
    if (overlap(pair, middle)) {
      high = middle;
    } else {
      low = middle;
    }
  }
  return high;
}

/// Shifts B so that the least distance becomes about `gap`; false where it cannot be told which way.
bool RandomMotions::graze(Pair& pair, double gap) {
  const double t = nearest_moment(pair, 0, 1);
  const DistanceResult nearest = distance(pair, t);
  if (!(nearest.lower > 0) || nearest.normal.size() == 0) return false;
  const SmallVector u = nearest.normal.normalized();
  const SmallVector apart = pair.b.motion->at(t).t - pair.a.motion->at(t).t;
  const double side = u.dot(apart) >= 0 ? 1 : -1;
  pair.place(SmallVector(-u * (side * (nearest.upper - gap))));
  return true;
}

std::optional<std::string> RandomMotions::check_exact(RandomStream& stream, std::int64_t number) {
  ExactMotion motion(stream);
  bool undecided = false;
  const auto wrong = motion.check(undecided);
  ++tally_.exact;
  tally_.exact_undecided += undecided ? 1 : 0;
  if (!wrong) return std::nullopt;
  return "motion " + std::to_string(number) + ": " + *wrong;
}

std::optional<std::string> RandomMotions::check(std::int64_t number) {
  RandomStream stream({seed_, 2, static_cast<int>(number >> 31), static_cast<int>(number & 0x7fffffff)},
                      "random_motions", RandomPurpose::shape);
  if (number % 3 == 2) return check_exact(stream, number);
  const int n = stream.uniform() < 0.8 ? 3 : 2;
  Pair pair{draw_set(stream, Vector::Zero(n), 1, 0),
            draw_set(stream, Vector::Zero(n), 1, 0),
            draw_motion(stream, n),
            draw_motion(stream, n),
            Ball(Vector::Zero(n), 1.0),
            number % 50 == 0,
            {},
            {}};
  pair.place(SmallVector::Zero(n));
  const double gap = std::pow(10.0, -9 * stream.uniform()) * (stream.uniform() < 0.5 ? 1 : -1);
  ++tally_.motions;
  if (stream.uniform() < 0.3 && graze(pair, gap)) ++tally_.grazing;
  ContinuousOptions over;
  over.to = 1;
  over.max_steps = 100'000;
  ContinuousSolver solver(n);
  const ImpactResult impact = solver.time_of_impact(pair.a, pair.b, over);
  tally_.contacts += impact.outcome == Outcome::contact ? 1 : 0;
  tally_.free += impact.outcome == Outcome::free ? 1 : 0;
  tally_.undecided += impact.outcome == Outcome::undecided ? 1 : 0;
  std::string wrong;
  if (impact.outcome == Outcome::contact && distance(pair, impact.upper).lower > over.contact * (1 + 1e-6))
    wrong = "no contact at " + shortest_text(impact.upper);
  const double last = impact.outcome == Outcome::free ? 1 : impact.lower;
  const double nearest = last > 0 ? nearest_moment(pair, 0, last) : 0;
  if (last > 0 && overlap(pair, nearest)) {
    const double first = first_overlap(pair, nearest);
    if (first < last && !(distance(pair, first).lower > 0))
      wrong = "overlap at " + shortest_text(first) + ", before " + shortest_text(last);
  }
  if (wrong.empty()) return std::nullopt;
  return pair.A.label + " and " + pair.B.label + " in R^" + std::to_string(n) + ", motion " +
         std::to_string(number) + ": " + wrong;
}

std::string to_string(const MotionTally& tally) {
  return std::to_string(tally.motions) + " motions (" + std::to_string(tally.grazing) +
         " grazing): " + std::to_string(tally.contacts) + " contacts, " + std::to_string(tally.free) +
         " free, " + std::to_string(tally.undecided) + " undecided; " + std::to_string(tally.tests) +
         " exact tests; " + std::to_string(tally.exact) + " motions known in quadruple precision, " +
         std::to_string(tally.exact_undecided) + " undecided\n";
}

}  // namespace raygauge::soak
