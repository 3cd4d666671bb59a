// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Edges of robots among meshes and clouds, and of robots whose links are meshes.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "raygauge/meshes/mesh.h"
#include "raygauge/scene/edge_checker.h"
#include "tests/engine/meshes/mesh_shapes.h"
#include "tests/scene/planning/random_robots.h"

namespace raygauge::test_edge_meshes {
namespace {

using namespace random_robots;
using testing::box_shape;
using testing::MeshShape;
using testing::torus_shape;
using Values = std::vector<double>;

SetPointer object(const MeshShape& shape, MeshKind kind) {
  return std::make_shared<MeshObject>(Mesh(shape.vertices, shape.triangles, kind));
}

Body standing(const SetPointer& set, const Placement& where = Placement::identity(3)) {
  return make_body("obstacle", {set}, std::make_shared<StaticMotion>(where));
}

/// One body on a joint about z or along x.
RobotModel one_joint(JointKind kind, const SetPointer& set) {
  RobotModel robot;
  robot.joints = 1;
  TreeLink link;
  link.origin = Placement::identity(3);
  link.kind = kind;
  link.axis = kind == JointKind::revolute ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX();
  link.joint = 0;
  robot.tree.links.push_back(link);
  RobotBody body;
  body.name = "body";
  body.parts = {set};
  robot.bodies.push_back(body);
  return robot;
}

SetPointer ball_of(double radius) { return std::make_shared<Ball>(Vector::Zero(3), radius); }

/// Balls of one radius about the points of a ring.
SetPointer ring(double R, double radius, int count) {
  Eigen::Matrix3Xd points(3, count);
  for (int k = 0; k < count; ++k) {
    const double s = 2 * std::numbers::pi * k / count;
    points.col(k) << 0, R * std::cos(s), R * std::sin(s);
  }
  return std::make_shared<MeshObject>(Mesh::cloud(points, radius));
}

// A ball along the axis of a torus that stands upright, whose hull it meets.
TEST(EdgeMeshes, ABodyPassesThroughAHole) {
  const MeshShape torus = torus_shape(2, 0.5, 90, 40);
  MeshShape upright = torus;
  upright.vertices.row(0) = torus.vertices.row(2);
  upright.vertices.row(2) = -torus.vertices.row(0);
  for (const double radius : {0.5, 1.4, 1.49}) {
    const RobotModel robot = one_joint(JointKind::prismatic, ball_of(radius));
    for (const MeshKind kind : {MeshKind::surface, MeshKind::solid}) {
      EdgeChecker checker(robot, {standing(object(upright, kind))});
      EXPECT_EQ(checker.edge(Values{-3}, Values{2}).outcome, EdgeOutcome::free) << radius;
      EXPECT_LT(checker.edge(Values{-3}, Values{2}).looks, 60) << radius;
    }
    EdgeChecker hull(robot, {standing(std::make_shared<PointSet>(upright.vertices))});
    EXPECT_EQ(hull.edge(Values{-3}, Values{2}).outcome, EdgeOutcome::contact);
    EdgeChecker cloud(robot, {standing(ring(2, 0.5, 100))});
    EXPECT_EQ(cloud.edge(Values{-3}, Values{2}).outcome, EdgeOutcome::free) << radius;
    EdgeOptions wide;
    wide.margin = 1.6 - radius;  // the hole is 1.5 wide
    EdgeChecker narrow(robot, {standing(object(upright, MeshKind::surface))}, wide);
    const EdgeResult& close = narrow.edge(Values{-3}, Values{2});
    ASSERT_EQ(close.outcome, EdgeOutcome::contact);
    EXPECT_LE(close.upper, wide.margin + wide.contact);
    EXPECT_NEAR(-3 + 5 * close.time, 0, 0.6);
  }
}

// A rod that turns towards a ball of a cloud meets it at the angle of the closed form.
TEST(EdgeMeshes, ARodMeetsACloudAtTheAngleOfTheClosedForm) {
  const double R = 0.9, angle = std::numbers::pi / 3, rod = 0.05, ball = 0.1;
  const auto capsule = std::make_shared<Capsule>(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0), rod);
  Eigen::Matrix3Xd points(3, 2);
  points << R * std::cos(angle), 0, R * std::sin(angle), 5, 0, 0;
  const Body cloud = standing(std::make_shared<MeshObject>(Mesh::cloud(points, ball)));
  for (const double margin : {0.0, 0.01, 0.2}) {
    EdgeOptions options;
    options.margin = margin;
    EdgeChecker checker(one_joint(JointKind::revolute, capsule), {cloud}, options);
    const double reached = angle - std::asin((rod + ball + margin) / R);
    EXPECT_EQ(checker.edge(Values{-1}, Values{reached - 3e-6}).outcome, EdgeOutcome::free);
    const EdgeResult& past = checker.edge(Values{-1}, Values{reached + 1e-5});
    ASSERT_EQ(past.outcome, EdgeOutcome::contact);
    EXPECT_GE(-1 + past.time * (reached + 1e-5 + 1), reached - 2e-6);
    EXPECT_EQ(checker.edge(Values{0}, Values{std::numbers::pi}).outcome, EdgeOutcome::contact);  // through it
  }
}

// A plate without thickness in the way, between any two samples of a planner.
TEST(EdgeMeshes, AThinPlateIsNotOverlooked) {
  MeshShape plate;
  plate.vertices.resize(3, 4);
  plate.vertices << 0, 0, 0, 0, -1, 1, 1, -1, -1, -1, 1, 1;
  plate.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Body wall = standing(object(plate, MeshKind::surface));
  for (const bool body_is_mesh : {false, true}) {
    const SetPointer small =
        body_is_mesh ? object(box_shape(-1e-3 * testing::kOne, 1e-3 * testing::kOne), MeshKind::solid)
                     : ball_of(1e-3);
    EdgeChecker checker(one_joint(JointKind::prismatic, small), {wall});
    const EdgeResult& result = checker.edge(Values{-1.1}, Values{17});
    ASSERT_EQ(result.outcome, EdgeOutcome::contact);
    EXPECT_NEAR(-1.1 + 18.1 * result.time, 0, 2e-3);
    EXPECT_EQ(checker.edge(Values{-2}, Values{-2e-3}).outcome, EdgeOutcome::free);
    EXPECT_EQ(checker.edge(Values{2e-3}, Values{2}).outcome, EdgeOutcome::free);
    EXPECT_EQ(checker.configuration(Values{-2e-3}).outcome, EdgeOutcome::free);
    EXPECT_EQ(checker.configuration(Values{0}).outcome, EdgeOutcome::contact);
  }
}

// Surfaces that stay apart: inside a solid all the time, or inside the cavity of one.
TEST(EdgeMeshes, ABodyInsideASolidIsInContact) {
  const MeshShape outer = box_shape(-3 * testing::kOne, 3 * testing::kOne, 2);
  const MeshShape hollow = joined(outer, box_shape(-2 * testing::kOne, 2 * testing::kOne, 2, true));
  const auto verdict = [](const SetPointer& moving, const SetPointer& around) {
    return EdgeChecker(one_joint(JointKind::prismatic, moving), {standing(around)})
        .edge(Values{-0.5}, Values{0.5})
        .outcome;
  };
  const SetPointer body = object(box_shape(-testing::kOne, testing::kOne), MeshKind::solid);
  for (const SetPointer& moving : {ball_of(1), body}) {
    EXPECT_EQ(verdict(moving, object(outer, MeshKind::solid)), EdgeOutcome::contact);
    EXPECT_EQ(verdict(moving, object(outer, MeshKind::surface)), EdgeOutcome::free);
    EXPECT_EQ(verdict(moving, object(hollow, MeshKind::solid)), EdgeOutcome::free);
  }
  EXPECT_EQ(verdict(body, ball_of(0.2)), EdgeOutcome::contact);
}

TEST(EdgeMeshes, WitnessesAreThoseOfTheNearestPieces) {
  EdgeOptions options;
  options.witness = true;
  options.margin = 0.3;
  const Body wall = standing(object(box_shape({1, -1, -1}, {2, 1, 1}, 3), MeshKind::solid));
  const RobotModel robot = one_joint(JointKind::prismatic, ball_of(0.5));
  const EdgeResult near = EdgeChecker(robot, {wall}, options).configuration(Values{0.25});
  ASSERT_EQ(near.outcome, EdgeOutcome::contact);
  EXPECT_LE((near.point_a - Eigen::Vector3d(0.75, 0, 0)).norm(), 1e-3);
  EXPECT_LE((near.point_b - Eigen::Vector3d(1, 0, 0)).norm(), 1e-3);
  EXPECT_EQ(near.depth, 0);
  const EdgeResult inside = EdgeChecker(robot, {wall}, options).configuration(Values{0.7});
  ASSERT_EQ(inside.outcome, EdgeOutcome::contact);
  ASSERT_EQ(inside.point_a.size(), 3);
  EXPECT_NEAR(inside.point_b[0], 1, 0.5);
  EXPECT_TRUE(std::isnan(inside.depth));  // of a mesh it is not known
}

/// A mesh, and convex sets whose union it is.
struct Pieces {
  SetPointer mesh;
  std::vector<SetPointer> sets;
};

Pieces surface(const MeshShape& shape) {
  Pieces pieces{object(shape, MeshKind::surface), {}};
  for (const MeshTriangle& t : shape.triangles) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) corners.col(k) = shape.vertices.col(t[static_cast<std::size_t>(k)]);
    pieces.sets.push_back(std::make_shared<PointSet>(corners));
  }
  return pieces;
}

