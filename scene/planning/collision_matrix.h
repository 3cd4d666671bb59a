// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "raygauge/scene/edge_checker.h"

namespace raygauge {

/// The values that a joint takes.
struct JointRange {
  double lower = 0, upper = 0;
};

enum class LinkContact : std::uint8_t {
  never,      ///< no configuration is in contact, proven
  always,     ///< every configuration is in contact, proven
  sometimes,  ///< one is and one is not, both proven
  undecided,  ///< some share of the configurations is not proven
};

/// What two bodies of a robot do over the whole box of joint values.
struct LinkVerdict {
  int body_a = 0, body_b = 0;
  LinkContact contact = LinkContact::undecided;
  double undecided = 0;  ///< share of the volume of the box that is not proven; 0 unless undecided
  std::vector<double>
      contact_at;               ///< values of all joints: a distance of at most `contact`; empty: none found
  std::vector<double> free_at;  ///< the bodies are apart; empty: none found
  double least =
      0;           ///< of bodies that never meet: a proven lower bound on the distance of all configurations
  int joints = 0;  ///< between the two, that take a value
  std::int64_t boxes = 0;  ///< of joint values that were looked at
};

struct CollisionMatrixOptions {
  double contact = 1e-6;             ///< a distance of at most this is a contact
  std::int64_t max_boxes = 500'000;  ///< for one pair; what is left then is undecided
  int threads = 1;
};

/// What is proven already, and who is told of the rest.
struct CollisionMatrixHooks {
  std::vector<LinkVerdict> known;  ///< of the same robot, ranges and options: not proven again
  std::function<void(const LinkVerdict&)> proven;  ///< called by the threads, as soon as a pair is done
};

/// Every pair of bodies of a robot, by branch and bound over the joints between the two. With θ_s the change
/// of the joints from the middle of a box, seen from any link between them, no point of a body moves farther
/// than
///
///     D_s = D_(s+1) + 2 sin(min(θ_s, π)/2) (d_s + D_(s+1)),
///
/// the joints taken from the body on; d_s is the greatest distance of its points from the axis of joint s in
/// the middle of the box (for a prismatic joint D_s = D_(s+1) + θ_s). Bodies farther apart than D of both in
/// the middle are apart in the whole box; bodies that are deeper in each other than that meet in all of it.
/// Bodies that only touch, as links of a joint often do, are proven by touch_everywhere(). The same verdicts
/// for any number of threads. Throws what EdgeChecker throws, and InvalidParameterError for a range that is
/// empty or not finite, or not one for each joint.
std::vector<LinkVerdict> collision_matrix(const RobotModel& robot, const std::vector<JointRange>& ranges,
                                          const CollisionMatrixOptions& options = {},
                                          const CollisionMatrixHooks& hooks = {});

}  // namespace raygauge
