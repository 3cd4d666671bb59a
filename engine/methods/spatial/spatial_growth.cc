// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/spatial_growth.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/methods/spatial/nearest_on_simplex.h"
#include "engine/methods/spatial/portal.h"
#include "engine/methods/spatial/round_growth.h"
#include "engine/methods/spatial/tuning.h"

namespace raygauge {
namespace {

constexpr int kMostExchanges = 80;
constexpr int kMostIdleExchanges = 3;
constexpr int kMostDiscoveries = 40;
constexpr double kLargestTilt = 1e4;  // shares of the angle that would do for a ball; beyond: 90°
constexpr double kLeastTilt = 0.03;   // radians
constexpr double kThin = 1e-3;        // height over extent of a plate
constexpr double kCrossed = 0.1;      // sine of the angle between the bodies' long axes
constexpr int kPatience = 4;          // discoveries before bodies without a known ball are tried as a plate
constexpr double kSmall = 1e-12;      // of a length: rounding

class Growth : GrowthBounds {
 public:
  Growth(SpatialPair& pair, double tolerance, double threshold, SpatialAnswer& answer)
      : GrowthBounds(pair, tolerance, threshold, answer), portal_(answer.combination.point) {}

  void run(const SpatialStart& start);

 private:
  Vector3 way_to_ray(int known, const Vector3& u, double h);
  Vector3 tilt_to_ray(int known, const Vector3& u, double h);
  bool may_be_plate(int discoveries) const;
  bool begin_on_plate(Vector3& u, double& h);
  bool adopt(const SpatialPoint& w, int known);
  bool is_first_on_ray(const Vector3& u, double h);
  bool discover(Vector3 u);
  bool recall(const SpatialStart& start, Vector3& u);
  bool is_on_round_piece() const;
  void refine(bool fine_normal);
  void find_inner_radius();
  Portal<double, const Vector3&> portal() const { return {portal_[0].s, portal_[1].s, portal_[2].s}; }
  void bound_by_portal(bool may_end);

