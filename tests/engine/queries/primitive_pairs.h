// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <deque>
#include <memory>
#include <random>
#include <vector>

#include "raygauge/numerics/quad.h"
#include "raygauge/queries/pair_batch.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/prepared_set.h"

namespace raygauge {

/// {R x + t : x in the sum of the box of corners p <= q, or of the segment from p to q, or of the hull of
/// points, and a ball}.
struct Primitive {
  enum class Kind : unsigned char { box, ball, capsule, hull };
  static constexpr int kKinds = 4;

  Kind kind = Kind::box;
  Eigen::Vector3d p, q;     ///< the same for a ball
  Eigen::Matrix3Xd points;  ///< of a hull
  double radius = 0;        ///< 0 for a box or a hull
  Pose pose{3};

  std::shared_ptr<const ConvexSet> set() const {
    if (kind == Kind::box) return std::make_shared<Box>(p, q);
    if (kind == Kind::ball) return std::make_shared<Ball>(p, radius);
    if (kind == Kind::hull && points.cols() % 2 == 0) return std::make_shared<PreparedSet>(points);
    if (kind == Kind::hull) return std::make_shared<PointSet>(points);
    return std::make_shared<Capsule>(p, q, radius);
  }
};

/// max u·x over the body, in quadruple precision: with v = Rᵀu, of the box Σ max(v_k p_k, v_k q_k), of the
/// segment max(v·p, v·q), of a hull the largest v·x, and r|v| + u·t.
inline Quad height_of(const Primitive& body, const double* u, int sign) {
  Quad v[3], square = 0, height = 0, at_p = 0, at_q = 0;
  const bool hull = body.kind == Primitive::Kind::hull;
  for (int k = 0; k < 3; ++k) {
    v[k] = 0;
    for (int j = 0; j < 3; ++j) v[k] += Quad{sign * u[j]} * body.pose.rotation_data()[3 * k + j];
    square += v[k] * v[k];
    height += Quad{sign * u[k]} * body.pose.translation_data()[k];
    const Quad low = v[k] * body.p[k], high = v[k] * body.q[k];
    at_p += body.kind == Primitive::Kind::box ? std::max(low, high) : low;
    at_q += body.kind == Primitive::Kind::box ? std::max(low, high) : high;
  }
  for (Eigen::Index i = 0; hull && i < body.points.cols(); ++i) {
    const Quad here = v[0] * body.points(0, i) + v[1] * body.points(1, i) + v[2] * body.points(2, i);
    at_p = at_q = i == 0 ? here : std::max(at_p, here);
  }
  return height + std::max(at_p, at_q) + body.radius * elementary::sqrt(square);
}

/// Whether max u·x over the second body is below min u·x over the first, as SeparationResult::normal says.
inline bool is_between(const Primitive& first, const Primitive& second, const double* u) {
  return height_of(second, u, 1) < -height_of(first, u, -1);
}

/// Pairs with their sets and poses, as a batch takes them.
struct PrimitivePairs {
  void add(const Primitive& one, const Primitive& two) {
    first.push_back(one), second.push_back(two);
    sets.push_back(one.set()), sets.push_back(two.set());
    pairs.push_back({{*sets[sets.size() - 2], first.back().pose}, {*sets.back(), second.back().pose}});
  }
  std::size_t size() const { return pairs.size(); }

  std::deque<Primitive> first, second;
  std::vector<std::shared_ptr<const ConvexSet>> sets;
  std::vector<PosedPair> pairs;
};

}  // namespace raygauge
