// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/contact_problem.h"

#include <gtest/gtest.h>

#include <vector>

namespace raygauge::test_contact_problem {
namespace {

// A cube on a floor, at four feet that share its weight at will: what is found depends on the guess.
std::vector<SimulatedBody> cube_and_floor() {
  std::vector<SimulatedBody> bodies(2);
  SimulatedBody& cube = bodies[0];
  cube.mass = cube.inverse_mass = 1;
  cube.rotor.J = cube.rotor.J_inverse = cube.rotor.root = Eigen::Matrix3d::Identity();
  cube.v = {0.01, 0, -1};
  return bodies;
}

std::vector<ContactUnknown> feet(const Eigen::Vector4d& guess) {
  std::vector<ContactUnknown> contacts;
  for (int foot = 0; foot < 4; ++foot) {
    ContactUnknown& one = contacts.emplace_back();
    one.a = 0;
    one.b = 1;
    one.at = {foot % 2 == 0 ? 0.5 : -0.5, foot < 2 ? 0.5 : -0.5, -0.5};
    one.normal = Eigen::Vector3d::UnitZ();
    one.mu = 0.5;
    one.impulse = {0, 0, guess[foot]};
  }
  return contacts;
}

double first_foot(ContactProblem& problem, const Eigen::Vector4d& guess) {
  std::vector<SimulatedBody> bodies = cube_and_floor();
  std::vector<ContactUnknown> contacts = feet(guess);
  EXPECT_LE(problem.solve(contacts, bodies), 1e-9);
  EXPECT_LE(bodies[0].v.norm(), 1e-8);
  return contacts[0].impulse[2];
}

TEST(ContactProblem, an_island_that_is_known_is_not_solved_again) {
  SimulationCounters counters;
  ContactProblem problem(3, nullptr, counters);
  const Eigen::Vector4d even = Eigen::Vector4d::Constant(0.25), across(0.5, 0, 0, 0.5);
  const double first = first_foot(problem, even);
  EXPECT_EQ(first_foot(problem, across), first);
  problem.forget();
  EXPECT_GT(first_foot(problem, across), first + 0.1);
}

}  // namespace
}  // namespace raygauge::test_contact_problem