  SpatialPoint* portal_;  // three, in the answer
  // Of two crossed needles B is a plate, about  uᵀMu <= 1  with  M = L² (1 - n nᵀ) + h² n nᵀ.
  bool is_plate_ = false;
  Vector3 n_;
  double length_square_ = 0, height_square_ = 0;
};

// The way from what is known of the portal, one support point or two, to the ray of p, at the height of the
// plane u·x = h; not shorter than kLeastTilt h.
Vector3 Growth::way_to_ray(int known, const Vector3& u, double h) {
  const Vector3 at = p_ * (h / dot(u, p_));
  Vector3 way;
  double size = 0;
  if (known == 1) {
    way = at - portal_[0].s;
    size = length(way);
    if (!(size > kSmall * length(at))) return any_orthogonal(p_) * (kLeastTilt * h);
  } else {
    way = cross(portal_[0].s, portal_[1].s);
    if (dot(way, p_) < 0) {
      std::swap(portal_[0], portal_[1]);
      way = -way;
    }
    way = way * (1 / length(way));
    size = dot(way, at);
    if (!(size > kLeastTilt * h)) return way * (kLeastTilt * h);
    way = way * size;
  }
  return size < kLeastTilt * h ? way * (kLeastTilt * h / size) : way;
}

// Needles of which a ball inside is known tell at once; others where discovering takes long.
bool Growth::may_be_plate(int discoveries) const {
  if (is_plate_) return false;
  if (!(inner_radius_ > 0)) return discoveries == kPatience;
  return discoveries == 0 && inner_radius_ < kThin * (pair_.shape(0).extent + pair_.shape(1).extent);
}

// Any support point of a needle is at one of its ends: the normal of the plate is across both.
bool Growth::begin_on_plate(Vector3& u, double& h) {
  const Vector3 one = portal_[0].a1 - pair_.shape(0).center;
  const Vector3 two = portal_[0].a2 - pair_.frame().from_second(pair_.shape(1).center);
  Vector3 n = cross(one, two);
  const double size = length(n), lengths = length(one) * length(two);
  if (!(size > kCrossed * lengths)) return false;
  n = n * ((dot(n, p_) < 0 ? -1 : 1) / size);
  const SpatialPoint w = support(n);
  const double height = dot(n, w.s);
  if (!(height > 0) || !(dot(n, p_) > 0) || !(height * height < kThin * kThin * lengths)) return false;
  is_plate_ = true;
  u = n_ = n;
  h = height;
  height_square_ = h * h;
  length_square_ = lengths;
  portal_[0] = w;
  return true;
}

// The same as way_to_ray for a plate, as what has to be added to u: h M⁻¹ of the way, or of the plane through
// two support points and the origin its normal k, |k|_M = 1, times h and the way along it.
Vector3 Growth::tilt_to_ray(int known, const Vector3& u, double h) {
  const Vector3 at = p_ * (h / dot(u, p_));
  if (known == 1) {
    const Vector3 way = at - portal_[0].s;
    const double up = dot(way, n_);
    return ((way - n_ * up) * (1 / length_square_) + n_ * (up / height_square_)) * h;
  }
  Vector3 k = cross(portal_[0].s, portal_[1].s);
  if (dot(k, p_) < 0) {
    std::swap(portal_[0], portal_[1]);
    k = -k;
  }
  const double up = dot(k, n_);
  const Vector3 along = k - n_ * up;
  k = k * (1 / std::sqrt(dot(along, along) * length_square_ + up * up * height_square_));
  return k * (h * std::max(dot(k, at), kLeastTilt));
}

// A point across the ray from the `known` ones. True when the cone of all three holds p; otherwise it takes
// the place of the one that is no longer needed.
bool Growth::adopt(const SpatialPoint& w, int known) {
  if (known == 1 || dot(p_, cross(w.s, portal_[0].s)) < 0) {
    portal_[1] = w;
  } else if (dot(p_, cross(portal_[1].s, w.s)) < 0) {
    portal_[0] = w;
  } else {
    portal_[2] = w;
    return true;
  }
  return false;
}

// Whether the support point of the first direction is on the ray of p, and proves the distance.
bool Growth::is_first_on_ray(const Vector3& u, double h) {
  const double ratio = dot(u, p_) / h, close = tolerance_ * inner_radius_ * ratio;
  const Vector3 off = p_ - portal_[0].s * ratio;
  if (!(dot(off, off) <= close * close)) return false;
  bound_from_below(u, portal_[0].s);
  bound_from_above(portal_, 1, &ratio);
  return is_done();
}

// Three support points whose cone holds p, near each other; false where none are found, as for a B without an
// interior. The first is that of u. The next ones are those of u tilted to where the ray is, by the angle
// that would do for a ball; by more, up to a right angle, where that finds nothing new.
bool Growth::discover(Vector3 u) {
  u = u * (1 / length(u));
  portal_[0] = support(u);
  double h = dot(u, portal_[0].s);
  if (!(h > 0) || !(dot(u, p_) > 0)) return false;
  if (is_first_on_ray(u, h)) return false;
  int known = 1;
  double tilt = tuned::kFirstTilt;
  for (int i = 0; i < kMostDiscoveries; ++i) {
    if (may_be_plate(i) && begin_on_plate(u, h)) known = 1, tilt = tuned::kFirstTilt;
    const Vector3 way = is_plate_ ? tilt_to_ray(known, u, h) : way_to_ray(known, u, h);
    Vector3 next = tilt > kLargestTilt ? way : u + way * (is_plate_ ? tilt : tilt / h);
    next = next * (1 / length(next));
    const SpatialPoint w = support(next);
    const double beyond = dot(way, w.s - portal_[0].s), size = length(way) * length(w.s);
    if (!(beyond > kSmall * size)) {
      if (tilt > kLargestTilt) return false;
      tilt *= 4;
      continue;
    }
    const double height = dot(next, w.s);
    if (height > 0 && dot(next, p_) * h > dot(u, p_) * height) {
      u = next;
      h = height;
    }
    tilt = tuned::kFirstTilt;
    if (adopt(w, known)) return true;
    known = 2;
  }
  return false;
}

// The vertices of the last solve, if their cone still holds p. Where it does not, the normal of their plane
// is a direction to begin with.
bool Growth::recall(const SpatialStart& start, Vector3& u) {
  if (start.count != 3) return false;
  for (int i = 0; i < 3; ++i) {
    if (!pair_.vertex(start.index_1[i], start.index_2[i], portal_[i])) return false;
    SpatialPoint& corner = portal_[i];
    corner.s = corner.s + p_;
  }
  if (portal().determinant() < 0) std::swap(portal_[0], portal_[1]);
  if (portal().holds(p_)) return true;
  const Vector3 plane = cross(portal_[1].s - portal_[0].s, portal_[2].s - portal_[0].s);
  if (dot(plane, p_) > 0 && dot(plane, portal_[0].s) > 0) u = plane;
  return false;
}

// Where the bodies know of no ball: the origin is deep inside some four support points, which are found as
// the nearest point of B to the origin is looked for.
void Growth::find_inner_radius() {
  Vector3 corner[4] = {portal_[0].s, portal_[1].s, portal_[2].s, support(-p_).s};
  for (int i = 0; i < kMostDiscoveries; ++i) {
    const Vector3* corners[4] = {&corner[0], &corner[1], &corner[2], &corner[3]};
    const SimplexFace<double> face = nearest_face(corners, 4);
    if (face.count == 4) {
      inner_radius_ = kDown * face.depth - 4 * pair_.error();
      return;
    }
    Vector3 kept[4];
    for (int k = 0; k < face.count; ++k) kept[k] = corner[face.corner[k]];
    const Vector3 u = face.square > 0 ? -face.v : -p_;
    for (int k = face.count; k < 4; ++k) kept[k] = support(u).s;
    std::copy_n(kept, 4, corner);
  }
}

// The upper bound of the portal, by what proves it with the least work.
void Growth::bound_by_portal(bool may_end) {
  double weight[3];
  if (!portal().weigh(p_, weight)) return;
  const double enclosed[3] = {weight[0], weight[1], weight[2]};
  for (double& each : weight) each = std::max(0.0, each);
  bound_from_above(portal_, 3, weight);
  if (is_done()) return;
  answer_.bounds.reduce_upper(portal().sum_of_weights(p_, enclosed, pair_.error()));
  if (!may_end || is_done() || inner_radius_ > 0) return;
  find_inner_radius();
  bound_from_above(portal_, 3, weight);
}

// Whether what is between the corners curves in both directions: Newton steps find it.
bool Growth::is_on_round_piece() const {
  const SpatialShape &one = pair_.shape(0), &two = pair_.shape(1);
  const bool both = is_curved(one) && is_curved(two);
  return (both || pair_.radius() > 0 || has_curved_surface(one) || has_curved_surface(two)) &&
         portal_[0].has_same_pieces(portal_[1]) && portal_[0].has_same_pieces(portal_[2]);
}

// The planes of the portals meet the ray ever farther from the origin, at p n·s/n·p; where they do not, they
// are made of rounding errors.
void Growth::refine(bool fine_normal) {
  bool may_be_round = pair_.is_curved() && pair_.prisms().empty();
  double farthest = 0;  // n·s/n·p
  int idle = 0;
  for (int i = 0; i < kMostExchanges && idle < kMostIdleExchanges; ++i) {
    double along = 0;
    const Vector3 n = portal().normal(p_, along);
    const double plane = dot(n, portal_[0].s);
    if (!(plane > 0)) return;
    const double meets = plane / along;
    idle = meets > farthest ? 0 : idle + 1;
    farthest = std::max(farthest, meets);
    if (may_be_round && is_on_round_piece()) {
      may_be_round = false;
      GrowthBounds round = *this;  // a copy: what is known here stays in registers
      if (newton_growth(round, n, fine_normal)) return;
    }
    SpatialPoint w = support(n);
    const double hopeful = plane / dot(n, w.s);  // lower/upper, but for rounding
    const bool may_end = hopeful >= 1 - tolerance_;
    if (may_end || !std::isnan(threshold_)) {
      if (may_end || along > threshold_ * dot(n, w.s)) bound_from_below(n, w.s);
      bound_by_portal(may_end);
      if (is_done()) return;
      if (hopeful >= 1 - 1e-15) return;
    }
    portal_[portal().leaving(p_, w.s)] = w;
  }
}

void Growth::run(const SpatialStart& start) {
  if (!(dot(p_, p_) > 16 * pair_.error() * pair_.error())) return;
  const bool steered = start.has_normal && dot(start.normal, p_) > 0;
  if (round_growth(pair_, tolerance_, threshold_, start, answer_)) return;
  if (!std::isnan(threshold_)) {
    const Vector3 u = steered ? start.normal : p_;
    bound_from_below(u, support(u).s);
    if (is_done()) return;
  }
  Vector3 u = answer_.bounds.lower() > 0 ? answer_.normal : steered ? start.normal : p_;
  if (!recall(start, u) && !discover(u)) return;
  refine(start.fine_normal);
  answer_.combination.count = 3;
  std::fill_n(answer_.combination.weight, 3, 1.0 / 3);  // a portal has none of its own
}

}  // namespace

void spatial_growth(SpatialPair& pair, double tolerance, double threshold, const SpatialStart& start,
                    SpatialAnswer& answer) {
  answer.end = SpatialEnd::open;
  answer.combination.count = answer.iterations = 0;
  Growth(pair, tolerance, threshold, answer).run(start);
}

}  // namespace raygauge
