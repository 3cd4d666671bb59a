// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/precise_distance.h"

#include <algorithm>
#include <cmath>

#include "engine/methods/spatial/nearest_on_simplex.h"

namespace raygauge {
namespace {

constexpr int kMostIterations = 40;
constexpr int kMostCurvedIterations = 10;                 // Newton steps: they end soon or not at all
constexpr double kUp = 1 + 0x1p-50, kDown = 1 - 0x1p-50;  // of rounding to a double

bool is_zero(const PreciseVector3& v) { return v.x.high == 0 && v.y.high == 0 && v.z.high == 0; }

PreciseVector3 precise(const Vector3& v) { return {{v.x, 0}, {v.y, 0}, {v.z, 0}}; }

// (H + λ) at u: λ along u and, across it, C Cᵀ with a lower triangular C.
class TangentMetric {
 public:
  TangentMetric(const SpatialPair& pair, const PreciseVector3& u, double lambda) : lambda_(lambda) {
    const double rounded[3] = {u.x.high, u.y.high, u.z.high};
    const Vector3 inner = pair.to_body(rounded);
    Vector3 tangent[2];
    tangent[0] = any_orthogonal(inner);
    tangent[1] = cross(inner, tangent[0]) * (1 / length(inner));
    Matrix3 H;
    pair.core_hessian(inner * (1 / length(inner)), H);
    const Vector3 H0 = H * tangent[0], H1 = H * tangent[1];
    const double a = dot(tangent[0], H0) + lambda, b = dot(tangent[0], H1), c = dot(tangent[1], H1) + lambda;
    trace_ = a + c;
    factor_[0] = std::sqrt(a);
    factor_[1] = b / factor_[0];
    factor_[2] = std::sqrt(std::fmax(c - factor_[1] * factor_[1], 1e-15 * trace_));
    for (int i = 0; i < 2; ++i) {
      double world[3] = {0, 0, 0};
      pair.to_world(tangent[i], world);
      tangent_[i] = precise({world[0], world[1], world[2]});
    }
  }

  double trace() const { return trace_; }

  // (λ^-½ u·s, C⁻¹ (t·s)), whose length is that of s in the metric of (H + λ)⁻¹.
  PreciseVector3 image(const PreciseVector3& u, const PreciseVector3& s) const {
    const DoubleDouble first = dot(tangent_[0], s) / DoubleDouble{factor_[0]};
    const DoubleDouble second = (dot(tangent_[1], s) - first * factor_[1]) / DoubleDouble{factor_[2]};
    return {dot(u, s) / DoubleDouble{std::sqrt(lambda_)}, first, second};
  }

  // -(H + λ)⁻¹ s, of length 1 in about, from the image of s.
  PreciseVector3 direction(const PreciseVector3& u, const PreciseVector3& image) const {
    const DoubleDouble second = image.z / DoubleDouble{factor_[2]};
    const DoubleDouble first = (image.y - second * factor_[1]) / DoubleDouble{factor_[0]};
    const double along = std::fabs(image.x.rounded()) / std::sqrt(lambda_);  // 1, but for rounding
    const PreciseVector3 next = u * DoubleDouble{along} - tangent_[0] * first - tangent_[1] * second;
    const double square = dot(next, next).high;
    return square > 0 ? next * DoubleDouble{1 / std::sqrt(square)} : PreciseVector3{};
  }

  PreciseVector3 tilted(const PreciseVector3& u, double first, double second) const {
    return u + tangent_[0] * DoubleDouble{first} + tangent_[1] * DoubleDouble{second};
  }

 private:
  double lambda_;
  double trace_ = 0;
  double factor_[3] = {0, 0, 0};
  PreciseVector3 tangent_[2];
};

class PreciseDescent {
 public:
  PreciseDescent(PrecisePair& precise, double tolerance, SpatialAnswer& answer)
      : precise_(precise), tolerance_(tolerance), answer_(answer), before_(answer.combination) {}

  void run(const SpatialPair& pair);
  void record(const SpatialPair& pair);

 private:
  bool begin_at_vertices();
  bool begin_on_curves(const SpatialPair& pair, bool all);
  bool step();
  bool curved_step(const SpatialPair& pair);
  SimplexFace<DoubleDouble> reduce();
  void keep(const SimplexFace<DoubleDouble>& face);
  bool is_closed();
  bool surrounds_origin(const TangentMetric& metric, double depth);
  PreciseVector3 direction(const PreciseVector3& v) const;
  PreciseVector3 combine(const SimplexFace<DoubleDouble>& face) const;
  bool holds(const PrecisePoint& w) const;
  void bound_from_above(const PreciseVector3& v);
  void bound_from_below(const PreciseVector3& u, const DoubleDouble& height);

