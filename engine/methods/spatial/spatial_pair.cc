// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/spatial_pair.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/exact_sum.h"
#include "raygauge/sets/convex_set.h"

namespace raygauge {
namespace {

constexpr double kSmallest = 1e-70,
                 kLargest = 1e70;  // of what is squared and multiplied up to the fourth power

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

void add_prisms(std::span<const Vector3> prisms, const Vector3& u, SpatialPoint& point) {
  for (const Vector3& v : prisms) point.s = dot(u, v) < 0 ? point.s - v : point.s + v;
}

void add_curvature(const Matrix3& form, const CoreCurvature& of, Matrix3& H) {
  H.column[0] = H.column[0] + (form.column[0] - of.y * of.y.x) * of.share;
  H.column[1] = H.column[1] + (form.column[1] - of.y * of.y.y) * of.share;
  H.column[2] = H.column[2] + (form.column[2] - of.y * of.y.z) * of.share;
}

}  // namespace

void Curvatures::place(const FirstBodyFrame& frame) {
  for (int i = 0; i < 2; ++i) {
    with_core(frame.shape(i), [&](const auto& core) {
      if constexpr (requires { core.kIsCurved; }) {
        axes_[i] = frame.shape(i).axis;
        for (int j = 0; i == 1 && j < core.kAxes; ++j) axes_[i].column[j] = frame.R * axes_[i].column[j];
        form_[i] = core.form(axes_[i]);
      }
    });
  }
}

void Curvatures::add(const SpatialShape& shape, int i, const Vector3& u, std::int32_t index, double weight,
                     Matrix3& H) const {
  with_core(shape, [&](const auto& core) {
    if constexpr (requires { core.kIsCurved; }) {
      CoreCurvature curvature = core.curvature(axes_[i], u, index);
      curvature.share *= weight;
      add_curvature(form_[i], curvature, H);
    }
  });
}

// The coordinates of R_1 c_1 + t_1 - R_2 c_2 - t_2, summed without rounding where they may be 0.
bool share_center(const SpatialPair& pair) noexcept {
  const int n = pair.dimension();
  for (int j = 0; j < n; ++j) {
    ExactSum sum;
    for (int i = 0; i < 2; ++i) {
      const double sign = i == 0 ? 1.0 : -1.0;
      const PoseNumbers& pose = pair.pose(i);
      const double c[3] = {pair.shape(i).center.x, pair.shape(i).center.y, pair.shape(i).center.z};
      if (pose.R == nullptr) {
        sum.add(sign * c[j]);
        continue;
      }
      for (int k = 0; k < n; ++k) sum.add_product(sign * pose.R[k * n + j], c[k]);
      sum.add(sign * pose.t[j]);
    }
    if (!sum.is_zero()) return false;
  }
  return true;
}

bool SpatialPair::bind(const ConvexSet& first, const ConvexSet& second, InstructionSet isa) {
  const SpatialShape *one = first.spatial_shape(), *two = second.spatial_shape();
  if (one == nullptr || two == nullptr || first.dimension() != second.dimension()) return false;
  bind(*one, *two, first.dimension(), isa);
  return true;
}

void SpatialPair::bind(const SpatialShape& first, const SpatialShape& second, int n, InstructionSet isa) {
  frame_.dimension = n;
  frame_.body[0] = &first;
  frame_.body[1] = &second;
  isa_ = isa;
  size_of_shapes_ = first.extent + first.radius + second.extent + second.radius;
  CorePair::begin();
}

bool SpatialPair::place(const PoseNumbers& first, const PoseNumbers& second) {
  pose_[0] = first;
  pose_[1] = second;
  Matrix3 R;
  Vector3 t;
  read(first, frame_.dimension, frame_.W, frame_.w);
  frame_.defect = first.defect;
  read(second, frame_.dimension, R, t);
  anchor_ = shape(0).center;
  anchor_radius_ = shape(0).inner_radius;
  for (int j = 0; j < 3; ++j) frame_.R.column[j] = frame_.W.transposed_times(R.column[j]);
  apart_ = t - frame_.w;
  frame_.t = frame_.W.transposed_times(apart_);
  const double size = size_of_shapes_ + length(apart_);
  if (!(size > kSmallest && size < kLargest)) return false;
  size_ = size;
  error_ = size * (kRounding + 2 * (first.defect + second.defect));
  prisms_ = 0;
  known_radius_ = 0;
  if (frame_.dimension == 2) add_prism({0, 0, size});
  between_centers_ = frame_.R * shape(1).center + frame_.t - anchor_;
  if (is_curved()) curvatures_.place(frame_);
  queries_ = 0;
  return true;
}

bool SpatialPair::scale_first_about_origin(const ConvexSet& first) {
  const Vector3 origin = frame_.W.transposed_times(-frame_.w);
  if (length(origin - anchor_) == 0) return true;
  const double size = error_ / kRounding + length(frame_.w);
  error_ = size * (kRounding + 4 * pose_[0].defect) + error_;
  const double c[3] = {origin.x, origin.y, origin.z};
  anchor_ = origin;
  between_centers_ = frame_.R * shape(1).center + frame_.t - anchor_;
  anchor_radius_ = first.inner_radius_unchecked(c);
  return anchor_radius_ > 0;
}

void SpatialPair::support(const Vector3& u, SpatialPoint& point) {
  look<true>(u, point, [](int, const Vector3&, double) {});
  frame_.subtract(point);
  add_prisms(prisms(), u, point);
}

// What has a vertex on the one side is the highest point along what is fixed to that. Curves are along the
// mean of what is fixed to either: the difference of points for the same direction is on the surface.
// Of two curved bodies one direction is for both: fixed to the one that has discs, as its side or a disc
// mostly is what the other one rests on, else the mean of those that are fixed to either.
Vector3 SpatialPair::support_again(const DepthMemory::Corner& corner, SpatialPoint& point) {
  const auto vector = [](const std::array<float, 3>& way) { return Vector3{way[0], way[1], way[2]}; };
  const bool curves = raygauge::is_curved(shape(0)) && raygauge::is_curved(shape(1));
  const bool discs = has_discs(shape(0)), other_discs = has_discs(shape(1));
  Vector3 u_1 = frame_.R * vector(corner.way_1), u_2 = vector(corner.way_2);
  if (curves) u_1 = u_2 = discs == other_discs ? (u_1 + u_2) * 0.5 : discs ? u_2 : u_1;
  look_again(u_1, u_2, corner, point);
  frame_.subtract(point);
  add_prisms(prisms(), u_2, point);
  return u_2;
}

DepthMemory::Corner SpatialPair::corner_of(const Vector3& u, const SpatialPoint& point) const {
  const auto way = [](const Vector3& v) {
    return std::array<float, 3>{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  };
  return {way(frame_.R.transposed_times(u)), way(u), point.index_1, point.index_2};
}

bool SpatialPair::follow(const Vector3& u, SpatialPoint& point, const SpatialPoint* followed) const {
  return find_pieces(u, point, followed);
}

bool SpatialPair::smooth_form(const Vector3& u, Matrix3& M) const {
  const bool round[2] = {has_curved_surface(shape(0)), has_curved_surface(shape(1))};
  if (!round[0] && !round[1]) return false;
  double ball = radius();
  for (int i = 0; i < 2; ++i) {
    if (round[i] || is_point(shape(i))) continue;
    if (raygauge::is_curved(shape(i)) || !(shape(i).inner_radius > shape(i).radius)) return false;
    ball += shape(i).inner_radius - shape(i).radius;
  }
  ball /= length(u);
  M = {{{ball, 0, 0}, {0, ball, 0}, {0, 0, ball}}};
  for (int i = 0; i < 2; ++i) {
    if (!round[i]) continue;
    const Matrix3& S = curvatures_.form(i);
    const double share = 1 / std::sqrt(dot(u, S * u));
    for (int j = 0; j < 3; ++j) M.column[j] = M.column[j] + S.column[j] * share;
  }
  return true;
}

void SpatialPair::add_hessian(const Vector3& u, std::int32_t index_1, std::int32_t index_2, double weight,
                              Matrix3& H) const {
  curvatures_.add(shape(0), 0, u, index_1, weight, H);
  curvatures_.add(shape(1), 1, u, index_2, weight, H);
}

}  // namespace raygauge