Pieces random_pieces(Random& random, double size) {
  const auto point = [&] { return Eigen::Vector3d(uniform_vector(random, 3, size)); };
  switch (random() % 4) {
    case 0: {  // triangles anywhere
      MeshShape soup;
      const auto count = static_cast<std::int32_t>(1 + random() % 8);
      soup.vertices.resize(3, 3 * Eigen::Index{count});
      for (Eigen::Index i = 0; i < soup.vertices.cols(); ++i) soup.vertices.col(i) = point();
      for (std::int32_t i = 0; i < count; ++i) soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
      return surface(soup);
    }
    case 1:
      return surface(torus_shape(size, size * uniform(random, 0.05, 0.4), 5, 3));
    case 2: {  // boxes beside each other
      const Eigen::Vector3d one = Eigen::Vector3d::Constant(size), way(2.5 * size, 0, 0);
      const MeshShape a = box_shape(-one, one), b = box_shape(way - one, way + 0.5 * one);
      return {object(joined(a, b), MeshKind::solid),
              {std::make_shared<Box>(-one, one), std::make_shared<Box>(way - one, way + 0.5 * one)}};
    }
    default: {
      Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(1 + random() % 20));
      for (Eigen::Index i = 0; i < points.cols(); ++i) points.col(i) = point();
      const double radius = uniform(random, 0, 0.3 * size);
      Pieces pieces{std::make_shared<MeshObject>(Mesh::cloud(points, radius)), {}};
      for (Eigen::Index i = 0; i < points.cols(); ++i)
        pieces.sets.push_back(std::make_shared<Ball>(Vector(points.col(i)), radius));
      return pieces;
    }
  }
}

