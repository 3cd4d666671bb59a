// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/planning/collision_matrix.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "engine/threads/team.h"
#include "raygauge/exceptions.h"
#include "scene/planning/joint_box.h"
#include "scene/planning/link_pair.h"

namespace raygauge {
namespace {

void check(const RobotModel& robot, const std::vector<JointRange>& ranges) {
  if (static_cast<int>(ranges.size()) != robot.joints) {
    throw InvalidParameterError("ranges of " + std::to_string(ranges.size()) + " joints for a robot of " +
                                std::to_string(robot.joints));
  }
  for (const JointRange& range : ranges) {
    if (!std::isfinite(range.lower) || !std::isfinite(range.upper) || !(range.lower <= range.upper))
      throw InvalidParameterError("the range of a joint must be finite and not empty");
  }
}

}  // namespace

// Those between which most joints lie take longest and begin.
std::vector<LinkVerdict> collision_matrix(const RobotModel& robot, const std::vector<JointRange>& ranges,
                                          const CollisionMatrixOptions& options,
                                          const CollisionMatrixHooks& hooks) {
  check(robot, ranges);
  const RobotChain chain(robot.tree, robot.joints, robot.base);
  const auto count = static_cast<int>(robot.bodies.size());
  const auto link = [&](int body) { return robot.bodies[static_cast<std::size_t>(body)].link; };
  for (int a = 0; a < count; ++a) {
    if (link(a) < 0 || link(a) >= chain.links())
      throw InvalidParameterError("there is no link number " + std::to_string(link(a)));
  }
  std::map<std::pair<int, int>, LinkVerdict> known;
  for (const LinkVerdict& verdict : hooks.known) known[{verdict.body_a, verdict.body_b}] = verdict;
  std::vector<LinkVerdict> verdicts;
  std::vector<std::pair<int, std::size_t>> order;
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      const auto found = known.find({a, b});
      if (found == known.end()) {
        const JointsBetween between(robot.tree, chain, link(a), link(b));
        order.emplace_back(-static_cast<int>(between.joints().size()), verdicts.size());
      }
      verdicts.push_back(found == known.end() ? LinkVerdict() : found->second);
      verdicts.back().body_a = a;
      verdicts.back().body_b = b;
    }
  }
  std::sort(order.begin(), order.end());
  std::atomic<std::size_t> next{0};
  run_team(options.threads, {}, [&](int, int) {
    for (std::size_t k = next++; k < order.size(); k = next++) {
      LinkVerdict& verdict = verdicts[order[k].second];
      verdict = prove_link_pair(robot, ranges, verdict.body_a, verdict.body_b, options);
      if (hooks.proven) hooks.proven(verdict);
    }
  });
  return verdicts;
}

}  // namespace raygauge
