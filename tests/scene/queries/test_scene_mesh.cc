// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Meshes as they are, as bodies of scenes.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "raygauge/exceptions.h"
#include "raygauge/meshes/mesh.h"
#include "raygauge/queries/mesh_distance.h"
#include "raygauge/sets/half_space.h"
#include "tests/engine/meshes/mesh_shapes.h"
#include "tests/scene/random_scenes.h"

namespace raygauge::test_scene_mesh {
namespace {

using namespace random_scenes;
using testing::box_shape;
using testing::MeshShape;
using testing::torus_shape;

SetPointer object(const MeshShape& shape, MeshKind kind = MeshKind::surface) {
  return std::make_shared<MeshObject>(Mesh(shape.vertices, shape.triangles, kind));
}

Body standing(const SetPointer& set, const Vector& where = Vector::Zero(3), const char* name = "mesh") {
  Placement at = Placement::identity(3);
  at.t = where;
  return make_body(name, {set}, std::make_shared<StaticMotion>(at));
}

MotionPointer flight(const Vector& from, const Vector& velocity, const Eigen::Vector3d& spin = {0, 0, 0}) {
  Placement start = Placement::identity(3);
  start.t = from;
  TwistMotion::Rates rates;
  rates.velocity = velocity;
  rates.acceleration = Vector::Zero(3);
  rates.spin = spin;
  return std::make_shared<TwistMotion>(start, rates, 0.0);
}

Body ball(double radius, const Vector& from, const Vector& velocity,
          const Eigen::Vector3d& spin = {0, 0, 0}) {
  return make_body("ball", {std::make_shared<Ball>(Vector::Zero(3), radius)}, flight(from, velocity, spin));
}

Scene scene_of(std::vector<Body> bodies, SceneEffects effects, double to, int instants = 5) {
  Scene scene;
  scene.bodies = std::move(bodies);
  for (int k = 0; k < instants; ++k) scene.instants.push_back(to * k / (instants - 1));
  scene.queries = {all_pairs(scene, effects)};
  return scene;
}

constexpr SceneEffects kContinuous = SceneEffects::time_of_impact | SceneEffects::clearance;

// A ball falls through the hole of a torus, whose hull it meets.
TEST(SceneMesh, LetsABodyThroughAHoleThatItsHullCloses) {
  const MeshShape torus = torus_shape(2, 0.5, 120, 60);
  const auto ask = [](const SetPointer& set) {
    return run(scene_of({standing(set), ball(0.5, Eigen::Vector3d(0.1, 0, 3), Eigen::Vector3d(0, 0, -3))},
                        kContinuous | SceneEffects::distance, 2))
        .records;
  };
  for (const SceneRecord& row : ask(object(torus, MeshKind::solid))) {
    if (row.kind == SceneEffects::time_of_impact) {
      EXPECT_EQ(row.status, SceneStatus::free);
    } else if (row.kind == SceneEffects::clearance) {
      EXPECT_EQ(row.status, SceneStatus::separated);
      EXPECT_NEAR(row.distance, 0.9, 5e-3);  // 2 - 0.5 - 0.1 - 0.5
      EXPECT_LE(row.upper - row.lower, 1e-3 * row.upper);
      EXPECT_NEAR(row.time, 1, 1e-2);
    } else {
      EXPECT_NEAR(row.distance, std::hypot(1.9, 3 - 3 * row.time) - 1, 5e-3);
    }
  }
  for (const SceneRecord& row : ask(std::make_shared<PointSet>(torus.vertices)))
    EXPECT_TRUE(row.kind != SceneEffects::time_of_impact || row.status == SceneStatus::contact);
}

// However thin the plate and fast the ball, the contact is where the closed form says.
TEST(SceneMesh, OfAThinPlateNeverOverlooksAContact) {
  for (const double half : {0.1, 1e-6, 1e-12}) {
    const SetPointer plate = object(box_shape({-2, -2, -half}, {2, 2, half}, 3), MeshKind::solid);
    for (const double speed : {1.0, 1e3, 1e5}) {
      const Scene scene =
          scene_of({standing(plate), ball(0.25, Eigen::Vector3d(0.3, 0.2, 5), Eigen::Vector3d(0, 0, -speed))},
                   kContinuous, 10 / speed);
      for (const SceneRecord& row : run(scene).records) {
        const double when = (4.75 - half) / speed;
        if (row.kind == SceneEffects::time_of_impact) {
          EXPECT_EQ(row.status, SceneStatus::contact);
          EXPECT_LE(row.time_lower, when * (1 + 1e-12));
          EXPECT_GE(row.time_upper, when - 2e-6 / speed);
          EXPECT_LE(row.time_upper - row.time_lower, 1e-6);
        } else {
          EXPECT_EQ(row.status, SceneStatus::intersecting);
          EXPECT_NEAR(row.time, when, 1e-5 / speed);
        }
      }
    }
  }
}

// A sheet of two triangles has no inside: an instant may miss it, a motion does not.
TEST(SceneMesh, OfASheetIsMetBetweenInstants) {
  MeshShape sheet;
  sheet.vertices.resize(3, 4);
  sheet.vertices << -1, 1, 1, -1, -1, -1, 1, 1, 0, 0, 0, 0;
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Scene scene = scene_of(
      {standing(object(sheet)), make_body("chip", {object(box_shape({-0.1, -0.1, -1e-9}, {0.1, 0.1, 0}))},
                                          flight(Eigen::Vector3d(0.2, 0.1, 1), Eigen::Vector3d(0, 0, -3)))},
      SceneEffects::time_of_impact | SceneEffects::separated, 1);
  for (const SceneRecord& row : run(scene).records) {
    if (row.kind != SceneEffects::time_of_impact) continue;
    EXPECT_EQ(row.status, SceneStatus::contact);
    EXPECT_NEAR(row.time_upper, 1.0 / 3, 1e-6);
    EXPECT_LE(row.time_lower, 1.0 / 3);
  }
}

TEST(SceneMesh, OnRandomWaysAgreesWithManyLooks) {
  Random random(77);
  const MeshShape torus = torus_shape(1, 0.3, 24, 12),
                  box = box_shape({-0.5, -0.4, -0.05}, {0.5, 0.4, 0.05}, 2);
  const Mesh one(torus.vertices, torus.triangles, MeshKind::solid), two(box.vertices, box.triangles);
  int contacts = 0, ways_free = 0;
  MeshDistanceSolver solver;
  const auto look = [&](const Scene& scene, double t) {
    const Placement a = scene.bodies[0].motion->at(t), b = scene.bodies[1].motion->at(t);
    const Pose at_a(a.R, a.t), at_b(b.R, b.t);
    return solver.solve({one, at_a}, {two, at_b}).distance;
  };
  for (int trial = 0; trial < 60; ++trial) {
    const Scene scene =
        scene_of({make_body("torus", {object(torus, MeshKind::solid)}, motion(random, 3, 1.5)),
                  make_body("plate", {object(box)}, motion(random, 3, 1.5))},
                 kContinuous, 1, 2);
    for (const SceneRecord& row : run(scene).records) {
      if (row.kind == SceneEffects::time_of_impact) {
        ASSERT_NE(row.status, SceneStatus::undecided);
        const bool contact = row.status == SceneStatus::contact;
        contacts += contact;
        ways_free += !contact;
        EXPECT_TRUE(!contact || look(scene, row.time_upper).lower <= 1e-6);
        for (int k = 0; k < 64 && !(contact && row.time_lower == 0); ++k)
          EXPECT_GT(look(scene, (contact ? row.time_lower : 1) * k / 64.0).upper, 0);
      } else if (row.status == SceneStatus::separated) {
        double least = std::numeric_limits<double>::infinity();
        for (int k = 0; k <= 128; ++k) least = std::min(least, look(scene, k / 128.0).upper);
        EXPECT_LE(row.lower, least);
        EXPECT_LE(row.upper - row.lower, 1.1e-3 * row.upper);
      } else {
        EXPECT_EQ(row.status, SceneStatus::intersecting);
        EXPECT_EQ(look(scene, row.time).lower, 0);
      }
    }
  }
  EXPECT_GT(contacts, 10);
  EXPECT_GT(ways_free, 10);
}

// A half-space is as far from a mesh as from its hull.
TEST(SceneMesh, FallsOnAHalfSpaceWhenItsHullDoes) {
  const MeshShape torus = torus_shape(1, 0.3, 30, 16);
  std::vector<SceneRecord> rows[2];
  for (int hull = 0; hull < 2; ++hull) {
    const SetPointer set = hull == 1 ? std::make_shared<PointSet>(torus.vertices) : object(torus);
    Scene scene = scene_of(
        {standing(std::make_shared<HalfSpace>(Eigen::Vector3d(0, 0, 1), 0.0)),
         make_body("torus", {set},
                   flight(Eigen::Vector3d(0, 0, 4), Eigen::Vector3d(1, 0, -3), Eigen::Vector3d(2, 3, 1)))},
        kContinuous | SceneEffects::closest_points, 2);
    rows[hull] = run(scene).records;
  }
  ASSERT_EQ(rows[0].size(), rows[1].size());
  for (std::size_t i = 0; i < rows[0].size(); ++i) {
    const SceneRecord &x = rows[0][i], &y = rows[1][i];
    ASSERT_EQ(x.kind, y.kind);
    EXPECT_EQ(x.status, y.status);
    if (x.kind == SceneEffects::time_of_impact) {
      EXPECT_NEAR(x.time_upper, y.time_upper, 1e-5);
      EXPECT_LE(x.time_lower, y.time_upper);
    } else if (x.lower > 0) {
      EXPECT_LE(x.lower, y.upper);
      EXPECT_LE(y.lower, x.upper);
    }
  }
}

TEST(SceneMesh, HoldsWhatIsInsideASolid) {
  const SetPointer solid = object(box_shape({-2, -2, -2}, {2, 2, 2}, 3), MeshKind::solid);
  Scene scene =
      scene_of({standing(solid), ball(0.5, Eigen::Vector3d(-1, 0, 0), Eigen::Vector3d(1, 0, 0), {1, 2, 3})},
               kContinuous | SceneEffects::separated, 1);
  scene.queries[0].every_instant = true;
  for (const SceneRecord& row : run(scene).records)
    EXPECT_TRUE(row.status == SceneStatus::intersecting || row.status == SceneStatus::contact);
}

TEST(SceneMesh, IsRefusedWhereItMeansNothingByNameAndNamesParts) {
  const SetPointer torus = object(torus_shape(1, 0.3, 8, 6));
  const auto refusal = [](const Scene& scene) -> std::string {
    try {
      check_scene(scene);
    } catch (const InvalidParameterError& error) {
      return error.what();
    }
    return "";
  };
  Scene scene =
      scene_of({standing(torus), ball(1, Vector::Zero(3), Vector::Zero(3))}, SceneEffects::depth, 1);
  EXPECT_NE(refusal(scene).find("'mesh' is a mesh as it is: depth and growth"), std::string::npos)
      << refusal(scene);
  EXPECT_NE(refusal(scene).find("convex parts"), std::string::npos);
  scene.queries[0].effects = SceneEffects::growth;
  EXPECT_NE(refusal(scene), "");
  scene.queries[0].effects = SceneEffects::distance;
  EXPECT_EQ(refusal(scene), "");
  scene.queries[0].metric.Q = std::make_shared<Box>(Vector::Constant(3, -1), Vector::Constant(3, 1));
  EXPECT_NE(refusal(scene).find("Euclidean"), std::string::npos);
  scene.queries[0].metric.Q = torus;
  EXPECT_NE(refusal(scene).find("not convex"), std::string::npos);
}

}  // namespace
}  // namespace raygauge::test_scene_mesh
