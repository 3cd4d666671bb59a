// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/soak/random_edges.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/number_text.h"

namespace raygauge::soak {
namespace {

using namespace random_robots;
using Values = std::vector<double>;

constexpr double kRounding = 1e-9;  // of brute force and of placements, for bodies of a size near 1
constexpr int kMoments = 40;

void draw_end(Random& random, bool on_grid, const Values& from, Values& to) {
  for (std::size_t i = 0; i < to.size(); ++i) {
    to[i] = from[i] + uniform(random, -1, 1);
    if (on_grid) to[i] = EIGEN_PI / 4 * static_cast<double>(static_cast<int>(random() % 17) - 8);
    if (random() % 4 == 0) to[i] = from[i];
  }
}

/// `obstacle` where it stands, shifted so that it is `target` away from a body of the robot at time t; as it
/// is where the two are not apart.
Body put_near(const Body& of_robot, const Body& obstacle, double t, double target) {
  const Placement at = of_robot.motion->at(t);
  Placement where = obstacle.motion->at(t);
  const Pose pose_a(at.R, at.t), pose_b(where.R, where.t);
  ObjectDistanceSolver solver;
  const auto& found = solver.solve({*of_robot.parts[0].set, pose_a}, {*obstacle.parts[0].set, pose_b},
                                   Ball(Vector::Zero(3), 1.0), ObjectEffects::closest_points);
  if (found.closest_point_1.size() != 3 || found.closest_point_2.size() != 3) return obstacle;
  const SmallVector way = found.closest_point_2 - found.closest_point_1;
  const double d = way.norm();
  if (d > 1e-6) where.t -= (1 - target / d) * way;
  return make_body(obstacle.name, {obstacle.parts[0].set}, std::make_shared<StaticMotion>(where));
}

/// By balls alone.
bool surely_apart(const Body& a, const Body& b, double t, double margin) {
  const Placement at_a = a.motion->at(t), at_b = b.motion->at(t);
  const SmallVector way = at_a.R * a.ball.center + at_a.t - at_b.R * b.ball.center - at_b.t;
  return way.norm() > a.ball.radius + b.ball.radius + margin + 1e-6;
}

std::string words(const Body& a, const Body& b, double t) {
  return a.name + " and " + b.name + " at " + shortest_text(t);
}

}  // namespace

std::string RandomEdges::error_at(const Body& a, const Body& b, const EdgeOptions& options, double t) {
  if (surely_apart(a, b, t, options.margin)) return "";
  ++tally_.samples;
  const BruteForce truth = brute_force(a, b, t);
  if (!truth.intersecting && truth.upper >= options.margin - kRounding) return "";
  return "said to be free, but " + words(a, b, t) + " are at most " + shortest_text(truth.upper) + " apart";
}

std::string RandomEdges::error_of(const RobotModel& robot, const std::vector<Body>& bodies,
                                  const EdgeOptions& options, const EdgeResult& result, double moment) {
  if (result.outcome == EdgeOutcome::contact) {
    const Body& a = bodies[static_cast<std::size_t>(result.body_a)];
    const Body& b = bodies[static_cast<std::size_t>(result.body_b)];
    if (is_ignored(robot, result.body_a, result.body_b)) return "in contact, but ignored: " + a.name;
    ++tally_.samples;
    const BruteForce truth = brute_force(a, b, result.time);
    if (truth.lower <= options.margin + options.contact + kRounding) return "";
    return "said to be in contact, but " + words(a, b, result.time) + " are " + shortest_text(truth.lower) +
           " apart";
  }
  if (result.outcome != EdgeOutcome::free) return "";
  for (int a = 0; a < static_cast<int>(robot.bodies.size()); ++a) {
    for (int b = a + 1; b < static_cast<int>(bodies.size()); ++b) {
      if (is_ignored(robot, a, b)) continue;
      for (int k = -1; k <= kMoments; ++k) {
        const double t = k < 0 ? moment : static_cast<double>(k) / kMoments;
        std::string error =
            error_at(bodies[static_cast<std::size_t>(a)], bodies[static_cast<std::size_t>(b)], options, t);
        if (!error.empty()) return error;
      }
    }
  }
  return "";
}

std::optional<std::string> RandomEdges::check(std::int64_t number) {
  Random random(seed_ * 0x9E3779B97F4A7C15U + static_cast<std::uint64_t>(number));
  const RobotModel model = robot(random);
  std::vector<Body> around = obstacles(random, 1 + static_cast<int>(random() % 3), uniform(random, 1, 8));
  EdgeOptions options;
  if (random() % 2 == 0) options.margin = uniform(random, 0, 0.2);
  EdgeChecker checker(model, around, options);
  Values q = configuration(random, model, 2), next = q;
  for (int k = 0; k < kEdges; ++k, q = next) {
    const bool still = random() % 10 == 0;
    if (!still) draw_end(random, random() % 3 == 0, q, next);
    std::vector<Body> bodies = moving_bodies(model, around, line(q, next));
    const double moment = uniform(random, 0, 1);
    if (random() % 3 == 0 && !model.bodies.empty()) {
      const double off = random() % 7 == 0 ? 0 : std::pow(10, uniform(random, -9, -3));
      const double target = std::max(0.0, options.margin + (random() % 2 == 0 ? off : -off));
      around.back() = put_near(bodies[random() % model.bodies.size()], around.back(), moment, target);
      bodies.back() = around.back();
      checker = EdgeChecker(model, around, options);
      ++tally_.grazing;
    }
    const EdgeResult result = checker.edge(q, next);
    ++tally_.edges;
    tally_.still += still ? 1 : 0;
    tally_.free += result.outcome == EdgeOutcome::free ? 1 : 0;
    tally_.contact += result.outcome == EdgeOutcome::contact ? 1 : 0;
    tally_.undecided += result.outcome == EdgeOutcome::undecided ? 1 : 0;
    const std::string error = error_of(model, bodies, options, result, moment);
    if (!error.empty())
      return "robot " + std::to_string(number) + ", edge " + std::to_string(k) + ": " + error;
  }
  return std::nullopt;
}

std::string to_string(const EdgeSoakTally& tally) {
  return std::to_string(tally.edges) + " edges: " + std::to_string(tally.free) + " free, " +
         std::to_string(tally.contact) + " in contact, " + std::to_string(tally.undecided) + " undecided; " +
         std::to_string(tally.still) + " of no length, " + std::to_string(tally.grazing) + " grazing; " +
         std::to_string(tally.samples) + " distances compared\n";
}

}  // namespace raygauge::soak
