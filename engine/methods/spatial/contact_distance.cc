// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/contact_distance.h"

#include <algorithm>
#include <cmath>

#include "engine/methods/spatial/contact_program.h"

namespace raygauge {
namespace {

constexpr int kMostSteps = 16;
constexpr double kConverged = 1e-15;  // radians that the next step would go
constexpr double kLongestStep = 0.5, kShorter = 0.3;
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
  void begin();
  void add(const SpatialPoint& point, double weight);
  bool shares(int k, int i, int body) const;
  void follow(int i);
  Matrix3 hessian() const;
  void add_other_rims(const SpatialPoint& point);
  bool try_discs();
  bool try_disc(int i, const Vector3& v);
  bool look(double& height);
  bool step();
  void record(const ContactStep<double>& found);
  void bound(const Vector3& v);

  SpatialPair& pair_;
  double tolerance_;
  SpatialAnswer& answer_;
  Vector3 u_;
  SpatialPoint piece_[kMostContactPieces];
  double weight_[kMostContactPieces];
  int count_ = 0;
  double last_step_ = 1;
  double longest_step_ = kLongestStep;
  double lowest_ = 1e300;  // height met, at lowest_u_
  Vector3 lowest_u_;
  bool tried_[2] = {false, false};
};

void ContactDescent::add(const SpatialPoint& point, double weight) {
  for (int i = 0; i < count_; ++i) {
    if (!piece_[i].has_same_pieces(point)) continue;
    weight_[i] += weight;
    return;
  }
  if (count_ == kMostContactPieces) return;
  piece_[count_] = point;
  weight_[count_++] = weight;
}

// Whether pieces k and i have the same point of a core for any normal, or the core is made of vertices.
bool ContactDescent::shares(int k, int i, int body) const {
  return !is_curved(pair_.shape(body)) || piece_[k].index(body) == piece_[i].index(body);
}

// Piece i at u_, where those before it are.
void ContactDescent::follow(int i) {
  for (int k = 0; k < i; ++k) {
    if (!shares(k, i, 0) || !shares(k, i, 1)) continue;
    SpatialPoint& point = piece_[i];
    if (point.index_1 < 0) point.a1 = piece_[k].a1;
    if (point.index_2 < 0) point.a2 = piece_[k].a2;
    point.s = point.a1 - point.a2;
    return;
  }
  pair_.follow(u_, piece_[i]);
}

// Of the pieces with their weights, once for those that differ in vertices alone.
Matrix3 ContactDescent::hessian() const {
  Matrix3 H;
  double weight[kMostContactPieces];
  for (int i = 0; i < count_; ++i) {
    weight[i] = weight_[i];
    int k = 0;
    while (k < i && !(shares(k, i, 0) && shares(k, i, 1))) ++k;
    if (k == i) continue;
    weight[k] += weight[i];
    weight[i] = 0;
  }
  for (int i = 0; i < count_; ++i) {
    if (weight[i] > 0) pair_.add_hessian(u_, piece_[i], weight[i], H);
  }
  return H;
}

// The pieces that differ from `point` in one rim.
void ContactDescent::add_other_rims(const SpatialPoint& point) {
  for (int i = 0; i < 2; ++i) {
    SpatialPoint other = point;
    other.index(i) = other_piece(pair_.shape(i), point.index(i));
    if (other.index(i) == point.index(i)) continue;
    const int known = count_;
    add(other, 0);
    if (count_ > known) follow(known);
  }
}

void ContactDescent::begin() {
  const SpatialCombination& before = answer_.combination;
  u_ = answer_.hint * (1 / length(answer_.hint));
  for (int i = 0; i < before.count; ++i) {
    SpatialPoint point = before.point[i];
    pair_.follow(u_, point);
    add(point, before.weight[i]);
  }
}

// By v, a point of the difference of the cores that the combination has.
void ContactDescent::bound(const Vector3& v) {
  answer_.bound_from_above(upper_bound(pair_, length(v)));
  if (answer_.upper < 0) answer_.end = SpatialEnd::intersecting;
}

// v is a direction from the disc of frustum i outward, near its axis.
bool ContactDescent::try_disc(int i, const Vector3& v) {
  const CoreDisc disc = disc_towards(pair_.shape(i), v);
  const Vector3 n = i == 0 ? disc.normal : -(pair_.rotation() * disc.normal);
  SpatialPoint point;
  pair_.support(n, point);
  const Vector3 center = i == 0 ? disc.center : pair_.from_second(disc.center);
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
  answer_.bound_from_below(lower_bound(pair_, dot(n, point.s)), n);
  bound(point.s);
  answer_.closes(tolerance_);
  return true;
}

// True where the contact is on a disc.
bool ContactDescent::try_discs() {
  for (int i = 0; i < 2; ++i) {
    if (tried_[i] || !has_discs(pair_.shape(i))) continue;
    const Vector3 v = i == 0 ? u_ : pair_.rotation().transposed_times(-u_);
    const double along = dot(v, disc_towards(pair_.shape(i), v).normal);
    if (1 - along * along > kNearAxis * kNearAxis) continue;
    tried_[i] = true;
    if (try_disc(i, v)) return true;
  }
  return false;
}

void ContactDescent::record(const ContactStep<double>& found) {
  SpatialCombination& combination = answer_.combination;
  SpatialPoint kept[3];
  for (int i = 0; i < found.count; ++i) kept[i] = piece_[found.piece[i]];
  Vector3 v;
  count_ = 0;
  for (int i = 0; i < found.count; ++i) {
    const double weight = std::clamp(found.weight[i], 0.0, 1.0);
    add(kept[i], weight);
    combination.point[i] = kept[i];
    combination.weight[i] = weight;
    v = v + kept[i].s * weight;
  }
  combination.count = found.count;
  answer_.hint = u_;
  bound(v);
}

// The height at u_, with all pieces following it; after a step too long, back at the u_ of before, with the
// piece that the step met. False where a short step went up: that is for double-double arithmetic.
bool ContactDescent::look(double& height) {
  SpatialPoint w;
  pair_.support(u_, w);
  height = dot(u_, w.s);
  answer_.bound_from_below(lower_bound(pair_, height), u_);
  if (height > lowest_ + kNoise * pair_.error()) {
    if (last_step_ < kShortStep) return false;
    u_ = lowest_u_;
    height = lowest_;
    longest_step_ = kShorter * std::min(longest_step_, last_step_);
    pair_.follow(u_, w);
  } else {
    lowest_ = height;
    lowest_u_ = u_;
  }
  for (int i = 0; i < count_; ++i) follow(i);
  add(w, count_ == 0 ? 1 : 0);
  add_other_rims(w);
  return true;
}

// False where there is nothing to be gained.
bool ContactDescent::step() {
  double height = 0;
  if (!look(height)) return false;
  const Matrix3 H = hessian();
  const double size = H.column[0].x + H.column[1].y + H.column[2].z;
  const TangentMetric metric(u_, H,
                             std::fabs(height) + kDamping * last_step_ * last_step_ * size + pair_.error());
  ContactPiece<double> pieces[kMostContactPieces];
  for (int i = 0; i < count_; ++i) {
    pieces[i].height = dot(u_, piece_[i].s);
    metric.image(dot(metric.tangent[0], piece_[i].s), dot(metric.tangent[1], piece_[i].s), pieces[i].slope);
  }
  const ContactStep<double> found = contact_step(pieces, count_);
  record(found);
  if (answer_.end != SpatialEnd::open || answer_.closes(tolerance_)) return false;
  if (answer_.upper - answer_.lower <= kPreciseGap * pair_.error()) return false;
  double d[2];
  metric.step(found.y, d);
  const double long_by = std::hypot(d[0], d[1]);
  const double share = long_by > longest_step_ ? longest_step_ / long_by : 1.0;
  const bool converged = long_by * std::max(long_by, kDamping * last_step_ * last_step_) < kConverged;
  last_step_ = std::min(long_by, 1.0);
  u_ = u_ + metric.tangent[0] * (d[0] * share) + metric.tangent[1] * (d[1] * share);
  u_ = u_ * (1 / length(u_));
  return !converged;
}

void ContactDescent::run() {
  if (!(dot(answer_.hint, answer_.hint) > 0)) return;
  begin();
  for (int i = 0; i < kMostSteps; ++i, ++answer_.iterations) {
    if (try_discs() || !step()) return;
  }
}

}  // namespace

void contact_distance(SpatialPair& pair, double tolerance, SpatialAnswer& answer) {
  answer.end = SpatialEnd::open;
  ContactDescent(pair, tolerance, answer).run();
}

}  // namespace raygauge
