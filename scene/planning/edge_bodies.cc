// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/planning/edge_bodies.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/meshes/box_tree.h"
#include "engine/numerics/floating_point.h"
#include "raygauge/exceptions.h"
#include "raygauge/meshes/mesh.h"
#include "scene/model/part_tree.h"
#include "scene/queries/placed_pair.h"

namespace raygauge {
namespace {

const SceneMetric kEuclidean;

const PlacementError kNoError;

// At a break the motion of the piece before meets that of the piece after it but for the errors of both.
PlacementError error_about(const Motion& motion, double t) {
  const PlacementError error = motion.error_at(t);
  const double before = std::nextafter(t, -kInfinity);
  if (before < motion.start()) return error;
  const PlacementError earlier = motion.error_at(before);
  return {std::max(error.place, earlier.place), std::max(error.turn, earlier.turn)};
}

EdgeShape shape_of_ball(const BoundingBall& ball, double reach, double core_reach) {
  constexpr double kOutward = 1 + 1e-13;
  EdgeShape shape;
  shape.center = ball.center;
  shape.radius = ball.radius;
  shape.center_reach = shape.center.norm() * kOutward;
  shape.reach = reach;
  shape.core_reach = core_reach;
  shape.low.setConstant(-kInfinity);
  shape.high.setConstant(kInfinity);
  return shape;
}

// What support functions lose, as their rounding error says.
void measure_box(const BodyPart& part, EdgeShape& shape) {
  if (const Mesh* mesh = as_mesh(*part.set)) {
    const BoxNode& root = mesh->tree().node(0);
    for (int k = 0; k < 3; ++k) {
      const double center = std::fabs(double{root.center[k]});
      const double reach = (root.reach(k) + mesh->radius()) * (1 + 1e-13) + center * 1e-15;
      shape.low[k] = double{root.center[k]} - reach;
      shape.high[k] = double{root.center[k]} + reach;
    }
    return;
  }
  Eigen::Vector3d point;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double loss = ConvexSet::rounding_error(3) * part.magnitude[k];
    const Eigen::Vector3d u = Eigen::Vector3d::Unit(k), minus = -u;
    shape.high[k] = part.set->support_unchecked(u.data(), point.data()) + loss;
    shape.low[k] = -part.set->support_unchecked(minus.data(), point.data()) - loss;
  }
  shape.thickness = (shape.high - shape.low).minCoeff() / 2;
}

// After those of their children, which come later in the tree.
void take_nodes(EdgeBody& body) {
  const PartTree& tree = *body.body.tree;
  body.shape_of_node.assign(static_cast<std::size_t>(tree.size()), 0);
  const auto shape_of = [&](int node) -> std::size_t& {
    return body.shape_of_node[static_cast<std::size_t>(node)];
  };
  for (int i = tree.size() - 1; i > 0; --i) {
    const PartNode& node = tree.node(i);
    if (node.part >= 0) {
      shape_of(i) = static_cast<std::size_t>(node.part) + 1;
      continue;
    }
    shape_of(i) = body.shapes.size();
    const EdgeShape &one = body.shapes[shape_of(node.first)], &other = body.shapes[shape_of(node.second)];
    EdgeShape shape = shape_of_ball(node.ball, std::max(one.reach, other.reach),
                                    std::max(one.core_reach, other.core_reach));
    shape.low = one.low.cwiseMin(other.low);
    shape.high = one.high.cwiseMax(other.high);
    body.shapes.push_back(shape);
  }
}

void take_shapes(EdgeBody& body) {
  const Body& own = body.body;
  body.shapes.push_back(shape_of_ball(own.ball, own.reach, own.core_reach));
  for (const BodyPart& part : own.parts) {
    body.shapes.push_back(shape_of_ball(part.ball, part.reach, part.core_reach));
    body.shapes.back().part = &part;
    measure_box(part, body.shapes.back());
  }
  EdgeShape& whole = body.shapes.front();
  whole.low = whole.high = body.shapes[1].low;
  for (std::size_t i = 1; i < body.shapes.size(); ++i) {
    whole.low = whole.low.cwiseMin(body.shapes[i].low);
    whole.high = whole.high.cwiseMax(body.shapes[i].high);
  }
  if (own.tree != nullptr) take_nodes(body);
}

void check_space(const Body& body) {
  if (body.dimension() == 3) return;
  throw DimensionMismatchError("body '" + body.name + "' lives in R^" + std::to_string(body.dimension()) +
                               ", a robot in R^3");
}

EdgeBody of_robot(const RobotBody& given, RobotChain& chain) {
  EdgeBody body;
  body.body = make_body(given.name, given.parts,
                        std::make_shared<StaticMotion>(make_placement(given.origin.R, given.origin.t)));
  check_space(body.body);
  if (given.link < 0 || given.link >= chain.links()) {
    throw InvalidParameterError("body '" + given.name + "': there is no link number " +
                                std::to_string(given.link));
  }
  const bool moved = !given.origin.R.isIdentity(0) || !given.origin.t.isZero(0);
  body.link = moved ? chain.add_fixed_link(given.link, given.origin) : given.link;
  return body;
}

EdgeBody of_obstacle(const Body& given, int& moving) {
  if (given.motion == nullptr) throw InvalidParameterError("body '" + given.name + "' has no motion");
  check_space(given);
  EdgeBody body;
  body.body = given;
  body.stands = given.motion->is_static();
  if (!body.stands) body.moving = moving++;
  if (body.stands) body.at = make_frame(given.motion->at(0));
  return body;
}

}  // namespace

