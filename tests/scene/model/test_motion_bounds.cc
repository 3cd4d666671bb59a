// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <functional>

#include "raygauge/scene/motion.h"
#include "tests/scene/exact_motion.h"
#include "tests/scene/random_scenes.h"

// Every bound of every kind of motion against the exact motion, in quadruple precision.
namespace raygauge::test_motion_bounds {
namespace {

using namespace random_scenes;
using exact_motion::Frame;
using exact_motion::QuadVector;

// What the exact motions lose, of coordinates up to 1e8 and angles up to 1e3.
constexpr double kQuadRounding = 1e-22;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// A motion over [0, stop] as the engine has it, and exactly.
struct Case {
  MotionPointer computed;
  std::function<Frame(Quad)> exact;
  double stop = 1;
};

double power_of_ten(Random& random, double least, double most) {
  return std::pow(10.0, uniform(random, least, most));
}

// Decelerates to rest near the origin from as far as 1e8, and accelerates again; spins or not.
Case resting(Random& random, int n) {
  const double stop = power_of_ten(random, -2, 2);
  const double rest = uniform(random, 0, 1) * stop;
  const double far = power_of_ten(random, 0, 8);
  TwistMotion::Rates rates;
  rates.acceleration = uniform_vector(random, n, 1.0) * (far / (stop * stop));
  rates.velocity = -rest * rates.acceleration;
  if (random() % 2 == 0) rates.spin = {0, 0, uniform(random, -20, 20) / stop};
  if (n == 3 && random() % 2 == 0)
    rates.spin.head(2) = Eigen::Vector2d(uniform_vector(random, 2, 9.0)) / stop;
  Placement first = placement(random, n, 1.0);
  first.t = rest * rest / 2 * rates.acceleration + uniform_vector(random, n, 1.0);
  return {std::make_shared<TwistMotion>(first, rates, 0.0),
          [=](Quad t) { return exact_motion::twist(first, rates, 0.0, t); }, stop};
}

// There and back, or past the origin, with turns of any size down to none.
Case reversing(Random& random, int n) {
  const double far = power_of_ten(random, 0, 8);
  const double stop = power_of_ten(random, -3, 2);
  const std::vector<double> times = {0, uniform(random, 0.1, 0.9) * stop, stop};
  std::vector<Placement> frames = {placement(random, n, far)};
  for (int i = 0; i < 2; ++i) {
    Placement frame = placement(random, n, i == 0 ? 1.0 : far);
    const double turn = power_of_ten(random, -12, 0);
    const SmallMatrix by = n == 2 ? plane_rotation(turn) : rotation_about(uniform_vector(random, 3, turn));
    if (random() % 2 == 0) frame.R = by * frames.back().R;
    if (random() % 4 == 0) frame.R = frames.back().R;
    if (random() % 8 == 0) frame.t = frames.back().t;
    frames.push_back(frame);
  }
  return {std::make_shared<KeyframeMotion>(times, frames),
          [=](Quad t) { return exact_motion::keyframes(times, frames, t); }, stop};
}

// A chain of up to six links as long as 1e6, of which every second one lies against the one before.
Case folding(Random& random) {
  auto tree = std::make_shared<KinematicTree>();
  auto trajectory = std::make_shared<JointTrajectory>();
  const int links = 2 + static_cast<int>(random() % 5);
  const double length = power_of_ten(random, -1, 6);
  const double stop = power_of_ten(random, -1, 1);
  trajectory->times = {0, 0.4 * stop, stop};
  trajectory->values.resize(links, 3);
  for (int i = 0; i < links; ++i) {
    TreeLink link;
    link.parent = i - 1;
    link.origin = placement(random, 3, 0.5);
    if (i > 0 && random() % 4 != 0) link.origin = Placement::identity(3);
    if (i > 0) link.origin.t[0] += length;
    const bool slides = random() % 4 == 0;
    link.kind = slides ? JointKind::prismatic : JointKind::revolute;
    link.axis = random() % 2 == 0 ? Eigen::Vector3d(0, 0, 1)
                                  : Eigen::Vector3d(uniform_vector(random, 3, 1.0)).normalized();
    link.joint = i;
    link.scale = random() % 2 == 0 ? 1.0 : uniform(random, -2, 2);
    link.offset = slides ? -length * uniform(random, 0, 1) : (random() % 2 == 0 ? EIGEN_PI : 0.0);
    const double swing = power_of_ten(random, -7, 0.5);
    for (int k = 0; k < 3; ++k) trajectory->values(i, k) = uniform(random, -swing, swing);
    if (random() % 5 == 0) trajectory->values.row(i).setConstant(0.3);
    tree->links.push_back(link);
  }
  const Placement base = placement(random, 3, random() % 2 == 0 ? 1.0 : 1e5);
  const int last = links - 1;
  return {std::make_shared<LinkMotion>(tree, trajectory, base, last),
          [=](Quad t) { return exact_motion::link(*tree, *trajectory, base, last, t); }, stop};
}

Case draw(Random& random, int trial) {
  const int n = 2 + trial % 2;
  if (trial % 5 == 0) return folding(random);
  return trial % 5 < 3 ? resting(random, n) : reversing(random, n);
}

double off(const Placement& computed, const Frame& exact, bool of_rotation) {
  const Frame frame = exact_motion::frame_of(computed);
  Quad place = 0, turn = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    place += (frame.t[i] - exact.t[i]) * (frame.t[i] - exact.t[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      turn += (frame.R[i][k] - exact.R[i][k]) * (frame.R[i][k] - exact.R[i][k]);
    }
  }
  // The Frobenius norm of a difference of two rotations is √2 times the spectral norm.
  return static_cast<double>(elementary::sqrt(of_rotation ? turn / 2 : place));
}

TEST(MotionBounds, PlacementsAreOffByNoMoreThanTheMotionSays) {
  Random random(31);
  double largest = 0;  // share of the bound that is used
  for (int trial = 0; trial < 3000; ++trial) {
    const Case motion = draw(random, trial);
    for (int k = 0; k <= 10; ++k) {
      const double t = std::min(motion.stop, k / 10.0 * motion.stop);
      const Frame exact = motion.exact(t);
      const PlacementError error = motion.computed->error_at(t);
      const double place = off(motion.computed->at(t), exact, false);
      ASSERT_LE(place, error.place + kQuadRounding) << trial;
      ASSERT_LE(off(motion.computed->at(t), exact, true), error.turn + kQuadRounding) << trial;
      if (error.place > 0) largest = std::max(largest, place / error.place);
    }
  }
  EXPECT_GT(largest, 0.02);  // bounds that mean something
}

// No point within the reach gets farther along any direction, between any two moments of an interval, than
// the interval's bound says.
TEST(MotionBounds, NoPointIsFasterThanTheMotionSays) {
  Random random(32);
  for (int trial = 0; trial < 3000; ++trial) {
    const Case motion = draw(random, trial);
    const int n = motion.computed->dimension();
    const double from = uniform(random, 0, 1) * motion.stop;
    const double most = std::min(motion.stop, motion.computed->next_break(from));
    const double to = std::min(most, from + power_of_ten(random, -6, 0) * motion.stop);
    const MotionBound bound = motion.computed->bound(from, to);
    const double reach = power_of_ten(random, -2, 1);
    SmallVector p = uniform_vector(random, n, 1.0);
    p *= reach / std::max(1e-3, p.norm());
    const SmallVector u = uniform_vector(random, n, 1.0);
    // What a keyframe's motion may differ by from the one that is bounded.
    const double astray =
        kQuadRounding + (trial % 5 < 3 ? 0 : 2 * motion.computed->error_at(from).of_points(reach));
    double t0 = from + uniform(random, 0, 0.5) * (to - from);
    const double t1 = t0 + uniform(random, 0, 1) * (to - t0);
    const QuadVector x0 = motion.exact(t0)(exact_motion::quad_vector(p));
    const QuadVector x1 = motion.exact(t1)(exact_motion::quad_vector(p));
    const QuadVector way{x1[0] - x0[0], x1[1] - x0[1], x1[2] - x0[2]};
    const Quad time = Quad(t1) - Quad(t0);
    const Quad along = exact_motion::dot(way, exact_motion::quad_vector(u));
    EXPECT_TRUE(along <= bound.speed_along(u, reach * (1 + 1e-15)) * time + astray * std::max(1.0, u.norm()))
        << trial;
    EXPECT_TRUE(exact_motion::norm(way) <= bound.speed(reach * (1 + 1e-15)) * time + astray) << trial;
  }
}

TEST(MotionBounds, WhatIsTooFastForNumbersIsNotProvenSlow) {
  const Placement here = Placement::identity(3);
  Placement there = here;
  there.t << 10, 0, 0;
  Placement turned = here;
  turned.R = rotation_about({0, 0, 1});
  const SmallVector u = Eigen::Vector3d::UnitX(), minus = -u;
  for (const Placement& last : {there, turned}) {
    const MotionBound bound = KeyframeMotion({0, 1e-310}, {here, last}).bound(0, 1e-310);
    for (const double reach : {0.0, 1.0}) {
      EXPECT_EQ(bound.speed(reach), kInfinite);
      EXPECT_EQ(bound.speed_along(u, reach), kInfinite);
      EXPECT_EQ(bound.speed_along(minus, reach), kInfinite);
    }
  }
  // A body that rests is slow however short the time.
  EXPECT_EQ(KeyframeMotion({0, 1e-310}, {there, there}).bound(0, 1e-310).speed(1), 0);
  TwistMotion::Rates rates;
  rates.velocity = Eigen::Vector3d(1e200, -1e200, 0);
  EXPECT_EQ(TwistMotion(here, rates, 0.0).bound(0, 1).speed_along(u, 1), kInfinite);
  EXPECT_EQ(TwistMotion(here, rates, 0.0).error_at(1).place, kInfinite);
}

// Of two links of one robot: what carries both, and how both move on it, is how they move.
TEST(MotionBounds, LinksOfARobotRideOnTheLinkThatCarriesBoth) {
  Random random(33);
  int rides = 0;
  for (int trial = 0; trial < 300; ++trial) {
    auto tree = std::make_shared<KinematicTree>();
    auto trajectory = std::make_shared<JointTrajectory>();
    trajectory->times = {0, 0.5, 1};
    trajectory->values = Eigen::MatrixXd::Random(7, 3);
    for (int i = 0; i < 7; ++i) {
      TreeLink link;
      link.parent = i == 0 ? -1 : static_cast<int>(random() % static_cast<unsigned>(i));
      link.origin = placement(random, 3, 0.5);
      link.kind = static_cast<JointKind>(random() % 3);
      link.axis = Eigen::Vector3d(uniform_vector(random, 3, 1.0)).normalized();
      link.joint = i;
      tree->links.push_back(link);
    }
    const Placement base = placement(random, 3, 1.0);
    const LinkMotion a(tree, trajectory, base, 5), b(tree, trajectory, base, 6);
    const auto ride = shared_ride(a, b);
    if (!ride) continue;
    ++rides;
    const double t = uniform(random, 0, 1);
    const Placement carrier = ride->carrier->at(t);
    EXPECT_LT(((carrier * ride->a->at(t)).t - a.at(t).t).norm(), 1e-14);
    EXPECT_LT(((carrier * ride->b->at(t)).R - b.at(t).R).norm(), 1e-14);
  }
  EXPECT_GT(rides, 100);
}

}  // namespace
}  // namespace raygauge::test_motion_bounds
