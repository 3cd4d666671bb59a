// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/precise_distance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/methods/spatial/active_pieces.h"
#include "engine/methods/spatial/gjk.h"
#include "engine/numerics/fused.h"

namespace raygauge {
namespace {

constexpr int kMostIterations = 40;
constexpr int kMostCurvedIterations = 10;  // Newton steps: they end soon or not at all
constexpr int kMostProjections = 3;
constexpr double kDamping = 1e-2;  // of the last of them
constexpr double kLongestStep = 0.5;
constexpr double kSmallStep = 1e-12;     // what Newton steps on overlapping cores have to gain
constexpr double kLargestScale = 1e280;  // of a normal that is not zero
constexpr double kUp = 1 + 0x1p-50, kDown = 1 - 0x1p-50;  // of rounding to doubles, and a length of them

class PreciseDescent {
 public:
  PreciseDescent(PrecisePair& precise, double tolerance, SpatialAnswer& answer)
      : precise_(precise), tolerance_(tolerance), answer_(answer), before_(answer.combination) {}

  void run();
  void record();

 private:
  bool begin_at_vertices();
  bool begin_on_curves();
  void approach();
  bool step_on_face();
  void begin_opposite_longest_edge();
  bool nearest_on_face(PreciseVector3* edge, PreciseVector3& v);
  bool closes_on_pieces();
  bool look(const PreciseVector3& v, const PreciseVector3& u);
  bool disc_step();
  bool projection_steps();
  bool gather();
  bool curved_step();
  bool conclude(const PreciseVector3& v, const PrecisePoint& pair_of_points);
  bool is_closed() { return answer_.closes(tolerance_); }
  void bound_from_above(double length);
  void bound_from_below(const PreciseVector3& u, const DoubleDouble& height);

