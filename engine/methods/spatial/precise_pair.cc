// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/precise_pair.h"

#include <algorithm>
#include <cmath>

#include "engine/methods/spatial/core_vertices.h"
#include "engine/methods/spatial/precise_curves.h"
#include "engine/methods/spatial/precise_projection.h"
#include "engine/numerics/fused.h"
#include "raygauge/sets/direction_table.h"

namespace raygauge {
namespace {

using Kind = SpatialShape::Kind;

constexpr int kLanes = 8;                             // of PointSet's blocks
constexpr double kSmallest = 1e-30, kLargest = 1e30;  // of sizes whose products can be split in two
constexpr double kError = 0x1p-88;
constexpr double kHeightError = 0x1p-49;  // of three products in doubles, relative to |v|₁ max|x|

bool has_vertex(const SpatialShape& shape, std::int32_t index) {
  return index >= 0 && index < count_core_vertices(shape);
}

bool is_curved_core(const SpatialShape& shape) {
  return shape.kind == Kind::ellipsoid || shape.kind == Kind::frustum;
}

}  // namespace

bool PrecisePair::bind(const SpatialPair& pair, const Kernels& kernels) {
  const int n = pair.dimension();
  double size = 0;
  double t[2][3] = {{0, 0, 0}, {0, 0, 0}};
  for (int i = 0; i < 2; ++i) {
    Body& body = body_[i];
    const PoseNumbers& pose = pair.pose(i);
    body.shape = &pair.shape(i);
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) {
        const bool given = pose.R != nullptr && j < n && k < n;
        body.R[j][k] = given ? pose.R[k * n + j] : (j == k ? 1.0 : 0.0);
      }
      if (pose.t != nullptr && j < n) t[i][j] = pose.t[j];
    }
    body.defect = pose.defect;
    body.ball = body.shape->radius * (1 - pose.defect) * (1 - 0x1p-50);
    size += body.shape->extent + body.shape->radius;
  }
  apart_ = {two_sum(t[0][0], -t[1][0]), two_sum(t[0][1], -t[1][1]), two_sum(t[0][2], -t[1][2])};
  size += length(rounded(apart_));
  if (!(size > kSmallest && size < kLargest)) return false;
  error_ = kError * size;
  kernels_ = &kernels;
  vertices_ = !is_curved_core(*body_[0].shape) && !is_curved_core(*body_[1].shape);
  queries_ = 0;
  return true;
}

namespace {

template <class Vector>
DoubleDouble product(double x, double y, double z, const Vector& v) {
  return loose_sum(loose_product(v.x, x), loose_product(v.y, y), loose_product(v.z, z));
}

template <class Vector>
PreciseVector3 turned(const double (&R)[3][3], const Vector& v) {
  return {product(R[0][0], R[0][1], R[0][2], v), product(R[1][0], R[1][1], R[1][2], v),
          product(R[2][0], R[2][1], R[2][2], v)};
}

template <class Vector>
PreciseVector3 turned_back(const double (&R)[3][3], const Vector& v) {
  return {product(R[0][0], R[1][0], R[2][0], v), product(R[0][1], R[1][1], R[2][1], v),
          product(R[0][2], R[1][2], R[2][2], v)};
}

}  // namespace

PreciseVector3 PrecisePair::turn(const Body& body, const PreciseVector3& x) { return turned(body.R, x); }

PreciseVector3 PrecisePair::turn(const Body& body, const Vector3& x) { return turned(body.R, x); }

PreciseVector3 PrecisePair::turn_back(const Body& body, const PreciseVector3& u) {
  const bool is_double = u.x.low == 0 && u.y.low == 0 && u.z.low == 0;
  return is_double ? turned_back(body.R, rounded(u)) : turned_back(body.R, u);
}

// Of the points that a table lists for v, which holds the highest of all; as below.
std::int32_t PrecisePair::highest_of(const SpatialShape& shape, std::span<const std::int32_t> listed,
                                     const PreciseVector3& v) {
  const Vector3 w = rounded(v);
  double top = -__builtin_inf();
  for (const std::int32_t i : listed) top = std::max(top, dot(w, shape.table->point(i)));
  const double size = (std::fabs(w.x) + std::fabs(w.y) + std::fabs(w.z)) * shape.extent;
  std::int32_t best = -1;
  DoubleDouble height;
  for (const std::int32_t i : listed) {
    const Vector3 point = shape.table->point(i);
    if (!(dot(w, point) >= top - 4 * kHeightError * size)) continue;
    const DoubleDouble other = dot(v, point);
    if (best >= 0 && !(other > height)) continue;
    height = other;
    best = i;
  }
  return best;
}

