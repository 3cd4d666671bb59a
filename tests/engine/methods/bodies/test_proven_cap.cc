// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/bodies/proven_cap.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "engine/methods/bodies/body_oracles.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::test_proven_cap {
namespace {

using Random = std::mt19937_64;

Vector3 direction(Random& random) {
  std::normal_distribution<double> normal;
  const Vector3 v{normal(random), normal(random), normal(random)};
  return v * (1 / length(v));
}

// Three points that stay in place.
class Corners final : public DepthOracle<double> {
 public:
  explicit Corners(const Vector3 (&s)[3]) {
    size_ = 8;
    for (int k = 0; k < 3; ++k) {
      corner_[k].s = corner_[k].a1 = s[k];
      corner_[k].index_1 = k;
      pointer_[k] = corner_ + k;
    }
  }
  double support(const Vector3& /*u*/, DepthPoint<double>& /*point*/) override { return 0; }
  double metric_upper(const Vector3& u) override { return length(u); }
  double metric_lower(const Vector3& u) override { return length(u); }

  bool find(const Vector3& n, ProvenCap& cap) { return cap.find(pointer_, n, 1e9, 1e-6, *this); }
  double height(const Vector3& u) const {
    return std::max({dot(u, corner_[0].s), dot(u, corner_[1].s), dot(u, corner_[2].s)});
  }
  const DepthPoint<double>* const* corners() const { return pointer_; }

 private:
  DepthPoint<double> corner_[3];
  const DepthPoint<double>* pointer_[3];
};

TEST(ProvenCap, no_direction_that_it_holds_is_lower_than_it_says) {
  Random random(1);
  int found = 0, held = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vector3 n = direction(random), e = any_orthogonal(n), f = cross(n, e);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const double height = std::exp2(4 * uniform(random));
    Vector3 s[3];
    for (int k = 0; k < 3; ++k) {
      const double angle = 2.1 * (k + 0.4 * uniform(random)), radius = 0.2 + std::fabs(uniform(random));
      s[k] = n * height + e * (radius * std::cos(angle)) + f * (radius * std::sin(angle));
    }
    Corners corners(s);
    ProvenCap cap;
    if (!corners.find(n, cap)) continue;
    ++found;
    EXPECT_NEAR(cap.height(), height, 1e-13 * height);
    for (int k = 0; k < 50; ++k) {
      const Vector3 u = cap.normal() + direction(random) * std::fabs(uniform(random));
      const Vector3 unit = u * (1 / length(u));
      if (!cap.holds(unit)) continue;
      ++held;
      EXPECT_GE(corners.height(unit), cap.height());
    }
  }
  EXPECT_GT(found, 1000);
  EXPECT_GT(held, 1000);
}

// A facet is covered only if all directions within acos(offset/height) of its normal are held.
TEST(ProvenCap, what_it_covers_it_holds) {
  const Vector3 s[3] = {{1, 0, 1}, {-0.5, 0.8, 1}, {-0.5, -0.8, 1}};
  Corners corners(s);
  ProvenCap cap;
  ASSERT_TRUE(corners.find({0, 0, 1}, cap));
  Random random(2);
  std::uniform_real_distribution<double> uniform(0, 1);
  int covered = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vector3 tilted = Vector3{0, 0, 1} + direction(random) * uniform(random);
    const Vector3 n_f = tilted * (1 / length(tilted));
    const double offset = cap.height() * uniform(random);
    if (!cap.covers(n_f, offset)) continue;
    ++covered;
    const double angle = std::acos(offset / cap.height());
    const Vector3 e = any_orthogonal(n_f), f = cross(n_f, e);
    for (int k = 0; k < 8; ++k) {
      const Vector3 across = e * std::cos(0.8 * k) + f * std::sin(0.8 * k);
      EXPECT_TRUE(cap.holds(n_f * std::cos(angle) + across * std::sin(angle)));
    }
  }
  EXPECT_GT(covered, 500);
}

TEST(ProvenCap, a_face_beside_the_foot_of_the_origin_proves_nothing) {
  const Vector3 beside[3] = {{1, 0, 1}, {2, 0, 1}, {1.5, 1, 1}},
                below[3] = {{1, 0, -1}, {-1, 1, -1}, {-1, -1, -1}};
  ProvenCap cap;
  EXPECT_FALSE(Corners(beside).find({0, 0, 1}, cap));
  EXPECT_FALSE(Corners(below).find({0, 0, 1}, cap));
}

TEST(ProvenCap, its_points_of_contact_are_where_the_normal_meets_the_face) {
  const Vector3 s[3] = {{1, 0, 2}, {-0.5, 0.8, 2}, {-0.5, -0.8, 2}};
  ProvenCap cap;
  ASSERT_TRUE(Corners(s).find({0, 0, 1}, cap));
  Vector3 a1, a2;
  ASSERT_TRUE(cap.contact({0, 0, 1}, 1e-6, a1, a2));
  EXPECT_NEAR(length(a1 - Vector3{0, 0, 2}), 0, 1e-14);
  EXPECT_FALSE(cap.contact({0.1, 0, 1}, 1e-6, a1, a2));
}

