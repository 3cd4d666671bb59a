// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/bodies/body_oracles.h"

#include <cmath>
#include <utility>

namespace raygauge {
namespace {

// The centre of a curved piece of core i, in the frame of the first body.
Vector3 center_of(const SpatialPair& pair, int i, std::int32_t index) {
  const Vector3 center = with_core(pair.shape(i), [&](const auto& core) {
    if constexpr (requires { core.center_of(index); }) return Vector3{core.center_of(index)};
    return core.shape.center;
  });
  return i == 0 ? center : pair.frame().from_second(center);
}

}  // namespace

SpatialOracle::SpatialOracle(SpatialPair& pair) : pair_(pair) {
  error_ = pair.error();
  size_ = 2 * pair.size();
  follows_ = pair.is_curved() && pair.prisms().empty();
}

double SpatialOracle::support(const Vector3& u, DepthPoint<double>& point) {
  SpatialPoint found;
  pair_.support(u, found);
  put(found, point);
  return dot(u, found.s);
}

void SpatialOracle::put(const SpatialPoint& found, DepthPoint<double>& point) {
  point.s = found.s;
  point.a1 = found.a1;
  point.a2 = found.a2;
  point.index_1 = found.index_1;
  point.index_2 = found.index_2;
}

void SpatialOracle::support_again(const DepthMemory::Corner& corner, DepthPoint<double>& point) {
  SpatialPoint found;
  point.u = pair_.support_again(corner, found);
  put(found, point);
}

void SpatialOracle::follow(const Vector& u, DepthPoint<double>* point, int count) {
  SpatialPoint found[3];
  for (int k = 0; k < count; ++k) {
    found[k] = {point[k].s, point[k].a1, point[k].a2, point[k].index_1, point[k].index_2};
    pair_.follow(u, found[k], k > 0 ? found + k - 1 : nullptr);
    put(found[k], point[k]);
    point[k].u = u;
  }
}

PointBend SpatialOracle::bend(const Vector& u, const Vector& e, const Vector& f,
                              const DepthPoint<double>& point) {
  PointBend bend;
  const Vector3 x[2] = {point.a1, point.a2};
  for (int i = 0; i < 2; ++i) {
    const std::int32_t index = i == 0 ? point.index_1 : point.index_2;
    if (!is_curved(pair_.shape(i))) continue;
    PointBend::Piece& piece = bend.of[i];
    const Vector3 y = x[i] - center_of(pair_, i, index);
    const double along = dot(u, y);
    const Vector3 across = y - u * along;
    Matrix3 H{};
    pair_.add_hessian_of(i, u, index, H);
    const Vector3 He = H * e, Hf = H * f;
    const double height = std::fabs(along);
    piece = {height, length(across), dot(e, He) * height, dot(e, Hf) * height, dot(f, Hf) * height};
  }
  return bend;
}

// Across the sides of two frustums, whose normals have u·a = s_1 with the axis of the first and u·b = -s_2
// with that of the second: u = α a + β b ± γ a × b, on the side where D is lower. Its corners are those of
// the sum of both lines.
bool SpatialOracle::likely_face(DepthPoint<double>* corner, Vector& n) {
  constexpr double kParallel = 1e-3;
  const SpatialShape &one = pair_.shape(0), &two = pair_.shape(1);
  if (!follows_ || !has_discs(one) || !has_discs(two)) return false;
  const Vector3 a = one.axis.column[0], b = pair_.frame().R * two.axis.column[0], across = cross(a, b);
  const double square = dot(across, across), cosine = dot(a, b), s = one.side_along, t = -two.side_along;
  const double of_a = s - cosine * t, of_b = t - cosine * s, rest = square - of_a * s - of_b * t;
  if (!(square > kParallel && rest > 0)) return false;
  const Vector3 apart = one.base - pair_.frame().from_second(two.base);
  n = a * of_a + b * of_b + across * (dot(apart, across) > 0 ? -std::sqrt(rest) : std::sqrt(rest));
  n = n * (1 / length(n));
  constexpr std::int32_t kBase = FrustumCore::kBase, kTop = FrustumCore::kTop;
  constexpr std::int32_t kRims[4][2] = {{kBase, kBase}, {kTop, kBase}, {kTop, kTop}, {kBase, kTop}};
  for (int k = 0; k < 4; ++k) {
    corner[k].index_1 = kRims[k][0];
    corner[k].index_2 = kRims[k][1];
  }
  follow(n, corner, 3);
  follow(n, corner + 3, 1);
  if (dot(cross(corner[1].s - corner[0].s, corner[2].s - corner[0].s), n) < 0)
    std::swap(corner[1], corner[3]);
  return true;
}

bool PreciseOracle::bind(const SpatialPair& pair) {
  pair_ = &pair;
  if (!precise_.bind(pair)) return false;
  error_ = precise_.error();
  size_ = 2 * pair.size();
  height_ = pair.dimension() == 2 ? pair.size() : 0.0;
  return true;
}

double PreciseOracle::support(const PreciseVector3& u, DepthPoint<DoubleDouble>& point) {
  DoubleDouble height;
  const PrecisePoint found = precise_.support(u, height);
  point.s = found.s;
  point.a1 = rounded(found.a1);
  point.a2 = pair_->frame().from_second(rounded(found.a2));
  if (!(height_ > 0)) return height.rounded();
  point.s.z = point.s.z + (u.z.high < 0 ? -height_ : height_);
  return (height + u.z * (u.z.high < 0 ? -height_ : height_)).rounded();
}

}  // namespace raygauge