// Every point that may be the highest, but for rounding in doubles, is compared precisely.
std::int32_t PrecisePair::highest(const SpatialShape& shape, const PreciseVector3& v) const {
  const Vector3 w = rounded(v);
  if (shape.table != nullptr) {
    const std::int32_t listed = highest_of(shape, shape.table->listed(w), v);
    if (listed >= 0) return listed;
  }
  const double u[3] = {w.x, w.y, w.z};
  const int n = shape.coordinates;
  std::ptrdiff_t index = 0;
  const double top = kernels_->price(shape.blocks, shape.block_count, n, u, &index);
  const double size = (std::fabs(w.x) + std::fabs(w.y) + std::fabs(w.z)) * shape.extent;
  const double floor = top - 4 * kHeightError * size;
  auto best = static_cast<std::int32_t>(std::min(index, shape.size - 1));
  DoubleDouble height = dot(v, core_vertex(shape, best));
  const double third = n == 3 ? w.z : 0.0;
  for (std::ptrdiff_t block = 0; block < shape.block_count; ++block) {
    const double* p = shape.blocks + block * n * kLanes;
    const double* z = n == 3 ? p + std::ptrdiff_t{2} * kLanes : p;
    double value[kLanes];
    int above = 0;
    for (int lane = 0; lane < kLanes; ++lane)
      value[lane] = w.x * p[lane] + w.y * p[kLanes + lane] + third * z[lane];
    for (const double each : value) above += each >= floor ? 1 : 0;
    for (int lane = 0; above > 0 && lane < kLanes; ++lane) {
      const std::ptrdiff_t candidate = block * kLanes + lane;
      if (!(value[lane] >= floor) || candidate == best || candidate >= shape.size) continue;
      const DoubleDouble other = dot(v, core_vertex(shape, static_cast<std::int32_t>(candidate)));
      if (!(other > height)) continue;
      height = other;
      best = static_cast<std::int32_t>(candidate);
    }
  }
  return best;
}

namespace {

// |v|, mostly nearly 1: there √(1 + ε) is 1 + ε/2 to 2⁻⁹⁹.
DoubleDouble length_near_one(const PreciseVector3& v) {
  const DoubleDouble square = dot(v, v), beyond = square + -1.0;
  return std::fabs(beyond.high) < 0x1p-48 ? ordered_sum(1, 0.5 * beyond.high) : sqrt(square);
}

}  // namespace

// h(v) of the core in its own frame; its point where x is asked for.
DoubleDouble PrecisePair::support_of(int i, const PreciseVector3& v, PreciseVector3* x, std::int32_t& index) {
  const SpatialShape& shape = *body_[i].shape;
  ++queries_;
  if (shape.radius > 0) ball_height_ = ball_height_ + length_near_one(v) * shape.radius;
  switch (shape.kind) {
    case Kind::ellipsoid:
      return ellipsoid_support(shape, v, x);
    case Kind::frustum: {
      const RimView view(shape, v);
      index = view.highest(shape);
      if (x != nullptr) *x = view.point(shape, index);
      return view.height(shape, v, index);
    }
    case Kind::segment:
      index = dot(v, shape.top) >= dot(v, shape.base) ? 0 : 1;
      break;
    case Kind::box:
      index = (v.x.high < 0 ? 1 : 0) | (v.y.high < 0 ? 2 : 0) | (v.z.high < 0 ? 4 : 0);
      break;
    case Kind::points:
      index = highest(shape, v);
      break;
    case Kind::point:
      index = 0;
      break;
  }
  const Vector3 vertex = core_vertex(shape, index);
  if (x != nullptr) *x = precise(vertex);
  return dot(v, vertex);
}

RAYGAUGE_FUSED void PrecisePair::place(PrecisePoint& point) const {
  point.s =
      sum_of(point.index_1 >= 0 ? turn(body_[0], rounded(point.x1)) : turn(body_[0], point.x1),
             -(point.index_2 >= 0 ? turn(body_[1], rounded(point.x2)) : turn(body_[1], point.x2)), apart_);
}

