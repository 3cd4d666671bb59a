// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "engine/methods/spatial/nearest_on_simplex.h"
#include "engine/methods/spatial/precise_pair.h"
#include "engine/methods/spatial/spatial_distance.h"

/// The algorithm of Gilbert, Johnson & Keerthi, over both pairs. A `Simplex` has at most four support points:
/// count, point[] and weight[].
namespace raygauge {

/// Whether w is one of the points.
template <class Simplex, class Real>
bool holds(const Simplex& simplex, const PairPoint<Real>& w) {
  for (int i = 0; i < simplex.count; ++i) {
    if (is_zero(simplex.point[i].s - w.s)) return true;
  }
  return false;
}

/// The face of a simplex that is nearest to the origin.
template <class Simplex>
auto nearest_face_of(const Simplex& simplex) {
  const decltype(simplex.point[0].s)* points[4];
  for (int i = 0; i < simplex.count; ++i) points[i] = &simplex.point[i].s;
  return nearest_face(points, simplex.count);
}

/// Leaves of the simplex that face, in the order it is in: corners are ascending.
template <class Simplex, class Real>
void keep(const SimplexFace<Real>& face, Simplex& simplex) {
  for (int i = 0; i < face.count; ++i) {
    if (face.corner[i] != i) simplex.point[i] = simplex.point[face.corner[i]];
    simplex.weight[i] = rounded(face.weight[i]);
  }
  simplex.count = face.count;
}

/// Σ c_l s_l of that face. Its weights are not negative and add up to one, to 8 rounding units: its length is
/// an upper bound, and what nearest_face says of v is not used.
template <class Simplex, class Real>
BasicVector3<Real> combine(const Simplex& simplex, const SimplexFace<Real>& face) {
  BasicVector3<Real> v = simplex.point[0].s * face.weight[0];
  for (int i = 1; i < simplex.count; ++i) v = v + simplex.point[i].s * face.weight[i];
  return v;
}

/// Of length 1 in about, from v on the simplex to the origin. Where v is short (`is_short`) a normal of a
/// triangle is more precise than v is, and so is, in double-double arithmetic, what is across an edge. From a
/// vertex doubles do, as a height hardly depends on them.
template <class Simplex, class Real>
BasicVector3<Real> direction(const Simplex& simplex, const BasicVector3<Real>& v, double size,
                             bool is_short) {
  const auto* point = simplex.point;
  const BasicVector3<Real> way = v * Real{-1 / size};
  if constexpr (!kIsDouble<Real>) {
    if (simplex.count == 1) return vector_of<Real>(rounded(way));
    if (simplex.count == 2) {
      const BasicVector3<Real> edge = point[1].s - point[0].s;
      return way - edge * (dot(way, edge) / dot(edge, edge));
    }
  }
  if (is_short && simplex.count == 3) {
    const BasicVector3<Real> n = triangle_normal(point[0].s, point[1].s, point[2].s);
    const double square = high(dot(n, n));
    if (square > 0) return n * Real{(high(dot(n, point[0].s)) > 0 ? -1 : 1) / std::sqrt(square)};
  }
  return way;
}

/// What a support point says of the distance: a proven lower bound, and the same but for the rounding of the
/// bound itself.
struct SupportBound {
  double lower = 0, hopeful = 0;
};

/// The point w for u, of length 1 in about, and so for the same direction of any length, `way`, which is at
/// hand before.
inline SupportBound look(SpatialPair& pair, const Vector3& way, const Vector3& u, SpatialPoint& w) {
  pair.support(way, w);
  const double along = dot(u, w.s);
  return {lower_bound(pair, along), -along - pair.error() - pair.radius()};
}
inline SupportBound look(PrecisePair& pair, const PreciseVector3& /*way*/, const PreciseVector3& u,
                         PrecisePoint& w) {
  DoubleDouble height;
  w = pair.support(u, height);
  const double lower = lower_bound(pair, u, height);
  return {lower, lower};
}

/// Whether the balls of both bodies about a pair of points of the cores, `away` from each other but for
/// rounding, are sure to meet.
inline bool balls_meet(const SpatialPair& pair, double away) { return upper_bound(pair, away) < 0; }
inline bool balls_meet(const PrecisePair& pair, double away) { return pair.balls_meet(away * (1 + 0x1p-50)); }

/// The steps on a simplex that is not empty; its point nearest to the origin comes nearer with each.
template <class Pair, class Simplex>
class Gjk {
 public:
  using Real = typename Pair::Real;
  using Vector = typename Pair::Vector;

  Gjk(Pair& pair, double tolerance, Simplex& simplex, SpatialAnswer& answer)
      : pair_(pair), tolerance_(tolerance), simplex_(simplex), answer_(answer) {}

  /// Distances between which it leaves the pair to other steps, and a length of v up to which it does.
  void leave(double near, double very_near, double hopeless) {
    near_ = near;
    very_near_ = very_near;
    hopeless_ = hopeless;
  }

  /// The least lower bound from which on a normal becomes the hint of the answer.
  void set_hope(double bound) { best_hope_ = bound; }

  /// One support point more. False where the solve is done, or there is nothing to be gained.
  bool step();

 private:
  static constexpr double kNoise = 4;     // a gap of so many error(), two of which are the bounds' own
  static constexpr double kShort = 1e-5;  // of the size of a pair
  // Of error(): so deep in computed corners is in those they stand for.
  static constexpr double kDeep = 1 + 0x1p-4;

  Pair& pair_;
  double tolerance_;
  Simplex& simplex_;
  SpatialAnswer& answer_;
  double near_ = 0, very_near_ = 0, hopeless_ = pair_.error();
  double best_hope_ = -1e300;
  Real nearest_square_{1e300};  // |v|² of the simplex before
};

template <class Pair, class Simplex>
bool Gjk<Pair, Simplex>::step() {
  const SimplexFace<Real> face = nearest_face_of(simplex_);
  if (!(face.square < nearest_square_)) {  // the last point is forgotten: v/|v| is lost in rounding
    --simplex_.count;
    return false;
  }
  nearest_square_ = face.square;
  keep(face, simplex_);
  const Vector v = combine(simplex_, face);
  const double size = length_of(v);
  answer_.bounds.reduce_upper(upper_bound(pair_, v));
  if (face.depth > kDeep * pair_.error() || balls_meet(pair_, size)) {
    answer_.end = SpatialEnd::intersecting;
    return false;
  }
  if (simplex_.count == 4 || !(size > hopeless_)) return false;
  auto& w = simplex_.point[simplex_.count];
  const bool is_short = !kIsDouble<Real> || size < kShort * pair_.in_doubles().size();
  const Vector u = direction(simplex_, v, size, is_short);
  const SupportBound bound = look(pair_, is_short ? u : -v, u, w);
  if (bound.hopeful > best_hope_) {
    best_hope_ = bound.hopeful;
    answer_.hint = pair_.to_first(u);
  }
  if (bound.lower > answer_.bounds.lower()) answer_.raise_lower(bound.lower, pair_.to_first(u));
  if (answer_.closes(tolerance_)) return false;
  const double upper = answer_.bounds.upper();
  if (upper < near_ && upper > very_near_) return false;
  if (upper - bound.hopeful <= kNoise * pair_.error() || holds(simplex_, w)) return false;
  simplex_.weight[simplex_.count++] = 1;
  return true;
}

}  // namespace raygauge
