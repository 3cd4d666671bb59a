// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Pairs of meshes that are hard, against a loop over all pairs of triangles: nested shells, thin plates,
// needles, coplanar faces, touching faces, edges and corners.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "raygauge/queries/mesh_distance.h"
#include "tests/mesh_truth.h"

namespace raygauge::test_mesh_pairs {
namespace {

using namespace testing;
using Eigen::Vector3d;

constexpr double kTolerance = 1e-6;

/// Between the boxes of half sides `inner` and `outer`; no inner box: all of the outer one.
struct Block {
  Vector3d outer, inner = kZero;
  MeshKind kind = MeshKind::surface;

  bool is_hollow() const { return inner.minCoeff() > 0; }

  MeshShape shape() const {
    const MeshShape out = box_shape(-outer, outer);
    return is_hollow() ? joined(out, box_shape(-inner, inner, 1, true)) : out;
  }

  /// Of a point that is not on the surface.
  bool holds(const Vector3d& x) const {
    if (kind != MeshKind::solid) return false;
    const auto within = [&](const Vector3d& half) { return (x.cwiseAbs() - half).maxCoeff() < 0; };
    return within(outer) && !(is_hollow() && within(inner));
  }
};

Block draw_block() {
  Block block;
  const auto half = [] { return 0.5 * *rc::gen::inRange(1, 7); };
  block.outer = Vector3d(half(), half(), half());
  block.kind = *rc::gen::element(MeshKind::surface, MeshKind::solid);
  const int form = *rc::gen::inRange(0, 4);
  if (form == 1) block.inner = block.outer - Vector3d::Constant(0.25);  // a shell
  const double thin = std::exp2(-*rc::gen::inRange(1, 31));
  if (form == 2) block.outer[2] = thin;                   // a plate
  if (form == 3) block.outer[0] = block.outer[1] = thin;  // a needle
  return block;
}

Eigen::Matrix3d draw_axes() {
  return right_turns(*rc::gen::inRange(0, 4), [] { return *rc::gen::inRange(0, 3); });
}

/// A turn about the axes, so that faces are coplanar and edges touch; or any turn.
Pose draw_pose() {
  const int far = *rc::gen::element(1, 3, 8);
  const auto place = [far] { return 0.5 * *rc::gen::inRange(-far, far + 1); };
  const Vector3d t(place(), place(), place());
  if (*rc::gen::inRange(0, 3) > 0) return {draw_axes(), t};
  const auto number = [] { return *rc::gen::inRange(-9, 10); };
  Eigen::Quaterniond q(number(), number(), number(), number());
  if (q.norm() == 0) q = Eigen::Quaterniond::Identity();
  return {q.normalized(), t};
}

// Whether the one is inside the other, for surfaces that do not meet: then one point of each part says it.
bool is_inside(const Block& one, const Pose& at_1, const Block& two, const Pose& at_2) {
  const Pose back = at_2.inverse();
  for (const Vector3d& corner : {one.outer, one.inner}) {
    if (corner.minCoeff() > 0 && two.holds(back.apply(at_1.apply(corner)))) return true;
  }
  return false;
}

// An edge lies in the plane of a triangle far from it, but for rounding: by doubles it went through that.
TEST(MeshDistance, OfBoxesWithAnEdgeInAPlaneOfTheOtherIsThatOfTheLoop) {
  const MeshShape one = box_shape(Vector3d(-1, -0.5, -0.5), Vector3d(1, 0.5, 0.5)),
                  two = box_shape(Vector3d(-1.5, -0.5, -1), Vector3d(1.5, 0.5, 1));
  const Pose at_1(Eigen::Quaterniond(-2, -6, -6, -6).normalized(), kZero),
      at_2(Eigen::Quaterniond::Identity(), Vector3d(-2.5, -1, -3));
  const BruteForce truth = brute_force(one, at_1, two, at_2);
  MeshDistanceSolver solver;
  const DistanceResult r = solver.solve({mesh_of(one), at_1}, {mesh_of(two), at_2}).distance;
  EXPECT_NEAR(truth.upper, 1.43747227125, 1e-10);
  EXPECT_LE(r.lower, truth.upper);
  EXPECT_GE(r.upper, truth.lower);
  EXPECT_EQ(rough_force(one, at_1, two, at_2).meet, false);
}

RC_GTEST_PROP(MeshDistance, OfHardPairsAgreesWithTheLoopOverAllTriangles, ()) {
  const Block first = draw_block(), second = draw_block();
  const Pose at_1 = draw_pose(), at_2 = draw_pose();
  const MeshShape shape_1 = first.shape(), shape_2 = second.shape();
  const Mesh one = mesh_of(shape_1, first.kind), two = mesh_of(shape_2, second.kind);
  const BruteForce truth = brute_force(shape_1, at_1, shape_2, at_2);
  const bool clear = truth.lower > 1e-9;
  const bool inside = clear && (is_inside(first, at_1, second, at_2) || is_inside(second, at_2, first, at_1));
  MeshDistanceSolver solver;
  const DistanceResult r = solver.solve({one, at_1}, {two, at_2}, ObjectEffects::closest_points).distance;
  const Separation apart = solver.separation({one, at_1}, {two, at_2});
  RC_CLASSIFY(truth.meet, "surfaces meet");
  RC_CLASSIFY(inside, "one inside");
  RC_CLASSIFY(!clear && !truth.meet, "touch");
  if (inside || truth.meet) {
    RC_ASSERT(r.lower == 0);
    RC_ASSERT(apart != Separation::separated);
  } else {
    RC_ASSERT(r.lower <= truth.upper);
    RC_ASSERT(r.upper >= truth.lower);
    RC_ASSERT(apart != Separation::intersecting || !(truth.lower > 0));
  }
  if (inside || (truth.meet && apart == Separation::intersecting))
    RC_ASSERT(r.status == DistanceStatus::contains_origin);
  if (clear && !inside) {
    RC_ASSERT(r.status == DistanceStatus::optimal);
    RC_ASSERT(r.upper - r.lower <= kTolerance * r.upper);
    RC_ASSERT(apart == Separation::separated);
  }
}

}  // namespace
}  // namespace raygauge::test_mesh_pairs
