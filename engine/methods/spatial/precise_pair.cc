// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/precise_pair.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/fused.h"

namespace raygauge {
namespace {

constexpr double kSmallest = 1e-30, kLargest = 1e30;  // of sizes whose products can be split in two
constexpr double kError = 0x1p-88;

}  // namespace

bool PrecisePair::bind(const SpatialPair& pair) {
  spatial_ = &pair;
  const int n = pair.dimension();
  double size = 0;
  double t[2][3] = {{0, 0, 0}, {0, 0, 0}};
  for (int i = 0; i < 2; ++i) {
    WorldFrame::Body& body = frame_.body[i];
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
  frame_.apart = {two_sum(t[0][0], -t[1][0]), two_sum(t[0][1], -t[1][1]), two_sum(t[0][2], -t[1][2])};
  size += length(rounded(frame_.apart));
  if (!(size > kSmallest && size < kLargest)) return false;
  error_ = kError * size;
  isa_ = pair.instruction_set();
  CorePair::begin();
  return true;
}

Vector3 PrecisePair::to_first(const PreciseVector3& vector) const {
  const double world[3] = {vector.x.high, vector.y.high, vector.z.high};
  return spatial_->frame().to_body(world);
}

Vector3 PrecisePair::to_world(const Vector3& vector) const {
  double world[3] = {0, 0, 0};
  spatial_->frame().to_world(vector, world);
  return {world[0], world[1], world[2]};
}

namespace {

// |v|, mostly nearly 1: there √(1 + ε) is 1 + ε/2 to 2⁻⁹⁹.
DoubleDouble length_near_one(const PreciseVector3& v) {
  const DoubleDouble square = dot(v, v), beyond = square + -1.0;
  return std::fabs(beyond.high) < 0x1p-48 ? ordered_sum(1, 0.5 * beyond.high) : sqrt(square);
}

}  // namespace

RAYGAUGE_FUSED void PrecisePair::place(PrecisePoint& point) const { frame_.subtract(point); }

template <bool kPoints>
inline DoubleDouble PrecisePair::height_of(const PreciseVector3& u, PrecisePoint& point) {
  DoubleDouble of_core[2];
  ball_height_ = {};
  look<kPoints>(u, point, [&](int i, const PreciseVector3& v, const DoubleDouble& height) {
    of_core[i] = height;
    const double radius = shape(i).radius;
    if (radius > 0) ball_height_ = ball_height_ + length_near_one(v) * radius;
  });
  const DoubleDouble of_cores = loose_sum(of_core[0], of_core[1], dot(u, frame_.apart));
  return radius() > 0 ? of_cores + ball_height_ : of_cores;
}

RAYGAUGE_FUSED DoubleDouble PrecisePair::height(const PreciseVector3& u) {
  PrecisePoint unused;
  return height_of<false>(u, unused);
}

RAYGAUGE_FUSED DoubleDouble PrecisePair::support_parts(const PreciseVector3& u, PrecisePoint& point) {
  return height_of<true>(u, point);
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
  for (const WorldFrame::Body& body : frame_.body) turned_away += 1.01 * body.shape->radius * body.defect;
  const double up = (along + ball_height_).rounded();
  return std::sqrt(up * up / square.high + turned_away * turned_away);
}

RAYGAUGE_FUSED bool PrecisePair::follow(const PreciseVector3& u, PrecisePoint& point,
                                        const PrecisePoint* followed) const {
  return find_pieces(u, point, followed);
}

RAYGAUGE_FUSED bool PrecisePair::vertex(std::int32_t index_1, std::int32_t index_2,
                                        PrecisePoint& point) const {
  return core_vertex(index_1, index_2, point);
}

// With E = RᵀR - 1, the vector R(1 - E)a is R⁻ᵀa but for E².
RAYGAUGE_FUSED bool PrecisePair::disc_contact(int i, std::int32_t index, PreciseVector3& u,
                                              DoubleDouble& height, PrecisePoint& point) {
  const WorldFrame::Body& body = frame_.body[i];
  const SpatialShape& shape = *body.shape;
  const bool top = index == FrustumCore::kTopDisc;
  const PreciseVector3 axis = precise(shape.top) - precise(shape.base);
  const DoubleDouble square = dot(axis, axis);
  const PreciseVector3 outward = (top ? axis : -axis) * (DoubleDouble{1} / sqrt(square));
  u = body.turn(outward);
  u = u - body.turn(body.turn_back(u) - outward);
  if (i == 1) u = -u;
  point = support(u, height);
  PreciseVector3& x = point.a(i);
  const PreciseVector3 center = precise(top ? shape.top : shape.base);
  PreciseVector3 q;
  point.index(i) = kSmoothPiece;
  x = center;
  for (int refinement = 0; refinement < 3; ++refinement) {
    place(point);
    const PreciseVector3 away = body.turn_back(i == 0 ? -point.s : point.s);
    q = q + away - axis * (dot(away, axis) / square);
    x = center + q;
  }
  place(point);
  const double radius = top ? shape.top_radius : shape.base_radius;
  return std::sqrt(dot(q, q).high) + error_ < radius * (1 - 0x1p-50);
}

// A step of the projected gradient: x is nearest if it is what the core has nearest to x - Rᵀs.
RAYGAUGE_FUSED bool PrecisePair::project(PrecisePoint& point) const {
  const int i = has_projection(shape(0)) ? 0 : 1;
  if (!has_projection(shape(i)) || !is_point(shape(1 - i))) return false;
  const PreciseVector3 back = frame_.body[i].turn_back(point.s);
  point.a(i) = with_core(shape(i), [&](const auto& core) {
    const PreciseVector3 y = i == 0 ? point.a1 - back : point.a2 + back;
    if constexpr (requires { core.nearest(y); }) return core.nearest(y);
    return y;
  });
  point.a(1 - i) = precise(shape(1 - i).center);
  point.index(i) = kSmoothPiece;
  point.index(1 - i) = 0;
  place(point);
  return true;
}

RAYGAUGE_FUSED bool PrecisePair::overlap(const PreciseVector3& u, const PrecisePoint& point) const {
  return CorePair::overlap(u, point);
}

RAYGAUGE_FUSED PreciseVector3 PrecisePair::ball_points(const PreciseVector3& u) const {
  PreciseVector3 sum;
  for (const WorldFrame::Body& body : frame_.body) {
    if (!(body.shape->radius > 0)) continue;
    const PreciseVector3 inner = body.turn_back(u);
    const DoubleDouble size = sqrt(dot(inner, inner));
    if (size.high > 0) sum = sum + body.turn(inner * (DoubleDouble{body.shape->radius} / size));
  }
  return sum;
}

PreciseVector3 PrecisePair::through_balls(const PreciseVector3& v) const { return v - ball_points(v); }

RAYGAUGE_FUSED PreciseVector3 PrecisePair::between_centers() const {
  return frame_.body[1].turn(shape(1).center) - frame_.body[0].turn(shape(0).center) - frame_.apart;
}

// L Lᵀ of the ellipsoid with about the axes of the body, added to M.
void PrecisePair::add_axes(int i, PreciseVector3* M) const {
  const Matrix3 axes = with_core(shape(i), [](const auto& core) { return core.half_axes(); });
  for (const Vector3& axis : axes.column) {
    const PreciseVector3 a = frame_.body[i].turn(axis);
    M[0] = M[0] + a * a.x;
    M[1] = M[1] + a * a.y;
    M[2] = M[2] + a * a.z;
  }
  const DoubleDouble square = two_product(shape(i).radius, shape(i).radius);
  M[0].x = M[0].x + square;
  M[1].y = M[1].y + square;
  M[2].z = M[2].z + square;
}

PreciseVector3 PrecisePair::rough_normal(const PreciseVector3& p) const {
  PreciseVector3 M[3];
  for (int i = 0; i < 2; ++i) add_axes(i, M);
  const PreciseVector3 u = cross(M[1], M[2]) * p.x + cross(M[2], M[0]) * p.y + cross(M[0], M[1]) * p.z;
  const double size = std::sqrt(dot(u, u).high);
  return size > 0 ? u * DoubleDouble{1 / size} : PreciseVector3{};
}

bool PrecisePair::balls_meet(double away) const {
  return away + error_ < frame_.body[0].ball + frame_.body[1].ball;
}

}  // namespace raygauge