DoubleDouble PrecisePair::height_of(const PreciseVector3& u, PrecisePoint* point) {
  std::int32_t index_1 = PrecisePoint::kSmooth, index_2 = PrecisePoint::kSmooth;
  ball_height_ = {};
  const DoubleDouble of_cores =
      loose_sum(support_of(0, turn_back(body_[0], u), point == nullptr ? nullptr : &point->x1, index_1),
                support_of(1, turn_back(body_[1], -u), point == nullptr ? nullptr : &point->x2, index_2),
                dot(u, apart_));
  if (point != nullptr) {
    point->index_1 = index_1;
    point->index_2 = index_2;
  }
  return body_[0].ball + body_[1].ball > 0 ? of_cores + ball_height_ : of_cores;
}

RAYGAUGE_FUSED DoubleDouble PrecisePair::height(const PreciseVector3& u) { return height_of(u, nullptr); }

RAYGAUGE_FUSED DoubleDouble PrecisePair::support_parts(const PreciseVector3& u, PrecisePoint& point) {
  return height_of(u, &point);
}

PrecisePoint PrecisePair::support(const PreciseVector3& u, DoubleDouble& height) {
  PrecisePoint point;
  height = support_parts(u, point);
  place(point);
  return point;
}

// Along u the points of the balls add what they add to the height. Across it they would add nothing, were R
// a rotation: R Rᵀu is u but for the defect of the pose.
RAYGAUGE_FUSED double PrecisePair::length_beyond_balls(const PreciseVector3& v,
                                                       const PreciseVector3& u) const {
  if (!(ball_height_.high > 0)) return length(rounded(v));
  const DoubleDouble square = dot(u, u), along = dot(v, u);
  const Vector3 across = rounded(v * square - u * along);
  double turned_away = length(across) / square.high;
  for (const Body& body : body_) turned_away += 1.01 * body.shape->radius * body.defect;
  const double up = (along + ball_height_).rounded();
  return std::sqrt(up * up / square.high + turned_away * turned_away);
}

RAYGAUGE_FUSED bool PrecisePair::follow(const PreciseVector3& u, PrecisePoint& point,
                                        const PrecisePoint* followed) const {
  PreciseVector3 x[2];
  for (int i = 0; i < 2; ++i) {
    const std::int32_t index = i == 0 ? point.index_1 : point.index_2;
    const SpatialShape& shape = *body_[i].shape;
    if (index >= 0 || shape.kind == Kind::point) {
      x[i] = precise(core_vertex(shape, std::max(index, 0)));
      continue;
    }
    if (shape.kind != Kind::ellipsoid && shape.kind != Kind::frustum) return false;
    if (followed != nullptr && index == (i == 0 ? followed->index_1 : followed->index_2)) {
      x[i] = i == 0 ? followed->x1 : followed->x2;
      continue;
    }
    const PreciseVector3 v = turn_back(body_[i], i == 0 ? u : -u);
    if (shape.kind == Kind::ellipsoid) {
      ellipsoid_support(shape, v, &x[i]);
    } else {
      const RimView view(shape, v);
      if (view.near_axis) return false;
      x[i] = view.point(shape, index);
    }
  }
  point.x1 = x[0];
  point.x2 = x[1];
  place(point);
  return true;
}

RAYGAUGE_FUSED bool PrecisePair::vertex(std::int32_t index_1, std::int32_t index_2,
                                        PrecisePoint& point) const {
  if (!vertices_ || !has_vertex(*body_[0].shape, index_1) || !has_vertex(*body_[1].shape, index_2))
    return false;
  point.x1 = precise(core_vertex(*body_[0].shape, index_1));
  point.x2 = precise(core_vertex(*body_[1].shape, index_2));
  point.index_1 = index_1;
  point.index_2 = index_2;
  place(point);
  return true;
}

