// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/bodies/body_oracles.h"

#include <cmath>

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
