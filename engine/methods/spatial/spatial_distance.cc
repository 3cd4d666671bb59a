// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/spatial_distance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/methods/spatial/gjk.h"
#include "engine/numerics/fused.h"

namespace raygauge {
namespace {

constexpr int kMostIterations = 64;
constexpr double kTouching = 2;  // of error(): v is lost in rounding, and double-double arithmetic decides
constexpr double kRounding = 1 + 0x1p-48;  // of a few operations on numbers that are certain otherwise

class Descent {
 public:
  Descent(SpatialPair& pair, double tolerance, const SpatialNearness& leave, SpatialAnswer& answer)
      : pair_(pair), answer_(answer), steps_(pair, tolerance, answer.combination, answer) {
    const double hopeless = leave.at_rounding ? 2 * pair.error() / tolerance : kTouching * pair.error();
    steps_.leave(leave.near * pair.size(), leave.very_near * pair.size(), hopeless);
  }

  void run(const SpatialStart& start);

 private:
  void begin(const SpatialStart& start);

  SpatialPair& pair_;
  SpatialAnswer& answer_;
  Gjk<SpatialPair, SpatialCombination> steps_;
};

void Descent::begin(const SpatialStart& start) {
  SpatialCombination& simplex = answer_.combination;
  for (int i = 0; i < start.count; ++i) {
    SpatialPoint& point = simplex.point[simplex.count];
    if (pair_.vertex(start.index_1[i], start.index_2[i], point) && !holds(simplex, point)) ++simplex.count;
  }
  if (simplex.count > 0) return;
  Vector3 u = start.has_normal ? start.normal : pair_.between_centers();
  if (!(dot(u, u) > 0)) u = {1, 0, 0};
  pair_.support(u, simplex.point[0]);
  simplex.count = 1;
  if (!pair_.is_curved()) return;
  answer_.hint = u * (1 / length(u));
  steps_.set_hope(-dot(answer_.hint, simplex.point[0].s) - pair_.error() - pair_.radius());
}

void Descent::run(const SpatialStart& start) {
  if (meet_deep(pair_)) {
    answer_.end = SpatialEnd::intersecting;
    return;
  }
  begin(start);
  while (answer_.iterations++ < kMostIterations && steps_.step()) {
  }
}

}  // namespace

// The ball about the origin inside (S1 - c_1) - (S2 - c_2) may hold c_2 - c_1.
bool meet_deep(const SpatialPair& pair) {
  const auto holds_way = [&pair](double radius, const Vector3& way) {
    const double inner = radius * (2 - kRounding) - 4 * pair.error();
    return inner > 0 && dot(way, way) * kRounding < inner * inner;
  };
  if (holds_way(pair.inner_radius(), pair.between_centers())) return true;
  // Of a capsule there is such a ball about every point of its segment.
  const SpatialShape &one = pair.shape(0), &two = pair.shape(1);
  const bool is_first = one.kind == SpatialShape::Kind::segment;
  if (!is_first && two.kind != SpatialShape::Kind::segment) return false;
  const Vector3 half = is_first ? one.axis.column[0] : pair.frame().R * two.axis.column[0];
  const Vector3 way = pair.frame().from_second(two.center) - one.center;
  const double square = dot(half, half);
  if (!(square > 0)) return false;
  return holds_way(one.inner_radius + two.inner_radius,
                   way - half * std::clamp(dot(way, half) / square, -1.0, 1.0));
}

RAYGAUGE_FUSED void spatial_distance(SpatialPair& pair, double tolerance, const SpatialStart& start,
                                     const SpatialNearness& leave, SpatialAnswer& answer) {
  answer.begin_steps();
  Descent(pair, tolerance, leave, answer).run(start);
}

}  // namespace raygauge
