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

// The cube between two slopes, both of which it overlaps.
std::vector<ContactUnknown> slopes() {
  std::vector<ContactUnknown> contacts = feet(Eigen::Vector4d::Zero());
  contacts.resize(2);
  for (int side = 0; side < 2; ++side) {
    ContactUnknown& one = contacts[static_cast<std::size_t>(side)];
    one.at = {side == 0 ? -0.5 : 0.5, 0, 0};
    one.normal = Eigen::Vector3d(side == 0 ? 1 : -1, 0, 0.2).normalized();
    one.offset = -1e-3;
  }
  contacts[1].b = 2;
  return contacts;
}

// Friction keeps it there: no impulse pushes it out.
TEST(ContactProblem, overlaps_that_cannot_go_are_left_between_bodies_that_stand) {
  SimulationCounters counters;
  ContactProblem problem(3, nullptr, counters);
  for (int again = 0; again < 2; ++again) {
    std::vector<SimulatedBody> bodies = cube_and_floor();
    bodies.emplace_back();
    std::vector<ContactUnknown> contacts = slopes();
    EXPECT_LE(problem.solve(contacts, bodies), 1e-9);
    EXPECT_TRUE(problem.jammed().empty());
    EXPECT_LE(bodies[0].v.norm(), 1e-8);
    for (const ContactUnknown& contact : contacts) EXPECT_EQ(contact.offset, 0);
  }
}

TEST(ContactProblem, bodies_that_close_in_on_another_jam_it) {
  SimulationCounters counters;
  ContactProblem problem(3, nullptr, counters);
  for (int again = 0; again < 2; ++again) {
    std::vector<SimulatedBody> bodies = cube_and_floor();
    bodies.emplace_back();
    bodies[2].v = {-1, 0, 0};
    std::vector<ContactUnknown> contacts = slopes();
    EXPECT_GT(problem.solve(contacts, bodies), 1e-6);
    EXPECT_EQ(problem.jammed(), (std::vector<int>{0, 1, 2}));
  }
}

}  // namespace
}  // namespace raygauge::test_contact_problem