// With E = RᵀR - 1, the vector R(1 - E)a is R⁻ᵀa but for E².
RAYGAUGE_FUSED bool PrecisePair::disc_contact(int i, std::int32_t index, PreciseVector3& u,
                                              DoubleDouble& height, PrecisePoint& point) {
  const Body& body = body_[i];
  const SpatialShape& shape = *body.shape;
  const bool top = index == SpatialPoint::kTopDisc;
  const PreciseVector3 axis = precise(shape.top) - precise(shape.base);
  const DoubleDouble square = dot(axis, axis);
  const PreciseVector3 outward = (top ? axis : -axis) * (DoubleDouble{1} / sqrt(square));
  u = turn(body, outward);
  u = u - turn(body, turn_back(body, u) - outward);
  if (i == 1) u = -u;
  point = support(u, height);
  PreciseVector3& x = i == 0 ? point.x1 : point.x2;
  const PreciseVector3 center = precise(top ? shape.top : shape.base);
  PreciseVector3 q;
  (i == 0 ? point.index_1 : point.index_2) = PrecisePoint::kSmooth;
  x = center;
  for (int refinement = 0; refinement < 3; ++refinement) {
    place(point);
    const PreciseVector3 away = turn_back(body, i == 0 ? -point.s : point.s);
    q = q + away - axis * (dot(away, axis) / square);
    x = center + q;
  }
  place(point);
  const double radius = top ? shape.top_radius : shape.base_radius;
  return std::sqrt(dot(q, q).high) + error_ < radius * (1 - 0x1p-50);
}

// A step of the projected gradient: x is nearest if it is what the core has nearest to x - Rᵀs.
RAYGAUGE_FUSED bool PrecisePair::project(PrecisePoint& point) const {
  const int i = has_projection(*body_[0].shape) ? 0 : 1;
  const SpatialShape &shape = *body_[i].shape, &other = *body_[1 - i].shape;
  if (!has_projection(shape) || other.kind != Kind::point) return false;
  PreciseVector3& x = i == 0 ? point.x1 : point.x2;
  (i == 0 ? point.x2 : point.x1) = precise(other.center);
  const PreciseVector3 back = turn_back(body_[i], point.s);
  x = nearest_in_core(shape, i == 0 ? x - back : x + back);
  (i == 0 ? point.index_1 : point.index_2) = PrecisePoint::kSmooth;
  (i == 0 ? point.index_2 : point.index_1) = 0;
  place(point);
  return true;
}

// With the support point c + Lz for v, z = Lᵀv/|Lᵀv|, the point c + Lz - r is inside if |z - L⁻¹r|² < 1.
// There z·L⁻¹r = v·r/|Lᵀv|, and |L⁻¹r| <= |r|/ρ, ρ the radius of a ball inside: it is if 2 v·r > |Lᵀv|
// (|r|/ρ)². v·r >= height - margin and |r| <= away + margin are known, and |Lᵀv| is at most twice the extent.
bool PrecisePair::inside_ellipsoid(const SpatialShape& shape, double height, double away,
                                   double margin) const {
  const double r = away + margin, radius = shape.inner_radius;
  return radius > 0 && height - margin > shape.extent * (r / radius) * (r / radius) * (1 + 0x1p-30);
}

// Whether the ball of radius `margin` about y is inside.
bool PrecisePair::inside_frustum(const SpatialShape& shape, const PreciseVector3& y, double margin) {
  const PreciseVector3 base = precise(shape.base);
  const PreciseVector3 axis = precise(shape.top) - base, from_base = y - base;
  const DoubleDouble square = dot(axis, axis);
  const DoubleDouble share = dot(from_base, axis) / square;
  const double axis_length = std::sqrt(square.high);
  const double edge = margin / axis_length * (1 + 0x1p-40);
  if (!(share > DoubleDouble{edge}) || !(share < DoubleDouble{1} - DoubleDouble{edge})) return false;
  const PreciseVector3 across = from_base - axis * share;
  const DoubleDouble rise = two_sum(shape.top_radius, -shape.base_radius);
  const DoubleDouble room = rise * share + shape.base_radius - sqrt(dot(across, across));
  return room.rounded() > margin * (2 + std::fabs(rise.high) / axis_length);
}

