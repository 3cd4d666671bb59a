// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/spatial_distance.h"

#include <cmath>
#include <utility>

#include "engine/methods/spatial/nearest_on_simplex.h"

namespace raygauge {
namespace {

constexpr int kMostIterations = 64;
constexpr double kNoise = 4;     // a gap of so many error(), two of which are the bounds' own, is rounding
constexpr double kShort = 1e-5;  // of the size of a pair: from here a simplex says more than v
constexpr double kTouching = 2;  // of error(): v is lost in rounding, and double-double arithmetic decides
constexpr double kDeep = 1 + 0x1p-4;  // of error(): so deep in computed corners is in those they stand for
constexpr double kRounding = 1 + 0x1p-48;  // of a few operations on numbers that are certain otherwise

// Σ c_l s_l of the weights as they are, which are not negative and add up to one, to 8 rounding units: its
// length is an upper bound, and what nearest_face says of v is not used.
Vector3 combine(const SpatialCombination& simplex) {
  Vector3 v = simplex.point[0].s * simplex.weight[0];
  for (int i = 1; i < simplex.count; ++i) v = v + simplex.point[i].s * simplex.weight[i];
  return v;
}

bool holds(const SpatialCombination& simplex, const SpatialPoint& w) {
  for (int i = 0; i < simplex.count; ++i) {
    const Vector3 apart = simplex.point[i].s - w.s;
    if (apart.x == 0 && apart.y == 0 && apart.z == 0) return true;
  }
  return false;
}

// Leaves of the simplex what its nearest point needs, in the order it is in.
void keep(const SimplexFace<double>& face, SpatialCombination& simplex) {
  for (int i = 0; i < face.count; ++i) {
    if (face.corner[i] != i) simplex.point[i] = simplex.point[face.corner[i]];
    simplex.weight[i] = face.weight[i];
  }
  simplex.count = face.count;
}

class Descent {
 public:
  Descent(SpatialPair& pair, double tolerance, const SpatialNearness& leave, SpatialAnswer& answer)
      : pair_(pair),
        tolerance_(tolerance),
        near_(leave.near * pair.size()),
        very_near_(leave.very_near * pair.size()),
        hopeless_(leave.at_rounding ? 2 * pair.error() / tolerance : kTouching * pair.error()),
        answer_(answer),
        simplex_(answer.combination) {}

  void run(const SpatialStart& start);

 private:
  void begin(const SpatialStart& start);
  bool reduce(double& depth);
  Vector3 direction(const Vector3& v, double size) const;
  bool step(double depth);

  SpatialPair& pair_;
  double tolerance_;
  double near_, very_near_;  // distances between which it leaves
  double hopeless_;          // and one of the cores up to which it does
  SpatialAnswer& answer_;
  SpatialCombination& simplex_;
  double best_hope_ = -1e300;
  double nearest_square_ = 1e300;  // |v|² of the simplex before
};

void Descent::begin(const SpatialStart& start) {
  for (int i = 0; i < start.count; ++i) {
    SpatialPoint& point = simplex_.point[simplex_.count];
    if (pair_.vertex(start.index_1[i], start.index_2[i], point) && !holds(simplex_, point)) ++simplex_.count;
  }
  if (simplex_.count > 0) return;
  Vector3 u = start.has_normal ? start.normal : pair_.between_centers();
  if (!(dot(u, u) > 0)) u = {1, 0, 0};
  pair_.support(u, simplex_.point[0]);
  simplex_.count = 1;
  if (!pair_.is_curved()) return;
  answer_.hint = u * (1 / length(u));
  best_hope_ = -dot(answer_.hint, simplex_.point[0].s) - pair_.error() - pair_.radius();
}

// The depth of the origin in the simplex. False where the point added last did not bring it nearer: then it
// is forgotten, as v/|v| is lost in rounding.
bool Descent::reduce(double& depth) {
  const Vector3* points[4];
  for (int i = 0; i < simplex_.count; ++i) points[i] = &simplex_.point[i].s;
  const SimplexFace<double> face = nearest_face(points, simplex_.count);
  if (!(face.square < nearest_square_)) {
    --simplex_.count;
    return false;
  }
  nearest_square_ = face.square;
  keep(face, simplex_);
  depth = face.depth;
  return true;
}

// Along a v that is short the normal of the simplex is more precise than v is.
Vector3 Descent::direction(const Vector3& v, double size) const {
  if (simplex_.count == 3 && size < kShort * pair_.size()) {
    const Vector3 n = triangle_normal(simplex_.point[0].s, simplex_.point[1].s, simplex_.point[2].s);
    const double square = dot(n, n);
    if (square > 0) return n * ((dot(n, simplex_.point[0].s) > 0 ? -1 : 1) / std::sqrt(square));
  }
  return v * (-1 / size);
}

// One support point more. False where there is nothing to be gained.
bool Descent::step(double depth) {
  const Vector3 v = combine(simplex_);
  const double size = length(v);
  answer_.bound_from_above(upper_bound(pair_, size));
  if (depth > kDeep * pair_.error() || answer_.upper < 0) {
    answer_.end = SpatialEnd::intersecting;
    return false;
  }
  if (simplex_.count == 4 || !(size > hopeless_)) return false;
  SpatialPoint& w = simplex_.point[simplex_.count];
  const Vector3 u = direction(v, size);
  pair_.support(u, w);
  const double along = dot(u, w.s);
  const double hopeful = -along - pair_.error() - pair_.radius();
  if (hopeful > best_hope_) {
    best_hope_ = hopeful;
    answer_.hint = u;
  }
  answer_.bound_from_below(lower_bound(pair_, along), u);
  if (answer_.closes(tolerance_)) return false;
  if (answer_.upper < near_ && answer_.upper > very_near_) return false;
  // A gap that is rounding, or a point that is known.
  if (answer_.upper - hopeful <= kNoise * pair_.error() || holds(simplex_, w)) return false;
  simplex_.weight[simplex_.count++] = 1;
  return true;
}

void Descent::run(const SpatialStart& start) {
  // The ball about the origin inside (S1 - c_1) - (S2 - c_2) may hold c_2 - c_1.
  const double inner = pair_.inner_radius() * (2 - kRounding) - 4 * pair_.error();
  if (inner > 0 && dot(pair_.between_centers(), pair_.between_centers()) * kRounding < inner * inner) {
    answer_.end = SpatialEnd::intersecting;
    return;
  }
  begin(start);
  double depth = 0;
  while (answer_.iterations++ < kMostIterations && reduce(depth) && step(depth)) {
  }
}

}  // namespace

void spatial_distance(SpatialPair& pair, double tolerance, const SpatialStart& start,
                      const SpatialNearness& leave, SpatialAnswer& answer) {
  answer.begin_steps();
  Descent(pair, tolerance, leave, answer).run(start);
}

}  // namespace raygauge
