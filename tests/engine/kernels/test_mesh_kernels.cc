// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Bounds of the distances of boxes and triangles in single precision, against distances in quadruple
// precision: never above them, and where bodies are well apart hardly below.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/kernels/kernel.h"
#include "engine/kernels/mesh_lanes.h"
#include "engine/meshes/box_tree.h"
#include "tests/engine/instruction_sets.h"
#include "tests/mesh_truth.h"

namespace raygauge::test_mesh_kernels {
namespace {

using namespace testing;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kLanes = BoxLanes::kCount;

class MeshKernelsOnEveryInstructionSet : public ::testing::TestWithParam<InstructionSet> {
 protected:
  const Kernels& kernels() const { return kernels_for(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(Machine, MeshKernelsOnEveryInstructionSet,
                         ::testing::ValuesIn(instruction_sets_here()),
                         [](const auto& instance) { return std::string(to_string(instance.param)); });

double number(std::mt19937_64& random) { return std::normal_distribution<double>()(random); }
int choice(std::mt19937_64& random, int count) {
  return std::uniform_int_distribution<int>(0, count - 1)(random);
}

Vector3d vector(std::mt19937_64& random) { return {number(random), number(random), number(random)}; }

// By right angles, so that faces and edges are parallel, nearly so, or any rotation.
Matrix3d rotation(std::mt19937_64& random) {
  const Matrix3d right = right_turns(choice(random, 4), [&] { return choice(random, 3); });
  const int kind = choice(random, 3);
  if (kind == 0) return right;
  const double angle = kind == 1 ? std::pow(10.0, -1 - choice(random, 9)) : 3 * number(random);
  return Eigen::AngleAxisd(angle, vector(random).normalized()).toRotationMatrix() * right;
}

struct Box {
  Vector3d center, half;
  Matrix3d axes;  ///< columns

  // Round, flat, thin and without any extent.
  static Box random(std::mt19937_64& random, double far) {
    Box box{far * vector(random), vector(random).cwiseAbs(), rotation(random)};
    for (int k = 0; k < 3; ++k) box.half[k] *= std::pow(10.0, -choice(random, 4));
    for (int k = choice(random, 4); k < 3; ++k) box.half[k] = 0;
    return box;
  }

  // In single precision, as it is seen by others: the numbers that a kernel is given.
  void round() {
    center = center.cast<float>().cast<double>();
    half = half.cast<float>().cast<double>();
    axes = axes.cast<float>().cast<double>();
  }
};

void set_lane(BoxLanes& lanes, int lane, const Box& box) {
  for (int k = 0; k < 3; ++k) {
    lanes.center[k][lane] = static_cast<float>(box.center[k]);
    lanes.half[k][lane] = static_cast<float>(box.half[k]);
    for (int i = 0; i < 3; ++i) lanes.axis[k][i][lane] = static_cast<float>(box.axes(i, k));
  }
}

PlacedBox placed(const Box& box, const Matrix3d& R, const Vector3d& t) {
  PlacedBox to;
  const Matrix3d turn = box.axes.transpose() * R;
  const Vector3d center = box.axes.transpose() * (t - box.center);
  for (int j = 0; j < 3; ++j) {
    for (int k = 0; k < 3; ++k) to.turn[j][k] = static_cast<float>(turn(j, k));
    to.center[j] = static_cast<float>(center[j]);
    to.half[j] = static_cast<float>(box.half[j]);
  }
  return to;
}

MeshShape shape_of(const Box& box) {
  MeshShape shape = box_shape(-box.half, box.half);
  shape.vertices = (box.axes * shape.vertices).colwise() + box.center;
  return shape;
}

// Of boxes and triangles as sets, so that one may be inside a box.
double distance(const Box& one, const MeshShape& two, const Pose& at_2) {
  const Vector3d p = one.axes.inverse() * (at_2.apply(Vector3d(two.vertices.col(0))) - one.center);
  if ((p.cwiseAbs() - one.half).maxCoeff() <= 0) return 0;
  return brute_force(shape_of(one), Pose(3), two, at_2).upper;
}

double distance(const Box& one, const Box& two, const Pose& at_2) {
  const Vector3d p = two.axes.inverse() * (at_2.inverse().apply(one.center) - two.center);
  if ((p.cwiseAbs() - two.half).maxCoeff() <= 0) return 0;
  return distance(one, shape_of(two), at_2);
}

TEST_P(MeshKernelsOnEveryInstructionSet, BoundsTheDistancesOfBoxes) {
  std::mt19937_64 random(5);
  int exact = 0;
  for (int round = 0; round < 150; ++round) {
    const double far = std::pow(10.0, choice(random, 4) - 2);
    Box single = Box::random(random, far), others[kLanes];
    single.round();
    const Pose pose(rotation(random), far * vector(random));
    BoxLanes lanes{};
    double size = single.center.norm() + pose.translation().norm(), largest = single.half.norm();
    for (int l = 0; l < kLanes; ++l) {
      others[l] = Box::random(random, far);
      others[l].round();
      set_lane(lanes, l, others[l]);
      largest = std::max(largest, others[l].center.norm() + others[l].half.norm());
    }
    size += largest;
    alignas(32) float lower[kLanes];
    const PlacedBox box = placed(single, pose.rotation(), pose.translation());
    const float beyond = static_cast<float>(far);
    const unsigned below = kernels().bound_boxes(&lanes, &box, beyond, lower);
    for (int l = 0; l < kLanes; ++l) {
      const double truth = distance(single, others[l], pose);
      ASSERT_LE(double{lower[l]}, truth + 0x1p-16 * size) << round << ' ' << l;
      ASSERT_EQ((below >> l & 1) != 0, lower[l] < beyond);
      exact += truth > 0.1 * size && double{lower[l]} > 0.999 * truth ? 1 : 0;
      EXPECT_TRUE(truth <= 0.1 * size || double{lower[l]} > 0.5 * truth) << round << ' ' << l;
    }
  }
  EXPECT_GT(exact, 200);
}

TEST_P(MeshKernelsOnEveryInstructionSet, SeesHowDeepBoxesOverlap) {
  BoxLanes lanes{};
  Box other{{0, 0, 0}, {1, 1, 1}, Matrix3d::Identity()};
  for (int l = 0; l < kLanes; ++l) {
    other.center = {0.25 * l, 0, 0};
    set_lane(lanes, l, other);
  }
  const PlacedBox box = placed({{0, 0, 0}, {1, 1, 1}, Matrix3d::Identity()}, Matrix3d::Identity(), {0, 0, 0});
  alignas(32) float lower[kLanes];
  EXPECT_EQ(kernels().bound_boxes(&lanes, &box, 0.0F, lower), 0xffU);
  for (int l = 0; l < kLanes; ++l) EXPECT_NEAR(lower[l], 0.25 * l - 2, 1e-4) << l;
}

/// Triangles that are round, slivers, segments and points.
MeshShape random_triangle(std::mt19937_64& random, double size) {
  MeshShape shape;
  shape.triangles = {{0, 1, 2}};
  shape.vertices.resize(3, 3);
  for (int c = 0; c < 3; ++c) shape.vertices.col(c) = size * vector(random);
  const int kind = choice(random, 6);
  if (kind < 3) return shape;
  const double thin = kind == 3 ? std::pow(10.0, -choice(random, 12)) : 0;
  const Vector3d a = shape.vertices.col(0), way = shape.vertices.col(1) - a;
  const Vector3d off = shape.vertices.col(2) - a;
  shape.vertices.col(2) = a + 0.5 * (kind == 5 ? 0 : 1) * way + thin * off;
  if (kind == 5) shape.vertices.col(1) = a;
  return shape;
}

TEST_P(MeshKernelsOnEveryInstructionSet, BoundsTheDistancesOfBoxesAndTriangles) {
  std::mt19937_64 random(7);
  int apart = 0, known = 0;
  for (int round = 0; round < 150; ++round) {
    const double far = std::pow(10.0, choice(random, 4) - 2);
    Box single = Box::random(random, far);
    single.round();
    const Pose pose(rotation(random), far * vector(random));
    TriangleBlock block{};
    MeshShape triangles[kLanes];
    double largest = 0;
    for (int l = 0; l < kLanes; ++l) {
      MeshShape& t = triangles[l] = random_triangle(random, std::pow(10.0, -choice(random, 3)));
      t.vertices = t.vertices.cast<float>().cast<double>();
      largest = std::max(largest, t.vertices.colwise().norm().maxCoeff());
      for (int c = 0; c < 3; ++c) {
        for (int k = 0; k < 3; ++k) block.corner[c][k][l] = static_cast<float>(t.vertices(k, c));
      }
    }
    const double size = single.center.norm() + pose.translation().norm() + single.half.norm() + largest;
    const PlacedBox box = placed(single, pose.rotation(), pose.translation());
    alignas(32) float lower[kLanes];
    for (const double share : {1e-4, 0.1, 0.5, 1.0}) {
      const auto beyond = static_cast<float>(share * size);
      const unsigned below = kernels().bound_block(&block, &box, beyond, lower);
      for (int l = 0; l < kLanes; ++l) {
        const double truth = distance(single, triangles[l], pose);
        ASSERT_LE(double{lower[l]}, truth + 0x1p-16 * size) << round << ' ' << l;
        const bool is_below = (below >> l & 1) != 0;
        ASSERT_TRUE(is_below || double{beyond} <= truth + 0x1p-16 * size) << round << ' ' << l;
        if (truth < 2 * double{beyond} + 0.01 * size) continue;
        ++apart;
        known += is_below ? 0 : 1;
      }
    }
  }
  EXPECT_GT(apart, 1000);
  EXPECT_GT(known, apart - apart / 50);
}

// A plane across the triangle alone is between it and the box.
TEST_P(MeshKernelsOnEveryInstructionSet, SeparatesATriangleFromABoxAcrossIt) {
  TriangleBlock block{};
  for (int l = 0; l < kLanes; ++l) {
    for (int c = 0; c < 3; ++c) {
      for (int k = 0; k < 3; ++k) block.corner[c][k][l] = c == k ? 3.3F + 0.1F * static_cast<float>(l) : 0;
    }
  }
  const PlacedBox box = placed({{0, 0, 0}, {1, 1, 1}, Matrix3d::Identity()}, Matrix3d::Identity(), {0, 0, 0});
  alignas(32) float lower[kLanes];
  EXPECT_EQ(kernels().bound_block(&block, &box, 0.1F, lower), 0U);
  EXPECT_EQ(kernels().bound_block(&block, &box, 0.4F, lower),
            0xfU);  // 0.3/√3 beyond it, and 0.1/√3 more each
}

/// Pairs of triangles for the lanes, and what their distances are.
struct Pairs {
  explicit Pairs(std::mt19937_64& random) : pose(rotation(random), vector(random)) {
    const Matrix3d R = pose.rotation();
    for (int k = 0; k < 3; ++k) {
      for (int i = 0; i < 3; ++i) lanes.turn[k][i] = static_cast<float>(R(k, i));
    }
    for (int l = 0; l < TriangleLanes::kCount; ++l) fill(random, l);
  }

  // Small and large ones, near and far, that touch, meet, or have a common corner.
  void fill(std::mt19937_64& random, int l) {
    one[l] = random_triangle(random, std::pow(10.0, -choice(random, 5)));
    two[l] = random_triangle(random, std::pow(10.0, -choice(random, 5)));
    offset[l] = std::pow(10.0, 1 - choice(random, 8)) * vector(random);
    if (choice(random, 3) == 0)  // corner 0 of both in the same place, or nearly
      offset[l] = one[l].vertices.col(0) - pose.rotation() * two[l].vertices.col(0) +
                  std::pow(10.0, -choice(random, 10)) * vector(random);
    double size = offset[l].norm();
    for (int c = 0; c < 3; ++c) {
      size = std::max({size, one[l].vertices.col(c).norm(), two[l].vertices.col(c).norm()});
      for (int k = 0; k < 3; ++k) {
        lanes.one[c][k][l] = static_cast<float>(one[l].vertices(k, c));
        lanes.two[c][k][l] = static_cast<float>(two[l].vertices(k, c));
      }
    }
    for (int k = 0; k < 3; ++k) lanes.offset[k][l] = static_cast<float>(offset[l][k]);
    lanes.size[l] = std::nextafter(static_cast<float>(size), 1e30F);
  }

  double distance(int l) const {
    return brute_force(one[l], Pose(3), two[l], Pose(pose.rotation(), offset[l])).upper;
  }

  Pose pose;
  MeshShape one[TriangleLanes::kCount], two[TriangleLanes::kCount];
  Vector3d offset[TriangleLanes::kCount];
  TriangleLanes lanes{};
};

TEST_P(MeshKernelsOnEveryInstructionSet, BoundsTheDistancesOfTriangles) {
  std::mt19937_64 random(11);
  int apart = 0, exact = 0;
  for (int round = 0; round < 400; ++round) {
    Pairs pairs(random);
    kernels().bound_triangles(&pairs.lanes, TriangleLanes::kCount);
    for (int l = 0; l < TriangleLanes::kCount; ++l) {
      const double truth = pairs.distance(l), lower = double{pairs.lanes.lower[l]};
      ASSERT_LE(lower, truth) << round << ' ' << l;
      if (truth < 0.01 * double{pairs.lanes.size[l]}) continue;
      ++apart;
      exact += lower > 0.998 * truth ? 1 : 0;
      const float *x = pairs.lanes.way[0], *y = pairs.lanes.way[1], *z = pairs.lanes.way[2];
      EXPECT_NEAR(std::hypot(x[l], y[l], z[l]), 1, 1e-6);
    }
  }
  EXPECT_GT(apart, 2000);
  EXPECT_GT(exact, apart - apart / 200);
}

// One lane alone needs no other one; the last lanes are looked at when they are asked for.
TEST_P(MeshKernelsOnEveryInstructionSet, LooksAtTheFirstLanesOnly) {
  std::mt19937_64 random(13);
  Pairs all(random);
  TriangleLanes few = all.lanes;
  kernels().bound_triangles(&all.lanes, TriangleLanes::kCount);
  kernels().bound_triangles(&few, 5);
  for (int l = 0; l < 5; ++l) EXPECT_EQ(few.lower[l], all.lanes.lower[l]) << l;
}

}  // namespace
}  // namespace raygauge::test_mesh_kernels