  PrecisePair& precise_;
  double tolerance_;
  SpatialAnswer& answer_;
  const SpatialCombination& before_;  // as doubles left it, until record()
  ActivePieces<PrecisePair> now_;     // proves the upper bound
  PreciseVector3 u_;                  // of steps on curved cores
  double last_step_ = 0;
  bool bounded_ = false;  // from above, by now_
  bool within_ = false;   // the cores overlap at u_, if not proven yet
};

bool PreciseDescent::begin_at_vertices() {
  const SpatialCombination& before = answer_.combination;
  for (int i = 0; i < before.count; ++i) {
    PrecisePoint point;
    const SpatialPoint& known = before.point[i];
    if (precise_.vertex(known.index_1, known.index_2, point) && !holds(now_, point))
      now_.point[now_.count++] = point;
  }
  return now_.count > 0;
}

// With the best normal of before and the pieces of its combination.
bool PreciseDescent::begin_on_curves() {
  const Vector3& u = answer_.hint;
  if (!(dot(u, u) > 0)) return false;
  u_ = precise(precise_.to_world(u * (1 / length(u))));
  now_.begin(before_);
  return true;
}

void PreciseDescent::run() {
  if (before_.count == 1 && projection_steps()) return;
  if (!precise_.is_curved()) {
    if (!begin_at_vertices()) return;
    if (!step_on_face()) approach();
    return;
  }
  if (before_.count == 1 && disc_step()) return;
  if (!begin_on_curves()) return;
  for (int i = 0; i < kMostCurvedIterations && curved_step(); ++i) ++answer_.iterations;
  if (answer_.end != SpatialEnd::open) return;
  // Sharp edges that overlap, for instance: no point of one edge need be inside the other body.
  approach();
}

// By the length of a vector of D that the combination has.
void PreciseDescent::bound_from_above(double length) {
  answer_.bounds.reduce_upper(upper_bound(precise_, length));
  bounded_ = true;
}

void PreciseDescent::bound_from_below(const PreciseVector3& u, const DoubleDouble& height) {
  const double lower = lower_bound(precise_, u, height);
  if (lower > answer_.bounds.lower()) answer_.raise_lower(lower, precise_.to_first(u));
}

// The bounds of v, a point of the simplex, and of u; the support point for u joins the simplex. False where
// the solve is done or that one is known.
bool PreciseDescent::look(const PreciseVector3& v, const PreciseVector3& u) {
  PrecisePoint& w = now_.point[now_.count];
  const DoubleDouble height = precise_.support_parts(u, w);
  bound_from_above(precise_.length_beyond_balls(v, u));
  bound_from_below(u, height);
  if (is_closed()) return false;
  precise_.place(w);
  if (holds(now_, w)) return false;
  ++now_.count;
  return true;
}

// Until nothing is to be gained.
RAYGAUGE_FUSED void PreciseDescent::approach() {
  Gjk<PrecisePair, ActivePieces<PrecisePair>> steps(precise_, tolerance_, now_, answer_);
  for (int i = 0; i < kMostIterations && steps.step(); ++i) ++answer_.iterations;
}

// The two shorter edges of a triangle meet there, where their cross product loses least.
void PreciseDescent::begin_opposite_longest_edge() {
  const auto square = [&](int i, int k) {
    const Vector3 e = before_.point[i].s - before_.point[k].s;
    return dot(e, e);
  };
  const double of_0 = square(1, 2), of_1 = square(0, 2), of_2 = square(0, 1);
  const int first = of_0 >= of_1 && of_0 >= of_2 ? 0 : of_1 >= of_2 ? 1 : 2;
  if (first == 0) return;
  std::swap(now_.point[0], now_.point[first]);
  std::swap(now_.weight[0], now_.weight[first]);
}

// v = s_0 + Σ c_i e_i with the weights of doubles, brought nearer to the origin by Δ = -(EᵀE)⁻¹Eᵀv: that Δ
// need not be precise, as an error of δ in v across the way to the origin adds δ²/2|v| to that. False where
// the nearest point of the face's plane is not in the face.
bool PreciseDescent::nearest_on_face(PreciseVector3* edge, PreciseVector3& v) {
  const int edges = now_.count - 1;
  double g[2][2] = {{1, 0}, {0, 1}}, r[2] = {0, 0};
  v = now_.point[0].s;
  if (edges == 0) return true;
  for (int i = 0; i < edges; ++i) {
    edge[i] = now_.point[i + 1].s - now_.point[0].s;
    v = v + edge[i] * DoubleDouble{now_.weight[i + 1]};
  }
  for (int i = 0; i < edges; ++i) {
    r[i] = dot(rounded(v), rounded(edge[i]));
    for (int k = 0; k < edges; ++k) g[i][k] = dot(rounded(edge[i]), rounded(edge[k]));
  }
  const double determinant = g[0][0] * g[1][1] - g[0][1] * g[1][0];
  if (!(determinant > 0)) return false;
  const double change[2] = {(g[0][1] * r[1] - g[1][1] * r[0]) / determinant,
                            (g[1][0] * r[0] - g[0][0] * r[1]) / determinant};
  double rest = 1 - 0x1p-50;
  for (int i = 0; i < edges; ++i) {
    v = v + edge[i] * DoubleDouble{change[i]};
    now_.weight[i + 1] += change[i];
    rest -= now_.weight[i + 1];
    if (!(now_.weight[i + 1] >= 0)) return false;
  }
  now_.weight[0] = rest;
  return rest >= 0;
}

// The first step, if the face of before is the nearest one: without nearest_face. True where the solve is
// done.
RAYGAUGE_FUSED bool PreciseDescent::step_on_face() {
  if (now_.count > 3 || now_.count != before_.count) return false;
  for (int i = 0; i < now_.count; ++i) now_.weight[i] = before_.weight[i];
  if (now_.count == 3) begin_opposite_longest_edge();
  PreciseVector3 edge[2], v;
  if (!nearest_on_face(edge, v)) return false;
  const double size = length(rounded(v));
  if (precise_.balls_meet(size * kUp)) {
    answer_.end = SpatialEnd::intersecting;
    return true;
  }
  if (!(size > precise_.error())) return false;
  PreciseVector3 u = v * DoubleDouble{-1 / size};
  if (now_.count == 1) {
    u = precise(rounded(u));
  } else if (now_.count == 2) {
    u = u - edge[0] * DoubleDouble{dot(u, edge[0]).high / dot(rounded(edge[0]), rounded(edge[0]))};
  } else {
    u = cross(edge[0], edge[1]);
    const double scale = 1 / length(rounded(u));
    if (!(scale < kLargestScale)) return false;
    u = u * DoubleDouble{dot(u, v).high > 0 ? -scale : scale};
  }
  return !look(v, u);
}

// Draws the conclusions from v, a point of the simplex, and the points that it is the difference of. True
// where the solve is done.
bool PreciseDescent::conclude(const PreciseVector3& v, const PrecisePoint& points) {
  const Vector3 near = rounded(v);
  within_ = dot(rounded(u_), near) > 0;
  if ((within_ && precise_.overlap(u_, points)) || precise_.balls_meet(length(near) * kUp)) {
    answer_.end = SpatialEnd::intersecting;
    return true;
  }
  bound_from_above(length(rounded(precise_.through_balls(v))));
  return is_closed();
}

// On the disc that the combination names. True where that is all.
RAYGAUGE_FUSED bool PreciseDescent::disc_step() {
  const SpatialPoint& known = before_.point[0];
  const int i = known.index_1 <= FrustumCore::kBaseDisc ? 0 : 1;
  const std::int32_t index = i == 0 ? known.index_1 : known.index_2;
  if (index > FrustumCore::kBaseDisc) return false;
  DoubleDouble height;
  if (!precise_.disc_contact(i, index, u_, height, now_.point[0])) return false;
  now_.count = 1;
  now_.weight[0] = 1;
  bound_from_below(u_, height);
  return conclude(now_.point[0].s, now_.point[0]);
}

// From the nearest points in doubles of a core and the centre of a ball. True where that is all.
bool PreciseDescent::projection_steps() {
  PrecisePoint point;
  point.a1 = precise(before_.point[0].a1);
  point.a2 = precise(precise_.in_doubles().frame().to_second(before_.point[0].a2));
  for (int i = 0; i < kMostProjections; ++i) {
    if (!precise_.project(point)) return false;
    const double size = length(rounded(point.s));
    if (precise_.balls_meet(size * kUp)) {
      answer_.end = SpatialEnd::intersecting;
      return true;
    }
    if (!(size > precise_.error())) break;
    now_.point[0] = point;
    now_.weight[0] = 1;
    now_.count = 1;
    const PreciseVector3 u = point.s * DoubleDouble{-1 / size};
    const DoubleDouble height = precise_.height(u);
    bound_from_above(precise_.length_beyond_balls(point.s, u));
    bound_from_below(u, height);
    if (is_closed()) return true;
    ++answer_.iterations;
  }
  now_.count = 0;
  return false;
}

// The pieces at u_, and what joins them there; at first those that doubles found do, as the lower bound of
// their normal is too coarse. False where the bounds meet.
bool PreciseDescent::gather() {
  if (!bounded_ && now_.count > 0) {
    now_.follow(precise_, u_, nullptr);
    if (now_.count > 0) return true;
  }
  DoubleDouble height;
  const PrecisePoint w = precise_.support(u_, height);
  bound_from_below(u_, height);
  if (bounded_ && is_closed()) return false;
  now_.follow(precise_, u_, &w);
  return true;
}

// With the weights of the step before.
bool PreciseDescent::closes_on_pieces() {
  if (!bounded_ || now_.count > 3) return false;
  double before[4];
  std::copy_n(now_.weight, 4, before);
  PreciseVector3 edge[2], v;
  if (nearest_on_face(edge, v)) {
    bound_from_above(length(rounded(precise_.through_balls(v))));
    if (is_closed()) return true;
  }
  std::copy_n(before, 4, now_.weight);
  return false;
}

// A step of contact_distance, whose pieces are all that is left of the bodies.
RAYGAUGE_FUSED bool PreciseDescent::curved_step() {
  if (!gather() || closes_on_pieces()) return false;
  const double height_of_cores = std::fabs(dot(rounded(u_), rounded(now_.point[0].s)));
  const TangentMetric metric = now_.metric(precise_, u_, height_of_cores, kDamping * last_step_ * last_step_);
  const ContactStep<DoubleDouble> found =
      now_.step(metric, u_, [this](int i) -> const PreciseVector3& { return now_.point[i].s; });
  now_.keep(found);
  const PrecisePoint points = now_.combine(found);
  if (conclude(points.s, points)) return false;
  last_step_ = turn(metric, found.y, kLongestStep, u_);
  if (within_ && !(last_step_ > kSmallStep)) return false;
  last_step_ = std::min(last_step_, 1.0);
  return last_step_ > 0;
}

// The closest points and the normal, in the frame of the first body.
void PreciseDescent::record() {
  if (answer_.end == SpatialEnd::open) return;
  SpatialCombination& combination = answer_.combination;
  combination.count = answer_.end == SpatialEnd::closed ? now_.count : 0;
  for (int i = 0; i < combination.count; ++i) {
    SpatialPoint& point = combination.point[i];
    point.a1 = rounded(now_.point[i].a1);
    point.a2 = precise_.in_doubles().frame().from_second(rounded(now_.point[i].a2));
    point.s = point.a1 - point.a2;
    point.index_1 = std::max(now_.point[i].index_1, kSmoothPiece);
    point.index_2 = std::max(now_.point[i].index_2, kSmoothPiece);
    combination.weight[i] = now_.weight[i];
  }
}

}  // namespace

void precise_distance(const SpatialPair& pair, double tolerance, SpatialAnswer& answer) {
  PrecisePair precise;
  if (!precise.bind(pair)) return;
  PreciseDescent descent(precise, tolerance, answer);
  descent.run();
  descent.record();
}

}  // namespace raygauge