// The point of the other core is x_1 - R⁻¹s in the frame of the first one, x_2 + R⁻¹s in that of the second,
// and R⁻¹ is Rᵀ but for the defect of the pose.
RAYGAUGE_FUSED bool PrecisePair::overlap(const PreciseVector3& u, const PrecisePoint& point) const {
  const Vector3 s = rounded(point.s), normal = rounded(u);
  const double away = length(s), height = dot(normal, s) / length(normal);
  for (int i = 0; i < 2; ++i) {
    const SpatialShape& shape = *body_[i].shape;
    const double margin = 4 * (error_ + body_[i].defect * away) + 0x1p-48 * away;
    if (shape.kind == Kind::ellipsoid && inside_ellipsoid(shape, height, away, margin)) return true;
    if (shape.kind != Kind::frustum) continue;
    const PreciseVector3 back = turn_back(body_[i], point.s);
    if (inside_frustum(shape, i == 0 ? point.x1 - back : point.x2 + back, margin)) return true;
  }
  return false;
}

RAYGAUGE_FUSED PreciseVector3 PrecisePair::ball_points(const PreciseVector3& u) const {
  PreciseVector3 sum;
  for (const Body& body : body_) {
    if (!(body.shape->radius > 0)) continue;
    const PreciseVector3 inner = turn_back(body, u);
    const DoubleDouble size = sqrt(dot(inner, inner));
    if (size.high > 0) sum = sum + turn(body, inner * (DoubleDouble{body.shape->radius} / size));
  }
  return sum;
}

PreciseVector3 PrecisePair::through_balls(const PreciseVector3& v) const { return v - ball_points(v); }

RAYGAUGE_FUSED PreciseVector3 PrecisePair::between_centers() const {
  return turn(body_[1], body_[1].shape->center) - turn(body_[0], body_[0].shape->center) - apart_;
}

namespace {

// 3/N Σ (x - c)(x - c)ᵀ: L Lᵀ for points all over an ellipsoid.
Matrix3 spread_of(const SpatialShape& shape) {
  Matrix3 M;
  const double share = 3 / static_cast<double>(shape.size);
  for (std::ptrdiff_t i = 0; i < shape.size; ++i) {
    const Vector3 x = core_vertex(shape, static_cast<std::int32_t>(i)) - shape.center;
    M.column[0] = M.column[0] + x * (share * x.x);
    M.column[1] = M.column[1] + x * (share * x.y);
    M.column[2] = M.column[2] + x * (share * x.z);
  }
  return M;
}

}  // namespace

// L Lᵀ of the ellipsoid with about the axes of the body, added to M.
void PrecisePair::add_axes(const Body& body, PreciseVector3* M) {
  const SpatialShape& shape = *body.shape;
  const auto add = [&](const Vector3& axis) {
    const PreciseVector3 a = turn(body, axis);
    M[0] = M[0] + a * a.x;
    M[1] = M[1] + a * a.y;
    M[2] = M[2] + a * a.z;
  };
  double round = shape.radius;
  if (shape.kind == Kind::ellipsoid) {
    for (const Vector3& axis : shape.axis.column) add(axis);
  } else if (shape.kind == Kind::box) {
    const Vector3& half = shape.axis.column[0];
    for (const Vector3& axis : {Vector3{half.x, 0, 0}, Vector3{0, half.y, 0}, Vector3{0, 0, half.z}})
      add(axis);
  } else if (shape.kind == Kind::points) {
    const Matrix3 spread = spread_of(shape);
    for (int j = 0; j < 3; ++j) {
      const PreciseVector3 column = turn(body, spread.column[j]);
      for (int k = 0; k < 3; ++k) M[k] = M[k] + column * DoubleDouble{body.R[k][j]};
    }
  } else if (shape.kind != Kind::point) {
    add((shape.top - shape.base) * 0.5);
    round += 0.5 * (shape.base_radius + shape.top_radius);
  }
  const DoubleDouble square = two_product(round, round);
  M[0].x = M[0].x + square;
  M[1].y = M[1].y + square;
  M[2].z = M[2].z + square;
}

PreciseVector3 PrecisePair::rough_normal(const PreciseVector3& p) const {
  PreciseVector3 M[3];
  for (const Body& body : body_) add_axes(body, M);
  const PreciseVector3 u = cross(M[1], M[2]) * p.x + cross(M[2], M[0]) * p.y + cross(M[0], M[1]) * p.z;
  const double size = std::sqrt(dot(u, u).high);
  return size > 0 ? u * DoubleDouble{1 / size} : PreciseVector3{};
}

bool PrecisePair::balls_meet(double v) const { return v + error_ < body_[0].ball + body_[1].ball; }

}  // namespace raygauge
