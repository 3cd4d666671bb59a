// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/scene/edge_checker.h"

#include "raygauge/exceptions.h"
#include "scene/planning/edge_search.h"

namespace raygauge {
namespace {

// Where a body hangs: the nearest link up the tree, itself first, that has a body.
int next_link_with_body(const RobotModel& robot, const std::vector<bool>& has_body, int link) {
  while (link >= 0 && !has_body[static_cast<std::size_t>(link)])
    link = robot.tree.links[static_cast<std::size_t>(link)].parent;
  return link;
}

}  // namespace

std::vector<std::pair<int, int>> joined_bodies(const RobotModel& robot) {
  std::vector<bool> has_body(robot.tree.links.size(), false);
  for (const RobotBody& body : robot.bodies) has_body.at(static_cast<std::size_t>(body.link)) = true;
  std::vector<std::pair<int, int>> joined;
  for (int a = 0; a < static_cast<int>(robot.bodies.size()); ++a) {
    const int link_a = robot.bodies[static_cast<std::size_t>(a)].link;
    const int above_a =
        next_link_with_body(robot, has_body, robot.tree.links[static_cast<std::size_t>(link_a)].parent);
    for (int b = a + 1; b < static_cast<int>(robot.bodies.size()); ++b) {
      const int link_b = robot.bodies[static_cast<std::size_t>(b)].link;
      const int above_b =
          next_link_with_body(robot, has_body, robot.tree.links[static_cast<std::size_t>(link_b)].parent);
      if (link_a == link_b || link_a == above_b || link_b == above_a) joined.emplace_back(a, b);
    }
  }
  return joined;
}

EdgeChecker::EdgeChecker(const RobotModel& robot, const std::vector<Body>& obstacles,
                         const EdgeOptions& options)
    : search_(std::make_unique<EdgeSearch>(robot, obstacles, options)) {}

EdgeChecker::~EdgeChecker() = default;
EdgeChecker::EdgeChecker(EdgeChecker&&) noexcept = default;
EdgeChecker& EdgeChecker::operator=(EdgeChecker&&) noexcept = default;

const EdgeResult& EdgeChecker::edge(std::span<const double> q0, std::span<const double> q1, double from,
                                    double to) {
  return search_->edge(q0, q1, from, to);
}

const EdgeResult& EdgeChecker::configuration(std::span<const double> q, double time) {
  return search_->configuration(q, time);
}

const EdgeResult& EdgeChecker::path(const JointTrajectory& trajectory) { return search_->path(trajectory); }

void EdgeChecker::forget() { search_->forget(); }

int EdgeChecker::joints() const noexcept { return search_->joints(); }

int EdgeChecker::bodies() const noexcept { return static_cast<int>(search_->bodies().size()); }

const std::string& EdgeChecker::name(int i) const {
  if (i < 0 || i >= bodies()) throw InvalidParameterError("there is no body number " + std::to_string(i));
  return search_->bodies()[static_cast<std::size_t>(i)].body.name;
}

const EdgeOptions& EdgeChecker::options() const noexcept { return search_->options(); }

}  // namespace raygauge