std::vector<EdgeBody> edge_bodies(const RobotModel& robot, const std::vector<Body>& obstacles,
                                  RobotChain& chain) {
  std::vector<EdgeBody> bodies;
  bodies.reserve(robot.bodies.size() + obstacles.size());
  for (const RobotBody& given : robot.bodies) bodies.push_back(of_robot(given, chain));
  int moving = 0;
  for (const Body& given : obstacles) bodies.push_back(of_obstacle(given, moving));
  for (EdgeBody& body : bodies) take_shapes(body);
  return bodies;
}

EdgeStage::EdgeStage(const RobotChain& chain, const std::vector<EdgeBody>& bodies) : chain_(chain) {
  for (const EdgeBody& body : bodies) {
    if (body.moving >= 0) moving_.push_back(&body);
  }
}

int EdgeStage::add(double t) {
  const std::size_t moment = times_.size(), links = static_cast<std::size_t>(chain_.links());
  times_.push_back(t);
  if (links_.size() < (moment + 1) * links) links_.resize((moment + 1) * links);
  chain_.place(t, links_.data() + moment * links);
  if (obstacles_.size() < (moment + 1) * moving_.size()) {
    obstacles_.resize((moment + 1) * moving_.size());
    errors_.resize(obstacles_.size());
  }
  for (std::size_t i = 0; i < moving_.size(); ++i) {
    const Motion& motion = *moving_[i]->body.motion;
    obstacles_[moment * moving_.size() + i] = make_frame(motion.at(t));
    errors_[moment * moving_.size() + i] = error_about(motion, t);
  }
  return static_cast<int>(moment);
}

const Frame& EdgeStage::at(int moment, const EdgeBody& body) const {
  if (!body.is_obstacle()) return link(moment, body.link);
  if (body.stands) return body.at;
  return obstacles_[static_cast<std::size_t>(moment) * moving_.size() +
                    static_cast<std::size_t>(body.moving)];
}

void EdgeStage::place(int moment, const EdgeBody& a, const EdgeBody& b, PlacedPair& placed) const {
  const Frame &of_a = at(moment, a), &of_b = at(moment, b);
  placed.bind(a.body, b.body, kEuclidean);
  placed.place({of_a.R, of_a.t}, {of_b.R, of_b.t}, nullptr);
  placed.check_placements();
}

const PlacementError& EdgeStage::error(int moment, const EdgeBody& body) const {
  if (!body.is_obstacle()) return chain_.error(body.link);
  if (body.stands) return kNoError;
  return errors_[static_cast<std::size_t>(moment) * moving_.size() + static_cast<std::size_t>(body.moving)];
}

}  // namespace raygauge
