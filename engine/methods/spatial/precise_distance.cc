// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/precise_distance.h"

#include <cmath>

#include "engine/methods/spatial/nearest_on_simplex.h"

namespace raygauge {
namespace {

constexpr int kMostIterations = 40;
constexpr double kUp = 1 + 0x1p-50, kDown = 1 - 0x1p-50;  // of rounding to a double

class PreciseDescent {
 public:
  PreciseDescent(PrecisePair& precise, double tolerance, SpatialAnswer& answer)
      : precise_(precise), tolerance_(tolerance), answer_(answer) {}

  bool begin();
  bool step();
  void record(const SpatialPair& pair);

 private:
  SimplexFace<DoubleDouble> reduce();
  PreciseVector3 direction(const PreciseVector3& v) const;
  PreciseVector3 combine(const SimplexFace<DoubleDouble>& face) const;
  bool holds(const PrecisePoint& w) const;
  void bound_from_above(const PreciseVector3& v);
  void bound_from_below(const PreciseVector3& u, const DoubleDouble& height);

  PrecisePair& precise_;
  double tolerance_;
  SpatialAnswer& answer_;
  int count_ = 0;
  PrecisePoint point_[4];
  double weight_[4] = {1, 0, 0, 0};
  int best_count_ = 0;
  PrecisePoint best_[4];
  double best_weight_[4] = {1, 0, 0, 0};
  PreciseVector3 normal_;
};

bool is_zero(const PreciseVector3& v) { return v.x.high == 0 && v.y.high == 0 && v.z.high == 0; }

bool PreciseDescent::begin() {
  const SpatialCombination& before = answer_.combination;
  for (int i = 0; i < before.count; ++i) {
    PrecisePoint point;
    const SpatialPoint& known = before.point[i];
    if (precise_.vertex(known.index_1, known.index_2, point) && !holds(point)) point_[count_++] = point;
  }
  if (count_ > 0) return true;
  Vector3 v;
  for (int i = 0; i < before.count; ++i) v = v + before.point[i].s * before.weight[i];
  const Vector3 u = answer_.lower > 0 ? answer_.normal : -v;
  if (!(dot(u, u) > 0)) return false;
  DoubleDouble height;
  point_[count_++] = precise_.support({{u.x, 0}, {u.y, 0}, {u.z, 0}}, height);
  return true;
}

bool PreciseDescent::holds(const PrecisePoint& w) const {
  for (int i = 0; i < count_; ++i) {
    if (is_zero(point_[i].s - w.s)) return true;
  }
  return false;
}

SimplexFace<DoubleDouble> PreciseDescent::reduce() {
  const PreciseVector3* points[4];
  for (int i = 0; i < count_; ++i) points[i] = &point_[i].s;
  const SimplexFace<DoubleDouble> face = nearest_face(points, count_);
  PrecisePoint kept[4];
  for (int i = 0; i < face.count; ++i) kept[i] = point_[face.corner[i]];
  for (int i = 0; i < face.count; ++i) {
    point_[i] = kept[i];
    weight_[i] = face.weight[i].rounded();
  }
  count_ = face.count;
  return face;
}

// Σ c_l s_l of the weights as they are, not negative, over their sum: a point of the simplex.
PreciseVector3 PreciseDescent::combine(const SimplexFace<DoubleDouble>& face) const {
  PreciseVector3 v;
  DoubleDouble sum;
  for (int i = 0; i < face.count; ++i) {
    v = v + point_[i].s * face.weight[i];
    sum = sum + face.weight[i];
  }
  return v * (DoubleDouble{1} / sum);
}

// Of length 1 in about, from the simplex to the origin.
PreciseVector3 PreciseDescent::direction(const PreciseVector3& v) const {
  PreciseVector3 u = -v;
  if (count_ == 2) {
    const double size = 1 / std::sqrt(dot(u, u).high);
    u = u * DoubleDouble{size};
    const PreciseVector3 edge = point_[1].s - point_[0].s;
    u = u - edge * (dot(u, edge) / dot(edge, edge));
  } else if (count_ == 3) {
    u = triangle_normal(point_[0].s, point_[1].s, point_[2].s);
    if (dot(u, point_[0].s).high > 0) u = -u;
  }
  const double square = dot(u, u).high;
  return square > 0 ? u * DoubleDouble{1 / std::sqrt(square)} : PreciseVector3{};
}

void PreciseDescent::bound_from_above(const PreciseVector3& v) {
  const PreciseVector3 point = precise_.through_balls(v);
  const double upper = (sqrt(dot(point, point)).rounded() + precise_.error()) * kUp;
  if (!(upper < answer_.upper) && best_count_ > 0) return;
  answer_.upper = upper;
  best_count_ = count_;
  for (int i = 0; i < count_; ++i) {
    best_[i] = point_[i];
    best_weight_[i] = weight_[i];
  }
}

void PreciseDescent::bound_from_below(const PreciseVector3& u, const DoubleDouble& height) {
  const double size = sqrt(dot(u, u)).rounded() * kUp;
  const double lower = (-height.rounded() / size) * kDown - precise_.error();
  if (!(lower > answer_.lower)) return;
  answer_.lower = lower;
  answer_.normal = {u.x.high, u.y.high, u.z.high};
  normal_ = u;
}

bool PreciseDescent::step() {
  const SimplexFace<DoubleDouble> face = reduce();
  const PreciseVector3 v = combine(face);
  const double size = std::sqrt(dot(v, v).high);
  if (face.depth.high > 2 * precise_.error() || precise_.balls_meet(size * kUp)) {
    answer_.end = SpatialEnd::intersecting;
    return false;
  }
  bound_from_above(v);
  if (count_ == 4 || !(size > precise_.error())) return false;
  const PreciseVector3 u = direction(v);
  if (is_zero(u)) return false;
  DoubleDouble height;
  const PrecisePoint w = precise_.support(u, height);
  bound_from_below(u, height);
  if (answer_.lower > 0 && answer_.upper - answer_.lower <= tolerance_ * answer_.upper) {
    answer_.end = SpatialEnd::closed;
    return false;
  }
  if (holds(w)) return false;
  point_[count_++] = w;
  return true;
}

// The closest points and the normal, in the frame of the first body.
void PreciseDescent::record(const SpatialPair& pair) {
  SpatialCombination& combination = answer_.combination;
  combination.count = best_count_;
  for (int i = 0; i < best_count_; ++i) {
    SpatialPoint& point = combination.point[i];
    point.a1 = best_[i].x1;
    point.a2 = pair.from_second(best_[i].x2);
    point.s = point.a1 - point.a2;
    point.index_1 = best_[i].index_1;
    point.index_2 = best_[i].index_2;
    combination.weight[i] = best_weight_[i];
  }
  const double normal[3] = {normal_.x.high, normal_.y.high, normal_.z.high};
  answer_.normal = pair.to_body(normal);
}

}  // namespace

void precise_distance(const SpatialPair& pair, const Posed& first, const Posed& second,
                      const Kernels& kernels, double tolerance, SpatialAnswer& answer) {
  PrecisePair precise;
  if (!precise.bind(pair, first, second, kernels)) return;
  const double lower = answer.lower;
  answer.lower = 0;
  PreciseDescent descent(precise, tolerance, answer);
  if (descent.begin()) {
    for (int i = 0; i < kMostIterations && descent.step(); ++i) ++answer.iterations;
  }
  if (answer.end == SpatialEnd::open) {
    answer.lower = lower;
    return;
  }
  descent.record(pair);
}

}  // namespace raygauge
