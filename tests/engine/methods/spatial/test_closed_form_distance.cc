// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/closed_form_distance.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <vector>

#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::test_closed_form_distance {
namespace {

using Eigen::Vector3d;
using SetPointer = std::shared_ptr<const ConvexSet>;

class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Vector3d vector(double length) {
    return {uniform(-length, length), uniform(-length, length), uniform(-length, length)};
  }

 private:
  std::mt19937_64 engine_;
};

/// One set of each kind with a formula; needles and plates among them.
std::vector<SetPointer> draw_sets(Draw& draw) {
  const Vector3d p = draw.vector(2), q = p + draw.vector(std::pow(10.0, draw.uniform(-3, 1)));
  const double one = std::pow(10.0, draw.uniform(-3, 0.5)), other = std::pow(10.0, draw.uniform(-3, 0.5));
  const Vector3d half = draw.vector(1).cwiseAbs();
  return {std::make_shared<Box>(p - half, p + half), std::make_shared<Cylinder>(p, q, one),
          std::make_shared<TruncatedCone>(p, one, q, other), std::make_shared<TruncatedCone>(p, one, q, 0.0)};
}

Vector3 spatial(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }
Vector3d dense(const Vector3& v) { return {v.x, v.y, v.z}; }

template <class Vector>
Vector nearest_in(const SpatialShape& shape, const Vector& y) {
  return with_core(shape, [&y](const auto& core) {
    if constexpr (requires { core.nearest(y); }) return core.nearest(y);
    return y;
  });
}

// q is nearest to p in S if and only if it is in S and h_S(p - q) = (p - q)·q.
TEST(NearestInCore, IsInTheSetAndItsTangentPlaneHoldsTheSetOff) {
  Draw draw(5);
  for (int trial = 0; trial < 2000; ++trial) {
    for (const SetPointer& S : draw_sets(draw)) {
      const SpatialShape& shape = *S->spatial_shape();
      const Vector3d p = draw.vector(trial % 2 == 0 ? 3 : 20);
      const Vector3d q = dense(nearest_in(shape, spatial(p))), u = p - q;
      const PreciseVector3 precisely = nearest_in(shape, precise(spatial(p)));
      EXPECT_NEAR((dense(rounded(precisely)) - q).norm(), 0, 1e-13);
      Vector3d point;
      EXPECT_LE(S->support_unchecked(u.data(), point.data()), u.dot(q) + 1e-12 * u.norm() + 1e-14);
      for (int k = 0; k < 20; ++k) {
        const Vector3d v = draw.vector(1);
        EXPECT_GE(S->support_unchecked(v.data(), point.data()), v.dot(q) - 1e-13);
      }
    }
  }
}

TEST(NearestInCore, OfAPointInsideIsThatPoint) {
  const Cylinder cylinder(Vector3d(0, 0, -1), Vector3d(0, 0, 1), 1);
  const SpatialShape& shape = *cylinder.spatial_shape();
  EXPECT_NEAR((dense(nearest_in(shape, Vector3{0.3, -0.4, 0.5})) - Vector3d(0.3, -0.4, 0.5)).norm(), 0,
              1e-15);
}

TEST(ClosedFormDistance, OfTwoCapsulesIsThatOfTheirSegments) {
  Draw draw(6);
  int closed = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Vector3d p = draw.vector(2), d = draw.vector(1), r = draw.vector(2);
    const Vector3d e = trial % 4 == 0 ? Vector3d(d * 0.7) : draw.vector(1);  // parallel ones too
    const Capsule A(p, p + d, 0.01), B(r, r + e, 0.02);
    SpatialPair pair;
    ASSERT_TRUE(pair.bind(A, B, InstructionSet::automatic) && pair.place({}, {}));
    SpatialAnswer answer;
    if (!closed_form_distance(pair, 1e-9, answer) || answer.end != SpatialEnd::closed) continue;
    ++closed;
    for (int k = 0; k < 50; ++k) {
      const double apart = (p + d * draw.uniform(0, 1) - r - e * draw.uniform(0, 1)).norm() - 0.03;
      EXPECT_LE(answer.bounds.lower(), apart + 1e-14);
    }
  }
  EXPECT_GT(closed, 1900);
}

TEST(ClosedFormDistance, IsLeftToOthersWhereThereIsNoFormulaOrTheCoresOverlap) {
  const Box box(Vector3d(-1, -1, -1), Vector3d(1, 1, 1));
  const Ball inside(Vector3d(0.5, 0, 0), 0.1), far(Vector3d(5, 0, 0), 0.1);
  const Ellipsoid ellipsoid(Vector3d::Zero(), Eigen::Matrix3d::Identity());
  SpatialPair pair;
  SpatialAnswer answer;
  ASSERT_TRUE(pair.bind(box, inside, InstructionSet::automatic) && pair.place({}, {}));
  EXPECT_FALSE(closed_form_distance(pair, 1e-6, answer));
  ASSERT_TRUE(pair.bind(ellipsoid, far, InstructionSet::automatic) && pair.place({}, {}));
  EXPECT_FALSE(closed_form_distance(pair, 1e-6, answer));
  ASSERT_TRUE(pair.bind(box, far, InstructionSet::automatic) && pair.place({}, {}));
  ASSERT_TRUE(closed_form_distance(pair, 1e-6, answer));
  EXPECT_LE(answer.bounds.lower(), 3.9);
  EXPECT_GE(answer.bounds.upper(), 3.9);
  EXPECT_LE(answer.bounds.gap(), 1e-12);
}

}  // namespace
}  // namespace raygauge::test_closed_form_distance
