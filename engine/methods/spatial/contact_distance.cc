// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/contact_distance.h"

#include <algorithm>
#include <cmath>

#include "engine/methods/spatial/active_pieces.h"
#include "engine/methods/spatial/tuning.h"
#include "engine/numerics/fused.h"

namespace raygauge {
namespace {

constexpr int kMostSteps = 16;
constexpr double kConverged = 1e-15;  // radians that the step after the next would go
constexpr double kLongEnough = 0.1;   // a step after which other rims may count
constexpr double kNoise = 8;          // a rise of so many error() is rounding
constexpr double kShortStep = 1e-3;   // a step that rises although it is shorter is made of rounding errors
constexpr double kPreciseGap = 64;    // of error(): from here double-double steps close it sooner
constexpr double kDamping = 1e-2;     // of the last step: superlinear, and safe far from the solution
constexpr double kNearAxis = 0.5;     // sine of the angle at which a disc is tried
constexpr double kInside = 1 - 1e-9;  // of a disc's radius

class ContactDescent {
 public:
  ContactDescent(SpatialPair& pair, double tolerance, SpatialAnswer& answer)
      : pair_(pair), tolerance_(tolerance), answer_(answer) {}

  void run();

 private:
  void add_other_rims(const SpatialPoint& point);
  bool try_discs();
  bool try_disc(int i, const Vector3& v);
  bool look(double& height);
  bool step();
  void bound_by_pieces();
  bool overlaps() const;
  void bound(const Vector3& v);
  void record();

