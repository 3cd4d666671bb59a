// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/spatial_pair.h"

#include <algorithm>
#include <cmath>

#include "engine/kernels/kernel.h"
#include "engine/methods/spatial/curved_support.h"
#include "engine/numerics/exact_sum.h"
#include "raygauge/sets/direction_table.h"

namespace raygauge {
namespace {

using Kind = SpatialShape::Kind;

constexpr double kSmallest = 1e-70,
                 kLargest = 1e70;  // of what is squared and multiplied up to the fourth power
constexpr int kLanes = 8;          // of PointSet's blocks

// The rotation and the translation of a pose of R^n; of R^2 in the plane z = 0.
void read(const PoseNumbers& pose, int n, Matrix3& R, Vector3& t) {
  const double* r = pose.R;
  if (r != nullptr && n == 3) {
    R = {{{r[0], r[1], r[2]}, {r[3], r[4], r[5]}, {r[6], r[7], r[8]}}};
    t = {pose.t[0], pose.t[1], pose.t[2]};
    return;
  }
  R = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  t = {};
  if (r == nullptr) return;
  R.column[0] = {r[0], r[1], 0};
  R.column[1] = {r[2], r[3], 0};
  t = {pose.t[0], pose.t[1], 0};
}

Vector3 rim_point(const SpatialShape& shape, const Vector3& v, std::int32_t index) {
  double across = 0;
  const Vector3 w = across_axis(shape, v, across);
  return index == SpatialPoint::kTop ? shape.top + w * shape.top_radius : shape.base + w * shape.base_radius;
}

Vector3 frustum_support(const SpatialShape& shape, const Vector3& v, std::int32_t& index) {
  double across = 0;
  const Vector3 w = across_axis(shape, v, across);
  const double base = dot(v, shape.base) + shape.base_radius * across;
  const double top = dot(v, shape.top) + shape.top_radius * across;
  index = top > base ? SpatialPoint::kTop : SpatialPoint::kBase;
  return top > base ? shape.top + w * shape.top_radius : shape.base + w * shape.base_radius;
}

std::int32_t highest_rim(const SpatialShape& shape, const Vector3& v) {
  std::int32_t index = -1;
  if (shape.kind == Kind::frustum) frustum_support(shape, v, index);
  return index;
}

Vector3 ellipsoid_support(const SpatialShape& shape, const Vector3& v) {
  const Vector3 z = shape.axis.transposed_times(v);
  const double size = length(z);
  return size > 0 ? shape.center + shape.axis * (z * (1 / size)) : shape.center;
}

// The point that a curved core's piece has for v; a vertex stays where it is.
Vector3 piece_point(const SpatialShape& shape, const Vector3& v, std::int32_t index, const Vector3& vertex) {
  if (shape.kind == Kind::ellipsoid) return ellipsoid_support(shape, v);
  return shape.kind == Kind::frustum ? rim_point(shape, v, index) : vertex;
}

Vector3 box_vertex(const SpatialShape& shape, std::int32_t index) {
  const Vector3& half = shape.axis.column[0];
  return shape.center + Vector3{(index & 1) != 0 ? -half.x : half.x, (index & 2) != 0 ? -half.y : half.y,
                                (index & 4) != 0 ? -half.z : half.z};
}

// Point `index`, which there is, of points.
Vector3 point_of(const SpatialShape& shape, std::int32_t index) {
  if (shape.table != nullptr) return shape.table->point(index);
  const int n = shape.coordinates;
  const double* p = shape.blocks + std::ptrdiff_t{index / kLanes} * n * kLanes + index % kLanes;
  return {p[0], p[kLanes], n == 3 ? p[std::ptrdiff_t{2} * kLanes] : 0.0};
}

bool vertex_of(const SpatialShape& shape, std::int32_t index, Vector3& x) {
  switch (shape.kind) {
    case Kind::point:
      x = shape.center;
      return index == 0;
    case Kind::segment:
      x = index == 0 ? shape.center + shape.axis.column[0] : shape.center - shape.axis.column[0];
      return index == 0 || index == 1;
    case Kind::box:
      x = box_vertex(shape, index);
      return index >= 0 && index < 8;
    case Kind::points:
      if (index < 0 || index >= shape.size) return false;
      x = point_of(shape, index);
      return true;
    default:
      return false;
  }
}

bool has_vertices(const SpatialShape& shape) {
  return shape.kind != Kind::ellipsoid && shape.kind != Kind::frustum;
}

}  // namespace

bool SpatialPair::bind(const ConvexSet& first, const ConvexSet& second, InstructionSet isa) {
  dimension_ = first.dimension();
  if ((dimension_ != 2 && dimension_ != 3) || second.dimension() != dimension_) return false;
  if (!first.spatial_shape_unchecked(shape_[0]) || !second.spatial_shape_unchecked(shape_[1])) return false;
  isa_ = isa;
  size_of_shapes_ = shape_[0].extent + shape_[0].radius + shape_[1].extent + shape_[1].radius;
  vertices_ = raygauge::has_vertices(shape_[0]) && raygauge::has_vertices(shape_[1]);
  return true;
}

bool SpatialPair::place(const PoseNumbers& first, const PoseNumbers& second) {
  pose_[0] = first;
  pose_[1] = second;
  Matrix3 R;
  Vector3 t;
  read(first, dimension_, W_, w_);
  read(second, dimension_, R, t);
  anchor_ = shape_[0].center;
  anchor_radius_ = shape_[0].inner_radius;
  for (int j = 0; j < 3; ++j) R_.column[j] = W_.transposed_times(R.column[j]);
  apart_ = t - w_;
  t_ = W_.transposed_times(apart_);
  const double size = size_of_shapes_ + length(apart_);
  if (!(size > kSmallest && size < kLargest)) return false;
  size_ = size;
  error_ = size * (kRounding + 2 * (first.defect + second.defect));
  prisms_ = 0;
  known_radius_ = 0;
  if (dimension_ == 2) add_prism({0, 0, size});
  between_centers_ = R_ * shape_[1].center + t_ - anchor_;
  for (int i = 0; i < 2; ++i) {
    if (shape_[i].kind == Kind::ellipsoid) place_ellipsoid(i);
  }
  queries_ = 0;
  return true;
}

// The coordinates of R_1 c_1 + t_1 - R_2 c_2 - t_2, summed without rounding where they may be 0.
bool SpatialPair::share_center() const noexcept {
  const int n = dimension_;
  for (int j = 0; j < n; ++j) {
    ExactSum sum;
    for (int i = 0; i < 2; ++i) {
      const double sign = i == 0 ? 1.0 : -1.0;
      const double c[3] = {shape_[i].center.x, shape_[i].center.y, shape_[i].center.z};
      if (pose_[i].R == nullptr) {
        sum.add(sign * c[j]);
        continue;
      }
      for (int k = 0; k < n; ++k) sum.add_product(sign * pose_[i].R[k * n + j], c[k]);
      sum.add(sign * pose_[i].t[j]);
    }
    if (!sum.is_zero()) return false;
  }
  return true;
}

void SpatialPair::place_ellipsoid(int i) {
  Matrix3& L = axis_[i];
  for (int j = 0; j < 3; ++j) L.column[j] = i == 0 ? shape_[0].axis.column[j] : R_ * shape_[1].axis.column[j];
  square_[i] = square_of(L);
}

bool SpatialPair::scale_first_about_origin(const ConvexSet& first) {
  const Vector3 origin = W_.transposed_times(-w_);
  if (length(origin - anchor_) == 0) return true;
  const double size = error_ / kRounding + length(w_);
  error_ = size * (kRounding + 4 * pose_[0].defect) + error_;
  const double c[3] = {origin.x, origin.y, origin.z};
  anchor_ = origin;
  between_centers_ = R_ * shape_[1].center + t_ - anchor_;
  anchor_radius_ = first.inner_radius_unchecked(c);
  return anchor_radius_ > 0;
}

std::int32_t SpatialPair::highest(const SpatialShape& shape, const Vector3& v) const {
  if (shape.table != nullptr) {
    const std::int32_t listed = shape.table->highest(v);
    if (listed >= 0) return listed;
  }
  const double u[3] = {v.x, v.y, v.z};
  std::ptrdiff_t index = 0;
  kernels_for(isa_).price(shape.blocks, shape.block_count, shape.coordinates, u, &index);
  return static_cast<std::int32_t>(std::min(index, shape.size - 1));
}

[[gnu::always_inline]] inline Vector3 SpatialPair::support_of(int i, const Vector3& v, std::int32_t& index) {
  const SpatialShape& shape = shape_[i];
  ++queries_;
  switch (shape.kind) {
    case Kind::point:
      index = 0;
      return shape.center;
    case Kind::segment:
      index = dot(v, shape.axis.column[0]) >= 0 ? 0 : 1;
      return index == 0 ? shape.center + shape.axis.column[0] : shape.center - shape.axis.column[0];
    case Kind::box:
      index = (v.x < 0 ? 1 : 0) | (v.y < 0 ? 2 : 0) | (v.z < 0 ? 4 : 0);
      return box_vertex(shape, index);
    case Kind::ellipsoid:
      return ellipsoid_support(shape, v);
    case Kind::frustum:
      return frustum_support(shape, v, index);
    case Kind::points:
      index = highest(shape, v);
      return point_of(shape, index);
  }
  return shape.center;
}

void SpatialPair::support(const Vector3& u, SpatialPoint& point) {
  point.index_1 = point.index_2 = -1;
  point.a1 = support_of(0, u, point.index_1);
  point.a2 = R_ * support_of(1, R_.transposed_times(-u), point.index_2) + t_;
  point.s = point.a1 - point.a2;
  if (prisms_ > 0) add_prisms(u, point);
}

void SpatialPair::add_prisms(const Vector3& u, SpatialPoint& point) const {
  for (const Vector3& v : prisms()) point.s = dot(u, v) < 0 ? point.s - v : point.s + v;
}

bool SpatialPair::core_vertex(std::int32_t index_1, std::int32_t index_2, SpatialPoint& point) const {
  Vector3 x;
  if (!vertex_of(shape_[0], index_1, point.a1) || !vertex_of(shape_[1], index_2, x)) return false;
  point.a2 = R_ * x + t_;
  point.s = point.a1 - point.a2;
  point.index_1 = index_1;
  point.index_2 = index_2;
  return true;
}

void SpatialPair::follow(const Vector3& u, SpatialPoint& point) const {
  point.a1 = piece_point(shape_[0], u, point.index_1, point.a1);
  if (is_curved(shape_[1].kind)) {
    point.a2 = R_ * piece_point(shape_[1], R_.transposed_times(-u), point.index_2, {}) + t_;
  }
  point.s = point.a1 - point.a2;
}

bool SpatialPair::hessian(const Vector3& u, Matrix3& H) const {
  const bool curved = radius() > 0 || shape_[0].kind == Kind::ellipsoid || shape_[1].kind == Kind::ellipsoid;
  if (!curved || prisms_ > 0) return false;
  H = {};
  add_hessian(0, u, highest_rim(shape_[0], u), 1, H);
  add_hessian(1, u, highest_rim(shape_[1], R_.transposed_times(-u)), 1, H);
  const double size = length(u);
  if (radius() > 0) add_projector(radius() / size, u * (1 / size), {}, H);
  return true;
}

// `weight` times the Hessian of the support function of core i, or of its rim `index`, at u, added to H, in
// the first frame: (L Lᵀ - y yᵀ)/|Lᵀu| with y = L Lᵀu/|Lᵀu| for an ellipsoid, that of the disc for a rim.
void SpatialPair::add_hessian(int i, const Vector3& u, std::int32_t index, double weight, Matrix3& H) const {
  const SpatialShape& shape = shape_[i];
  if (shape.kind == Kind::ellipsoid) {
    const Vector3 z = axis_[i].transposed_times(u);
    const double size = length(z);
    if (!(size > 0)) return;
    add_ellipsoid_hessian(square_[i], axis_[i] * (z * (1 / size)), weight / size, H);
  } else if (shape.kind == Kind::frustum) {
    const Vector3& own = shape.axis.column[0];
    const Vector3 a = i == 0 ? own : R_ * own;
    Vector3 w = u - a * dot(u, a);
    const double across = length(w);
    if (!(across > kAlongAxis * length(u))) return;
    w = w * (1 / across);
    const double radius = index == SpatialPoint::kTop ? shape.top_radius : shape.base_radius;
    add_projector(weight * radius / across, a, w, H);
  }
}

void SpatialPair::add_hessian(const Vector3& u, const SpatialPoint& point, double weight, Matrix3& H) const {
  add_hessian(0, u, point.index_1, weight, H);
  add_hessian(1, u, point.index_2, weight, H);
}

void SpatialPair::to_world(const Vector3& vector, double* out) const noexcept {
  const Vector3 v = W_ * vector;
  out[0] = v.x;
  out[1] = v.y;
  if (dimension_ == 3) out[2] = v.z;
}

void SpatialPair::turn_normal(const Vector3& u, double* out) const noexcept {
  to_world(u - (W_.transposed_times(W_ * u) - u), out);
}

void SpatialPair::point_to_world(const Vector3& point, double* out) const noexcept {
  const Vector3 v = W_ * point + w_;
  out[0] = v.x;
  out[1] = v.y;
  if (dimension_ == 3) out[2] = v.z;
}

Vector3 SpatialPair::to_body(const double* vector) const noexcept {
  return W_.transposed_times({vector[0], vector[1], dimension_ == 3 ? vector[2] : 0.0});
}

}  // namespace raygauge
