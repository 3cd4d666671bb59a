// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/planning/robot_chain.h"

#include <gtest/gtest.h>

#include "tests/scene/exact_motion.h"
#include "tests/scene/planning/random_robots.h"

namespace raygauge::test_robot_chain {
namespace {

using namespace random_robots;
using exact_motion::QuadVector;

double length(const QuadVector& x) { return static_cast<double>(exact_motion::norm(x)); }

QuadVector between(const QuadVector& x, const QuadVector& y) {
  return {y[0] - x[0], y[1] - x[1], y[2] - x[2]};
}

/// A robot whose joints follow a line over [0, 1], and the same in quadruple precision.
struct Case {
  explicit Case(Random& random) : model(robot(random)), chain(model.tree, model.joints, model.base) {
    const double size = uniform(random, 0.01, 3);
    q0 = configuration(random, model, size);
    q1 = configuration(random, model, size);
    chain.follow(q0, q1, 0, 1);
    trajectory = line(q0, q1);
    const Placement near = make_placement(model.base.R, model.base.t);
    base = near;
    tree = model.tree;
    for (TreeLink& link : tree.links) {
      link.origin = make_placement(link.origin.R, link.origin.t);
      link.axis.normalize();
    }
  }
  exact_motion::Frame exact(int link, double t) const {
    return exact_motion::link(tree, trajectory, base, link, t);
  }

  RobotModel model;
  RobotChain chain;
  std::vector<double> q0, q1;
  JointTrajectory trajectory;
  Placement base;
  KinematicTree tree;
};

TEST(RobotChain, LinksAreWhereTheExactOnesAreButForTheErrorStated) {
  Random random(41);
  double largest = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Case one(random);
    std::vector<Frame> frames(static_cast<std::size_t>(one.chain.links()));
    const double t = uniform(random, 0, 1);
    one.chain.place(t, frames.data());
    for (int i = 0; i < one.chain.links(); ++i) {
      const exact_motion::Frame exact = one.exact(i, t);
      const Frame& here = frames[static_cast<std::size_t>(i)];
      const double place = length(between(exact.t, exact_motion::quad_vector(here.t)));
      ASSERT_LE(place, one.chain.error(i).place);
      largest = std::max(largest, place / one.chain.error(i).place);
      double turn = 0;
      for (int k = 0; k < 9; ++k) {
        const Quad off =
            exact.R[static_cast<std::size_t>(k / 3)][static_cast<std::size_t>(k % 3)] - here.R(k / 3, k % 3);
        turn += static_cast<double>(off * off);
      }
      ASSERT_LE(std::sqrt(turn), 2 * one.chain.error(i).turn);
    }
  }
  EXPECT_GT(largest, 0.01);
}

// From any link that carries it, and between any two times.
TEST(RobotChain, NoPointIsFartherFromTheChordThanTheSag) {
  Random random(42);
  double largest = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Case one(random);
    const int link = static_cast<int>(random() % static_cast<unsigned>(one.chain.links()));
    const std::vector<int>& path = one.chain.path(link);
    const std::size_t left_out = random() % (path.size() + 1);
    SmallVector p = uniform_vector(random, 3, 1.0);
    const double reach = p.norm() * (1 + 1e-15);
    ChordBounds bounds;
    one.chain.bound(link, reach, bounds);
    const double first = uniform(random, 0, 0.9), last = first + uniform(random, 0, 1) * (1 - first);
    const double s = uniform(random, 0, 1), t = first + s * (last - first);
    const auto seen = [&](double at) {
      const QuadVector x = one.exact(link, at)(exact_motion::quad_vector(p));
      if (left_out == 0) return x;
      const exact_motion::Frame carrier = one.exact(path[left_out - 1], at);
      return carrier.transposed().turned(between(carrier.t, x));
    };
    const QuadVector x0 = seen(first), x1 = seen(last), x = seen(t);
    QuadVector chord = x0;
    const Quad share = (Quad(t) - Quad(first)) / (Quad(last) - Quad(first));
    for (std::size_t k = 0; k < 3; ++k) chord[k] += share * (x1[k] - x0[k]);
    const double sag = bounds.sag(left_out, last - first), off = length(between(chord, x));
    ASSERT_LE(off, 4 * s * (1 - s) * sag * (1 + 1e-9) + 1e-12) << trial;
    if (sag > 1e-9) largest = std::max(largest, off / sag);
  }
  EXPECT_GT(largest, 0.5);  // bounds that mean something
}

}  // namespace
}  // namespace raygauge::test_robot_chain