TEST(ProvenCap, of_four_corners_of_a_face_no_direction_is_lower_than_it_says) {
  Random random(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Vector3 none[3] = {};
  const Corners oracle(none);
  int found = 0;
  for (int i = 0; i < 500; ++i) {
    const Vector3 n = direction(random), e = any_orthogonal(n), f = e * 0.3 + cross(n, e);
    const Vector3 foot = n * std::exp2(4 * uniform(random)) + e * uniform(random) + f * uniform(random);
    DepthPoint<double> corner[4];
    for (int k = 0; k < 4; ++k) {
      corner[k].s = foot + e * (k == 0 || k == 3 ? 0.6 : -0.6) + f * (k < 2 ? 0.5 : -0.5);
      corner[k].a1 = corner[k].s;
    }
    ProvenCap cap;
    if (!cap.take_face(corner, n, oracle)) continue;
    ++found;
    Vector3 a1, a2;
    ASSERT_TRUE(cap.contact(n, 1e-6, a1, a2));
    EXPECT_NEAR(length(a1 - n * cap.height()), 0, 1e-12 * cap.height());
    for (int k = 0; k < 200; ++k) {
      const Vector3 u = n + direction(random) * uniform(random) * 2.0, unit = u * (1 / length(u));
      double height = 0;
      for (const DepthPoint<double>& each : corner) height = std::max(height, dot(unit, each.s));
      if (cap.holds(unit)) {
        EXPECT_GE(height, cap.height());
      }
    }
  }
  EXPECT_GT(found, 50);
}

// From corners that directions near the normal of the centres have; of a cone near one of its side.
TEST(ProvenCap, no_direction_about_a_bent_face_is_lower_than_it_says) {
  Random random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero(), axes(1, 0.6, 0.4), half(0.6, 0.5, 0.4), up(0, 0, 0.6);
  const Ellipsoid ellipsoid(zero, Eigen::MatrixXd(axes.asDiagonal()));
  const Cylinder cylinder(Eigen::Vector3d(-up), up, 0.5);
  const Capsule capsule(Eigen::Vector3d(-up), up, 0.3);
  const Box box(Eigen::Vector3d(-half), half);
  const ConvexSet* const others[] = {&ellipsoid, &cylinder, &capsule, &box};
  const TruncatedCone cone(Eigen::Vector3d(-up), 0.6, up, 0.0);
  int found = 0, of_cones = 0;
  for (int i = 0; i < 20000; ++i) {
    const bool is_cone = i % 8 >= 4;
    const Vector3 axis = direction(random), way = direction(random) * 0.3;
    const Eigen::Matrix3d R =
        Eigen::AngleAxisd(3 * uniform(random), Eigen::Vector3d(axis.x, axis.y, axis.z)).toRotationMatrix();
    const Pose pose(R, Eigen::Vector3d(way.x, way.y, way.z));
    SpatialPair pair;
    ASSERT_TRUE(pair.bind(is_cone ? static_cast<const ConvexSet&>(cone) : ellipsoid, *others[i % 4],
                          InstructionSet::automatic));
    ASSERT_TRUE(pair.place(PoseNumbers(), PoseNumbers(&pose)));
    SpatialOracle oracle(pair);
    const double turn = 3.2 * uniform(random), along = 0.4472, across = 0.8944;  // of the cone's side
    const Vector3 n =
        is_cone ? Vector3{across * std::cos(turn), across * std::sin(turn), along} : direction(random);
    DepthPoint<double> corner[3];
    const DepthPoint<double>* pointer[3] = {corner, corner + 1, corner + 2};
    for (DepthPoint<double>& each : corner) oracle.support(n + direction(random) * 0.05, each);
    ProvenCap cap;
    if (!share_a_bend(pointer, corner[0]) || !cap.find_bent(pointer, n, 1e9, 1e-6, oracle)) continue;
    ++found;
    of_cones += int{is_cone};
    DepthPoint<double> point;
    EXPECT_GE(oracle.support(cap.normal(), point), cap.height());
    Vector3 a1, a2;
    ASSERT_TRUE(cap.contact(cap.normal(), 1e-6, a1, a2));
    EXPECT_LT(length(a1 - a2 - cap.normal() * cap.height()), 1e-5);
    for (int k = 0; k < 200; ++k) {
      const Vector3 u = cap.normal() + direction(random) * (0.7 * uniform(random));
      const Vector3 unit = u * (1 / length(u));
      if (cap.holds(unit)) {
        EXPECT_GE(oracle.support(unit, point), cap.height());
      }
    }
  }
  EXPECT_GT(found, 100);
  EXPECT_GT(of_cones, 100);
}

TEST(ProvenCap, corners_share_a_face_if_they_are_on_three_pieces) {
  const Vector3 s[3] = {{1, 0, 1}, {-0.5, 0.8, 1}, {-0.5, -0.8, 1}};
  const Corners corners(s);
  DepthPoint<double> farthest = *corners.corners()[1];
  EXPECT_TRUE(share_a_face(corners.corners(), farthest));
  farthest.index_2 = 7;
  EXPECT_FALSE(share_a_face(corners.corners(), farthest));
  const DepthPoint<double>* twice[3] = {corners.corners()[0], corners.corners()[0], corners.corners()[1]};
  EXPECT_FALSE(share_a_face(twice, *twice[0]));
}

}  // namespace
}  // namespace raygauge::test_proven_cap