  PrecisePair& precise_;
  double tolerance_;
  SpatialAnswer& answer_;
  const SpatialCombination before_;
  int count_ = 0;
  PrecisePoint point_[4];
  double weight_[4] = {1, 0, 0, 0};
  int best_count_ = 0;
  PrecisePoint best_[4];
  double best_weight_[4] = {1, 0, 0, 0};
  PreciseVector3 normal_;
  PreciseVector3 u_;  // of steps on curved cores
};

bool PreciseDescent::begin_at_vertices() {
  const SpatialCombination& before = answer_.combination;
  for (int i = 0; i < before.count; ++i) {
    PrecisePoint point;
    const SpatialPoint& known = before.point[i];
    if (precise_.vertex(known.index_1, known.index_2, point) && !holds(point)) point_[count_++] = point;
  }
  return count_ > 0;
}

// With the best normal of before; and, where told so, with all rims and vertices that it came from.
bool PreciseDescent::begin_on_curves(const SpatialPair& pair, bool all) {
  const Vector3& u = answer_.hint;
  if (!(dot(u, u) > 0)) return false;
  double world[3] = {0, 0, 0};
  pair.to_world(u * (1 / length(u)), world);
  u_ = precise({world[0], world[1], world[2]});
  count_ = 0;
  const int known = all ? before_.count : 0;
  for (int i = 0; i < known; ++i) {
    PrecisePoint point;
    point.index_1 = before_.point[i].index_1;
    point.index_2 = before_.point[i].index_2;
    if (precise_.follow(u_, point) && !holds(point)) point_[count_++] = point;
  }
  return true;
}

void PreciseDescent::run(const SpatialPair& pair) {
  if (!precise_.is_curved()) {
    if (!begin_at_vertices()) return;
    for (int i = 0; i < kMostIterations && step(); ++i) ++answer_.iterations;
    return;
  }
  for (const bool all : {false, true}) {
    if (!begin_on_curves(pair, all)) return;
    for (int i = 0; i < kMostCurvedIterations && curved_step(pair); ++i) ++answer_.iterations;
    if (answer_.end != SpatialEnd::open) return;
  }
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
  keep(face);
  return face;
}

void PreciseDescent::keep(const SimplexFace<DoubleDouble>& face) {
  PrecisePoint kept[4];
  for (int i = 0; i < face.count; ++i) kept[i] = point_[face.corner[i]];
  for (int i = 0; i < face.count; ++i) {
    point_[i] = kept[i];
    weight_[i] = face.weight[i].rounded();
  }
  count_ = face.count;
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
  if (face.depth > 2 * precise_.error() || precise_.balls_meet(size * kUp)) {
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
  if (is_closed() || holds(w)) return false;
  point_[count_++] = w;
  return true;
}

bool PreciseDescent::is_closed() {
  if (!(answer_.lower > 0) || !(answer_.upper - answer_.lower <= tolerance_ * answer_.upper)) return false;
  answer_.end = SpatialEnd::closed;
  return true;
}

// For cores that overlap by `depth` at u: points that lie around u's, tilted so little that they are no
// deeper, and the one opposite have the origin inside.
bool PreciseDescent::surrounds_origin(const TangentMetric& metric, double depth) {
  const double tilt = std::sqrt(0.5 * depth / metric.trace());
  constexpr double kAround[3][2] = {{1, 0}, {-0.5, 0.8660254037844386}, {-0.5, -0.8660254037844386}};
  PreciseVector3 corner[4];
  const PreciseVector3* corners[4] = {&corner[0], &corner[1], &corner[2], &corner[3]};
  DoubleDouble height;
  for (int i = 0; i < 3; ++i)
    corner[i] = precise_.support(metric.tilted(u_, tilt * kAround[i][0], tilt * kAround[i][1]), height).s;
  corner[3] = precise_.support(-u_, height).s;
  return nearest_face(corners, 4).depth > 2 * precise_.error();
}

// A step of the sequential quadratic program  minimize h(u) + |u|²/2:  with H the Hessian of the cores and λ
// their distance, the point Σ c_l s_l of the simplex that is nearest to the origin in the metric of (H + λ)⁻¹
// is looked for, and u = -(H + λ)⁻¹ Σ c_l s_l comes next. Points on curved surfaces follow u. For polytopes
// H = 0, and this is the step above.
bool PreciseDescent::curved_step(const SpatialPair& pair) {
  int left = 0;
  const int before = count_;
  count_ = 0;
  for (int i = 0; i < before; ++i) {
    PrecisePoint point = point_[i];
    precise_.follow(u_, point);
    if (holds(point)) continue;
    point_[left++] = point;
    count_ = left;
  }
  DoubleDouble height;
  const PrecisePoint w = precise_.support(u_, height);
  bound_from_below(u_, height);
  const double along = dot(u_, w.s).high;
  if (!holds(w) && count_ < 4) point_[count_++] = w;
  const TangentMetric metric(pair, u_, std::fabs(along));
  if (along > 4 * precise_.error() && surrounds_origin(metric, along)) {
    answer_.end = SpatialEnd::intersecting;
    return false;
  }
  PreciseVector3 image[4];
  const PreciseVector3* images[4] = {&image[0], &image[1], &image[2], &image[3]};
  for (int i = 0; i < count_; ++i) image[i] = metric.image(u_, point_[i].s);
  const SimplexFace<DoubleDouble> face = nearest_face(images, count_);
  keep(face);
  const PreciseVector3 v = combine(face);
  if (precise_.balls_meet(std::sqrt(dot(v, v).high) * kUp)) {
    answer_.end = SpatialEnd::intersecting;
    return false;
  }
  bound_from_above(v);
  if (is_closed() || count_ == 4) return false;
  u_ = metric.direction(u_, face.v);
  return !is_zero(u_);
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
    point.index_1 = std::max(best_[i].index_1, PrecisePoint::kSmooth);
    point.index_2 = std::max(best_[i].index_2, PrecisePoint::kSmooth);
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
  descent.run(pair);
  if (answer.end == SpatialEnd::open) {
    answer.lower = lower;
    return;
  }
  descent.record(pair);
}

}  // namespace raygauge