/// The same robot and obstacles twice: with meshes, and with their pieces.
struct Twins {
  RobotModel robot, robot_of_pieces;
  std::vector<Body> obstacles, obstacles_of_pieces;
};

Twins twins(Random& random) {
  Twins two;
  two.robot = two.robot_of_pieces = robot(random);
  for (std::size_t i = 0; i < two.robot.bodies.size(); ++i) {
    if (random() % 3 != 0) continue;
    const Pieces pieces = random_pieces(random, 0.3);
    two.robot.bodies[i].parts = {pieces.mesh};
    two.robot_of_pieces.bodies[i].parts = pieces.sets;
  }
  const auto count = 1 + random() % 2;
  for (std::size_t i = 0; i < count; ++i) {
    const Pieces pieces = random_pieces(random, 1);
    const MotionPointer moved = motion(random, 3, uniform(random, 2, 14));
    two.obstacles.push_back(make_body("obstacle", {pieces.mesh}, moved));
    two.obstacles_of_pieces.push_back(make_body("obstacle", pieces.sets, moved));
  }
  return two;
}

// The verdict beside distances of all pairs of pieces, solved one by one at many times.
void compare(const Twins& two, const JointTrajectory& trajectory, const EdgeOptions& options,
             const EdgeResult& result) {
  const std::vector<Body> bodies = moving_bodies(two.robot_of_pieces, two.obstacles_of_pieces, trajectory);
  constexpr double kRounding = 1e-9;
  if (result.outcome == EdgeOutcome::contact) {
    const BruteForce truth = brute_force(bodies[static_cast<std::size_t>(result.body_a)],
                                         bodies[static_cast<std::size_t>(result.body_b)], result.time);
    RC_ASSERT(truth.lower <= options.margin + options.contact + kRounding);
    RC_ASSERT(!is_ignored(two.robot, result.body_a, result.body_b));
    return;
  }
  constexpr int kTimes = 4;
  for (int a = 0; a < static_cast<int>(two.robot.bodies.size()); ++a) {
    for (int b = a + 1; b < static_cast<int>(bodies.size()); ++b) {
      if (is_ignored(two.robot, a, b)) continue;
      for (int k = 0; k <= kTimes; ++k) {
        const BruteForce truth =
            brute_force(bodies[static_cast<std::size_t>(a)], bodies[static_cast<std::size_t>(b)],
                        static_cast<double>(k) / kTimes, nullptr, 1e-6);
        RC_ASSERT(!truth.intersecting);
        RC_ASSERT(truth.upper >= options.margin - kRounding);
      }
    }
  }
}

RC_GTEST_PROP(EdgeMeshes, NoVerdictIsFalse, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const Twins two = twins(random);
  EdgeOptions options;
  if (random() % 2 == 0) options.margin = uniform(random, 0, 0.2);
  EdgeChecker checker(two.robot, two.obstacles, options);
  EdgeChecker pieces(two.robot_of_pieces, two.obstacles_of_pieces, options);
  Values q = configuration(random, two.robot, 2);
  for (int k = 0; k < 2; ++k) {
    Values next = configuration(random, two.robot, 2);
    for (std::size_t i = 0; i < q.size(); ++i) next[i] = q[i] + uniform(random, 0, 0.5) * next[i];
    const EdgeResult result = checker.edge(q, next);
    RC_ASSERT(result.outcome != EdgeOutcome::undecided);
    RC_TAG(result.outcome == EdgeOutcome::free ? "free" : "contact");
    RC_ASSERT(pieces.edge(q, next).outcome == result.outcome);
    compare(two, line(q, next), options, result);
    if (result.outcome == EdgeOutcome::free) {
      RC_ASSERT(checker.configuration(q, 0).outcome == EdgeOutcome::free);
      RC_ASSERT(checker.configuration(next, 1).outcome == EdgeOutcome::free);
    }
    q = next;
  }
}

}  // namespace
}  // namespace raygauge::test_edge_meshes