  SpatialPair& pair_;
  double tolerance_;
  SpatialAnswer& answer_;
  Vector3 u_;
  ActivePieces<SpatialPair> pieces_;
  double last_step_ = 1;
  double longest_step_ = tuned::kLongestContactStep;
  double lowest_ = 1e300;  // height met, at lowest_u_
  Vector3 lowest_u_;
  bool bounded_ = false;    // by pieces_
  bool converged_ = false;  // what is left is to bound the distance at u_
  bool tried_[2] = {false, false};
};

// The pieces that differ from `point` in one rim.
void ContactDescent::add_other_rims(const SpatialPoint& point) {
  for (int i = 0; i < 2; ++i) {
    SpatialPoint other = point;
    other.index(i) = other_piece(pair_.shape(i), point.index(i));
    if (other.index(i) == point.index(i)) continue;
    if (pieces_.find(other) < pieces_.count) continue;
    pair_.follow(u_, other, &point);
    pieces_.add(other);
  }
}

// By v, a point of the difference of the cores that the combination has.
void ContactDescent::bound(const Vector3& v) {
  answer_.bounds.reduce_upper(upper_bound(pair_, length(v)));
  if (answer_.bounds.upper() < 0) answer_.end = SpatialEnd::intersecting;
}

// v is a direction from the disc of frustum i outward, near its axis.
bool ContactDescent::try_disc(int i, const Vector3& v) {
  const CoreDisc disc = disc_towards(pair_.shape(i), v);
  const Vector3 n = i == 0 ? disc.normal : -(pair_.frame().R * disc.normal);
  SpatialPoint point;
  pair_.support(n, point);
  const Vector3 center = i == 0 ? disc.center : pair_.frame().from_second(disc.center);
  Vector3 q = point.a(1 - i) - center;
  q = q - n * dot(n, q);
  if (!(length(q) < kInside * disc.radius)) return false;
  point.a(i) = center + q;
  point.index(i) = disc.index;
  point.s = point.a1 - point.a2;
  u_ = answer_.hint = n;
  answer_.combination.count = 1;
  answer_.combination.point[0] = point;
  answer_.combination.weight[0] = 1;
  answer_.raise_lower(lower_bound(pair_, dot(n, point.s)), n);
  bound(point.s);
  answer_.closes(tolerance_);
  return true;
}

// True where the contact is on a disc.
bool ContactDescent::try_discs() {
  for (int i = 0; i < 2; ++i) {
    if (tried_[i] || !has_discs(pair_.shape(i))) continue;
    const Vector3 v = i == 0 ? u_ : pair_.frame().R.transposed_times(-u_);
    const double along = dot(v, disc_towards(pair_.shape(i), v).normal);
    if (1 - along * along > kNearAxis * kNearAxis) continue;
    tried_[i] = true;
    if (try_disc(i, v)) return true;
  }
  return false;
}

void ContactDescent::bound_by_pieces() {
  Vector3 v;
  for (int i = 0; i < pieces_.count; ++i) v = v + pieces_.point[i].s * pieces_.weight[i];
  bounded_ = true;
  bound(v);
  if (dot(u_, v) > kNoise * pair_.error() && overlaps()) answer_.end = SpatialEnd::intersecting;
}

// Whether the points of the pieces with their weights prove it.
bool ContactDescent::overlaps() const {
  SpatialPoint sum = pieces_.point[0];
  sum.a1 = sum.a2 = {};
  for (int i = 0; i < pieces_.count; ++i) {
    sum.a1 = sum.a1 + pieces_.point[i].a1 * pieces_.weight[i];
    sum.a2 = sum.a2 + pieces_.point[i].a2 * pieces_.weight[i];
  }
  sum.s = sum.a1 - sum.a2;
  return pair_.overlap(u_, sum);
}

// What precise_distance goes on from.
void ContactDescent::record() {
  SpatialCombination& combination = answer_.combination;
  combination.count = pieces_.count;
  std::copy_n(pieces_.point, pieces_.count, combination.point);
  std::copy_n(pieces_.weight, pieces_.count, combination.weight);
}

// The height at u_, with all pieces following it; after a step too long, back at the u_ of before, with the
// piece that the step met. False where a short step went up: that is for double-double arithmetic.
bool ContactDescent::look(double& height) {
  SpatialPoint w;
  pair_.support(u_, w);
  height = dot(u_, w.s);
  answer_.raise_lower(lower_bound(pair_, height), u_);
  if (height > lowest_ + kNoise * pair_.error()) {
    if (last_step_ < kShortStep) return false;
    u_ = lowest_u_;
    height = lowest_;
    longest_step_ = tuned::kShorterContactStep * std::min(longest_step_, last_step_);
    pair_.follow(u_, w);
  } else {
    lowest_ = height;
    lowest_u_ = u_;
    const double longer = tuned::kLongerContactStep * longest_step_, longest = tuned::kLongestContactStep;
    if (last_step_ > longest_step_) longest_step_ = std::min(longer, longest);
  }
  pieces_.follow(pair_, u_, &w);
  if (last_step_ > kLongEnough) add_other_rims(w);
  return true;
}

// False where there is nothing to be gained.
bool ContactDescent::step() {
  double height = 0;
  if (!look(height)) return false;
  const TangentMetric metric =
      pieces_.metric(pair_, u_, std::fabs(height), kDamping * last_step_ * last_step_);
  const ContactStep<double> found =
      pieces_.step(metric, u_, [this](int i) -> const Vector3& { return pieces_.point[i].s; });
  pieces_.keep(found);
  answer_.hint = u_;
  bound_by_pieces();
  if (answer_.end != SpatialEnd::open || answer_.closes(tolerance_)) return false;
  if (converged_ || answer_.bounds.gap() <= kPreciseGap * pair_.error()) return false;
  const double long_by = turn(metric, found.y, longest_step_, u_);
  converged_ = long_by * std::max(long_by, kDamping * last_step_ * last_step_) < kConverged;
  last_step_ = std::min(long_by, 1.0);
  return true;
}

void ContactDescent::run() {
  if (!(dot(answer_.hint, answer_.hint) > 0)) return;
  u_ = answer_.hint * (1 / length(answer_.hint));
  pieces_.begin(answer_.combination);
  for (int i = 0; i < kMostSteps; ++i, ++answer_.iterations) {
    if (try_discs()) return;
    if (!step()) break;
  }
  if (bounded_) record();
}

}  // namespace

RAYGAUGE_FUSED void contact_distance(SpatialPair& pair, double tolerance, SpatialAnswer& answer) {
  answer.end = SpatialEnd::open;
  ContactDescent(pair, tolerance, answer).run();
}

}  // namespace raygauge
