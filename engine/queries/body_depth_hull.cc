// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// The depth of bodies of which all facets are known: no search. A ball or a capsule whose core is in a hull
// with a known surface; two boxes, or a box and a capsule; small hulls and
// boxes; one of all these and a cylinder or a cone.
#include <algorithm>
#include <cmath>

#include "engine/methods/bodies/nearness.h"
#include "engine/methods/spatial/nearest_of_segments.h"
#include "engine/queries/body_depth.h"
#include "engine/sets/direction_table.h"

namespace raygauge {

namespace {

// A point or a segment, and a hull with a known surface.
struct InHull {
  HullSurface::Nearest nearest(InstructionSet isa) const {
    return dot(own_half, own_half) > 0 ? surface->nearest_of_sum(own, own_half) : surface->nearest(own, isa);
  }

  const HullSurface* surface = nullptr;
  bool is_second = false;  // the hull; then the other body is the first
  Vector3 center, own;     // that of the other body in the frame of the first, and in that of the hull
  Vector3 half, own_half;  // the same of half of its segment
};

InHull in_hull(const SpatialPair& pair) {
  const int at = pair.shape(0).kind == SpatialShape::Kind::points ? 0 : 1;
  const SpatialShape &hull = pair.shape(at), &other = pair.shape(1 - at);
  if (hull.kind != SpatialShape::Kind::points || hull.table == nullptr || !is_between_ends(other)) return {};
  const Vector3 half = is_point(other) ? Vector3{} : other.axis.column[0];
  const Matrix3& R = pair.frame().R;
  if (at == 0) {
    const Vector3 center = pair.frame().from_second(other.center), turned = R * half;
    return {&hull.table->surface(), false, center, center, turned, turned};
  }
  return {&hull.table->surface(),  true, other.center, pair.frame().to_second(other.center), half,
          R.transposed_times(half)};
}

// Of the segment, the point in contact: the end that is the farthest from the plane, or the one across the
// edge, which is given in the frame of the hull.
Vector3 touching(const InHull& in, const HullSurface::Nearest& nearest) {
  if (!(dot(in.half, in.half) > 0)) return in.center;
  double s = 0, t = dot(nearest.normal, in.own_half) > 0 ? -1.0 : 1.0;
  if (nearest.is_edge) {
    const Vector3 middle = (nearest.end[0] + nearest.end[1]) * 0.5,
                  half = (nearest.end[1] - nearest.end[0]) * 0.5;
    nearest_of_segments(middle, half, in.own, in.own_half, s, t);
  }
  return in.center + in.half * t;
}

// Of a small hull, a box, a segment or a point; the last three are put into `own`.
const PolytopeFaces* faces_of(const SpatialShape& shape, PolytopeFaces& own) {
  if (shape.kind == SpatialShape::Kind::points)
    return shape.table != nullptr ? shape.table->surface().faces() : nullptr;
  if (shape.kind == SpatialShape::Kind::box) {
    own = PolytopeFaces::of_box(shape.base, shape.top);
    return &own;
  }
  if (!is_between_ends(shape)) return nullptr;
  const bool is_segment = !is_point(shape);
  own.set_segment(is_segment ? shape.base : shape.center, is_segment ? shape.top : shape.center);
  return &own;
}

}  // namespace

// The planes of the surface say it all: whether the other body's centre is inside, and how deep.
bool BodyDepth::leave_hull(double tolerance, BodyDepthAnswer& answer) {
  const InHull in = in_hull(pair_);
  if (in.surface == nullptr) return false;
  const HullSurface::Nearest nearest = in.nearest(isa_);
  const double lower = nearest.room - pair_.error();
  if (!(lower > 0)) return false;
  const Vector3 u = in.is_second ? -(pair_.frame().R * nearest.normal) : nearest.normal;
  SpatialPoint point;
  pair_.support(u, point);
  const double size = length(u), height = dot(u, point.s) / size + pair_.error();
  const Bounds bounds(down(ball_lower_ + lower), up(ball_upper_ + height * (1 + 0x1p-48)));
  if (!bounds.close(tolerance, enough_)) return false;
  source_ = Source::hull;
  plane_ = nearest;
  has_points_ = true;
  answer.bounds = bounds;
  answer.status = DistanceStatus::optimal;
  answer.iterations = 1;
  answer.support_queries += pair_.queries();
  normal_ = u * (1 / size);
  const Vector3 way = normal_ * nearest.room, other = touching(in, nearest);
  put_points(normal_, in.is_second ? other : other + way, in.is_second ? other - way : other, answer);
  pair_.frame().to_world(-normal_, &answer.normal.x);
  return true;
}

// All facets of the difference of the cores are known, and the point in contact from `from` on.
template <class Known>
bool BodyDepth::leave_known(const Known& known, Source source, const Vector3& from, double tolerance,
                            BodyDepthAnswer& answer) {
  const double error = 2 * pair_.error(), lower = known.lower() - error;
  if (!(lower > 0)) return false;
  const Bounds bounds(down(ball_lower_ + lower * (1 - 0x1p-48)),
                      up(ball_upper_ + (known.upper() + error) * (1 + 0x1p-48)));
  Vector3 of_first;
  if (!bounds.close(tolerance, enough_) || !known.find_contact(of_first)) return false;
  source_ = source;
  has_points_ = true;
  answer.bounds = bounds;
  answer.status = DistanceStatus::optimal;
  answer.iterations = 1;
  answer.support_queries += pair_.queries();
  normal_ = known.normal();
  const Vector3 a1 = from + of_first;
  put_points(normal_, a1, a1 - normal_ * known.upper(), answer);
  pair_.frame().to_world(-normal_, &answer.normal.x);
  return true;
}

// The difference of both cores is a sum of segments.
bool BodyDepth::leave_boxes(double tolerance, BodyDepthAnswer& answer) {
  if (pair_.dimension() != 3) return false;
  const Matrix3& R = pair_.frame().R;
  boxes_.begin(-pair_.between_centers());
  if (!for_generators(pair_.shape(0), [&](const Vector3& g) { boxes_.add_first(g); }) ||
      !for_generators(pair_.shape(1), [&](const Vector3& g) { boxes_.add(R * g); }) ||
      !boxes_.solve(2 * pair_.size()))
    return false;
  return leave_known(boxes_, Source::boxes, pair_.shape(0).center, tolerance, answer);
}

// Both are small hulls, or one of them a box; or one is a frustum and the other one such a polytope, a
// segment or a point.
bool BodyDepth::leave_polytopes(double tolerance, BodyDepthAnswer& answer) {
  if (pair_.dimension() != 3) return false;
  const SpatialShape &one = pair_.shape(0), &two = pair_.shape(1);
  const Matrix3& R = pair_.frame().R;
  const Vector3& t = pair_.frame().t;
  const double defect = pair_.pose(0).defect + pair_.pose(1).defect, size = 2 * pair_.size();
  const auto is_frustum = [](const SpatialShape& shape) { return shape.kind == SpatialShape::Kind::frustum; };
  if (is_frustum(one) || is_frustum(two)) {
    constexpr double kShareOfGap = 0.25;
    const int body = is_frustum(one) ? 0 : 1;
    const PolytopeFaces* other = faces_of(pair_.shape(1 - body), box_);
    return other != nullptr &&
           frustum_.solve(pair_.shape(body), body, *other, R, t, defect, size, kShareOfGap * tolerance) &&
           leave_known(frustum_, Source::frustum, {}, tolerance, answer);
  }
  const auto is_hull = [](const SpatialShape& shape) { return shape.kind == SpatialShape::Kind::points; };
  if (!is_hull(one) && !is_hull(two)) return false;
  const PolytopeFaces* first = faces_of(one, box_);
  const PolytopeFaces* second = first != nullptr && first->facets > 0 ? faces_of(two, box_) : nullptr;
  return second != nullptr && second->facets > 0 && polytopes_.solve(*first, *second, R, t, defect, size) &&
         leave_known(polytopes_, Source::polytopes, {}, tolerance, answer);
}

template <class Known>
void BodyDepth::add_near_facets(const Known& known, double relative, double angle,
                                std::vector<Vector3>& normals) const {
  constexpr double kRounding = 1 + 1e-9;
  const double most = known.upper() + relative * (known.upper() + ball_upper_.rounded());
  const Nearness near(angle);
  known.for_near(most * kRounding, [&](const Vector3& n) {
    const auto is_near = [&](const Vector3& other) { return near(other, n); };
    if (!is_near(normal_) && std::none_of(normals.begin(), normals.end(), is_near)) normals.push_back(n);
  });
}

template void BodyDepth::add_near_facets(const ZonotopeDepth&, double, double, std::vector<Vector3>&) const;
template void BodyDepth::add_near_facets(const PolytopeDepth&, double, double, std::vector<Vector3>&) const;
template void BodyDepth::add_near_facets(const FrustumDepth&, double, double, std::vector<Vector3>&) const;

void BodyDepth::add_near_planes(double relative, double angle, std::vector<Vector3>& normals) const {
  constexpr double kRounding = 1 + 1e-9;
  const double most = plane_.room + relative * (plane_.room + ball_upper_.rounded());
  if (plane_.second > most * kRounding) return;
  const InHull in = in_hull(pair_);
  const Nearness near(angle);
  const auto add = [&](const Vector3& plane) {
    const Vector3 n = in.is_second ? -(pair_.frame().R * plane) : plane;
    const auto is_near = [&](const Vector3& other) { return near(other, n); };
    if (!is_near(normal_) && std::none_of(normals.begin(), normals.end(), is_near)) normals.push_back(n);
  };
  if (dot(in.own_half, in.own_half) > 0)
    in.surface->for_near_of_sum(in.own, in.own_half, most, add);
  else
    in.surface->for_near(in.own, most, isa_, add);
}

}  // namespace raygauge
