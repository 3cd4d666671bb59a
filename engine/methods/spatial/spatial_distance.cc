// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/spatial_distance.h"

#include <algorithm>

#include "engine/methods/spatial/nearest_on_simplex.h"

namespace raygauge {
namespace {

constexpr int kMostIterations = 64;
constexpr double kNoise = 4;  // a gap of so many error(), two of which are the bounds' own, is rounding
constexpr double kRounding = 1 + 0x1p-48;  // of a few operations on numbers that are certain otherwise

// Σ c_l s_l of the weights as they are, which are not negative and add up to one: its length is an upper
// bound, and what nearest_face says of v is not used.
Vector3 combine(const SpatialCombination& simplex) {
  double sum = 0;
  Vector3 v;
  for (int i = 0; i < simplex.count; ++i) {
    v = v + simplex.point[i].s * simplex.weight[i];
    sum += simplex.weight[i];
  }
  return v * (1 / sum);
}

bool holds(const SpatialCombination& simplex, const SpatialPoint& w) {
  for (int i = 0; i < simplex.count; ++i) {
    const Vector3 apart = simplex.point[i].s - w.s;
    if (apart.x == 0 && apart.y == 0 && apart.z == 0) return true;
  }
  return false;
}

void add(SpatialCombination& simplex, const SpatialPoint& w) {
  simplex.point[simplex.count] = w;
  simplex.weight[simplex.count++] = 1;
}

void begin(SpatialPair& pair, const SpatialStart& start, SpatialCombination& simplex) {
  for (int i = 0; i < start.count; ++i) {
    SpatialPoint point;
    if (pair.vertex(start.index_1[i], start.index_2[i], point) && !holds(simplex, point)) add(simplex, point);
  }
  if (simplex.count == 0) {
    const Vector3 u = start.has_normal ? start.normal : pair.between_centers();
    add(simplex, pair.support(dot(u, u) > 0 ? u : Vector3{1, 0, 0}, false));
  }
}

// Leaves of the simplex what its nearest point needs; the depth of the origin in it.
double reduce(SpatialCombination& simplex) {
  const Vector3* points[4];
  for (int i = 0; i < simplex.count; ++i) points[i] = &simplex.point[i].s;
  const SimplexFace<double> face = nearest_face(points, simplex.count);
  SpatialPoint kept[4];
  for (int i = 0; i < face.count; ++i) kept[i] = simplex.point[face.corner[i]];
  for (int i = 0; i < face.count; ++i) {
    simplex.point[i] = kept[i];
    simplex.weight[i] = face.weight[i];
  }
  simplex.count = face.count;
  return face.depth;
}

class Descent {
 public:
  Descent(SpatialPair& pair, double tolerance) : pair_(pair), tolerance_(tolerance) {}

  SpatialAnswer run(const SpatialStart& start);

 private:
  bool is_closed() const {
    return answer_.lower > 0 && answer_.upper - answer_.lower <= tolerance_ * answer_.upper;
  }
  bool step(double depth);
  void bound_from_above(const Vector3& v, double size);
  void bound_from_below(const Vector3& v, double along, double size);

  SpatialPair& pair_;
  double tolerance_;
  SpatialAnswer answer_;
  SpatialCombination simplex_;
  double best_hope_ = -1e300;
  Vector3 v_;
};

void Descent::bound_from_above(const Vector3& v, double size) {
  const double upper = (size + pair_.error()) * kRounding - pair_.radius();
  if (!(upper < answer_.upper)) return;
  answer_.upper = upper;
  answer_.combination = simplex_;
  v_ = v;
}

// `along` is v·w for the support point w: what is certain of it, after its rounding error.
void Descent::bound_from_below(const Vector3& v, double along, double size) {
  const double lower = (along / size - pair_.error()) * (2 - kRounding) - pair_.radius() * kRounding;
  if (!(lower > answer_.lower)) return;
  answer_.lower = lower;
  answer_.normal = -v;
}

// One support point more. False where there is nothing to be gained.
bool Descent::step(double depth) {
  const Vector3 v = combine(simplex_);
  const double size = length(v);
  bound_from_above(v, size);
  if (depth > 2 * pair_.error() || answer_.upper < 0) {
    answer_.end = SpatialEnd::intersecting;
    return false;
  }
  if (simplex_.count == 4 || !(size > pair_.error())) return false;
  SpatialPoint w = pair_.support(-v, false);
  const double along = dot(v, w.s);
  // Only what may end the solve is worth a proof.
  const double hopeful = along / size - pair_.error() - pair_.radius();
  if (hopeful > best_hope_) {
    best_hope_ = hopeful;
    answer_.hint = -v;
  }
  const bool drowned = answer_.upper - hopeful <= kNoise * pair_.error();
  if (answer_.upper - hopeful <= tolerance_ * answer_.upper || drowned || holds(simplex_, w)) {
    if (pair_.climbs()) w = pair_.support(-v, true);
    bound_from_below(v, dot(v, w.s), size);
    if (is_closed()) {
      answer_.end = SpatialEnd::closed;
      return false;
    }
    if (drowned || holds(simplex_, w)) return false;
  }
  add(simplex_, w);
  return true;
}

SpatialAnswer Descent::run(const SpatialStart& start) {
  answer_.upper = 1e300;
  begin(pair_, start, simplex_);
  while (answer_.iterations++ < kMostIterations && step(reduce(simplex_))) {
  }
  return answer_;
}

}  // namespace

SpatialAnswer spatial_distance(SpatialPair& pair, double tolerance, const SpatialStart& start) {
  return Descent(pair, tolerance).run(start);
}

}  // namespace raygauge
