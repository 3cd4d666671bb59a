// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Groups of bodies that cannot meet within a step take it on threads.
#include <gtest/gtest.h>

#include <random>
#include <utility>

#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/capsule.h"
#include "scene/simulation/simulation_part.h"
#include "tests/scene/simulation/reacting_scenes.h"

namespace raygauge::test_simulation_threads {
namespace {

using namespace reacting_scenes;

// Some fall on others, some beside them; one more comes fast from the side. `inwards`: how fast they come
// together, of their distance a second.
Reacting heap(double to, double inwards = 0) {
  Reacting all(to);
  all.dynamics.gravity = v(0, 0, -9.81);
  all.dynamics.contact = ContactLaw{0.5, 0.2};
  all.dynamics.step = 2e-3;
  all.dynamics.tolerance = 1e-4;
  all.add(floor(), v(0, 0, 0), 0);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> some(-1, 1);
  const Shape capsule = std::make_shared<Capsule>(v(0, 0, -0.1), v(0, 0, 0.1), 0.08);
  for (int k = 0; k < 24; ++k) {
    const Eigen::Matrix3d R = Eigen::Quaterniond(some(random), some(random), some(random), some(random))
                                  .normalized()
                                  .toRotationMatrix();
    const int row = k / 4 % 3, layer = k / 12;
    const Eigen::Vector3d at(0.42 * (k % 4) + 0.05 * some(random), 0.42 * row + 0.05 * some(random),
                             0.3 + 0.42 * layer);
    all.add(k % 3 == 0 ? box(0.1, 0.08, 0.06) : k % 3 == 1 ? ball(0.12) : capsule, at, 1, R);
    all.dynamics.bodies.back().velocity = inwards * v(0.63 - at[0], 0.42 - at[1], 0);
  }
  all.add(ball(0.1), v(-1.5, 0.4, 0.3), 1);
  all.dynamics.bodies.back().velocity = v(8, 0, 0);
  return all;
}

/// All that a simulation stores.
struct Stored {
  std::vector<SimulationPart> parts;
  Simulation found;
};

Stored simulated(const Reacting& all, int threads) {
  Stored stored;
  SimulationHooks hooks;
  hooks.threads = threads;
  hooks.due = [] { return false; };
  hooks.store = [&stored](const SimulationPart& part) { stored.parts.push_back(part); };
  stored.found = simulate(all.scene, all.dynamics, nullptr, hooks);
  return stored;
}

std::vector<double> numbers_of(const Stored& stored) {
  std::vector<double> all;
  const auto add = [&all](const auto& v) { all.insert(all.end(), v.data(), v.data() + v.size()); };
  for (const SimulationPart& part : stored.parts) {
    for (const auto& pieces : part.pieces) {
      for (const MotionPiece& piece : pieces) {
        all.push_back(piece.start);
        add(piece.R);
        add(piece.x);
        add(piece.velocity);
        add(piece.spin);
      }
    }
    for (const ContactRecord& one : part.contacts) {
      all.insert(all.end(),
                 {one.time, one.gap, static_cast<double>(one.body_a), static_cast<double>(one.body_b)});
      add(one.point);
      add(one.impulse);
    }
    for (const StepRecord& row : part.steps)
      all.insert(all.end(), {row.time, row.residual, row.least_distance, row.kinetic,
                             static_cast<double>(row.substeps), static_cast<double>(row.contacts)});
    for (const KnownNormal& one : part.state.normals) add(one.normal);
    for (const KnownImpulse& one : part.state.impulses) add(one.impulse);
    const SimulationCounters& c = part.counters;
    for (const std::int64_t count : {c.ball_tests, c.contact_queries, c.motion_proofs, c.friction_problems,
                                     c.frictionless_problems, c.impact_problems})
      all.push_back(static_cast<double>(count));
  }
  return all;
}

TEST(SimulationThreads, what_is_found_is_the_same_bit_for_bit_on_any_number_of_threads) {
  const Reacting all = heap(0.4);
  const std::vector<double> one = numbers_of(simulated(all, 1));
  EXPECT_GT(one.size(), 50000U);
  EXPECT_TRUE(numbers_of(simulated(all, 2)) == one);
  EXPECT_TRUE(numbers_of(simulated(all, 3)) == one);
}

// Bodies that come together become one group: its pairs and islands are what threads share.
TEST(SimulationThreads, a_heap_in_one_group_is_the_same_bit_for_bit_on_any_number_of_threads) {
  const Reacting all = heap(0.35, 4);
  const std::vector<double> one = numbers_of(simulated(all, 1));
  EXPECT_GT(one.size(), 50000U);
  for (const int threads : {2, 3}) EXPECT_TRUE(numbers_of(simulated(all, threads)) == one) << threads;
}

TEST(SimulationThreads, groups_keep_the_limit_of_all_pairs) {
  const Stored stored = simulated(heap(0.4), 2);
  const double delta = stored.found.tolerance;
  for (const StepRecord& row : stored.found.steps) {
    EXPECT_GE(row.least_distance, -delta);
    EXPECT_LE(row.residual, 1e-8);
  }
  // Looked at from outside, at the ends of steps.
  const auto& bodies = stored.found.scene.bodies;
  const Ball metric(v(0, 0, 0), 1);
  ObjectDistanceSolver between;
  const auto set_at = [](const Body& body, double time) {
    const Placement at = body.motion->at(time);
    return std::pair<const ConvexSet*, Pose>(body.parts.front().set.get(),
                                             Pose(Eigen::MatrixXd(at.R), Eigen::VectorXd(at.t)));
  };
  for (std::size_t k = 0; k < stored.found.steps.size(); k += 5) {
    const StepRecord& row = stored.found.steps[k];
    for (std::size_t a = 0; a < bodies.size(); ++a) {
      for (std::size_t b = a + 1; b < bodies.size(); ++b) {
        const auto [one, at_one] = set_at(bodies[a], row.time);
        const auto [other, at_other] = set_at(bodies[b], row.time);
        const auto& found = between.solve({*one, at_one}, {*other, at_other}, metric, ObjectEffects::depth);
        EXPECT_LE(found.depth.evaluations > 0 ? found.depth.lower : 0, delta * (1 + 1e-6));
      }
    }
  }
}

}  // namespace
}  // namespace raygauge::test_simulation_threads
