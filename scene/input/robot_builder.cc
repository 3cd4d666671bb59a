// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/input/robot_builder.h"

#include <utility>

namespace raygauge::cli {
namespace {

Placement shift(const Eigen::Vector3d& by) {
  Placement placement = Placement::identity(3);
  placement.t = by;
  return placement;
}

}  // namespace

void add_ball_joint(const RobotJoint& ball, const Eigen::Matrix3d& frame, std::vector<RobotJoint>& joints) {
  for (int k = 0; k < 3; ++k) {
    RobotJoint turn = ball;
    turn.name += std::string("_") + "xyz"[k];
    turn.kind = JointKind::revolute;
    turn.axis = frame.col(k);
    joints.push_back(turn);
  }
}

void RobotBuilder::add_link(const XmlNode& node, const std::string& name, std::vector<SetPointer> shapes) {
  if (!number_of_link_.emplace(name, static_cast<int>(links_.size())).second)
    node.refuse("a second link '" + name + "'");
  links_.push_back({node, name, std::move(shapes), -1, {}});
}

void RobotBuilder::set_shapes(const std::string& link, std::vector<SetPointer> shapes) {
  links_[static_cast<std::size_t>(number_of_link_.at(link))].shapes = std::move(shapes);
}

void RobotBuilder::hang(RobotHanging hanging) {
  const std::string joint = hanging.joints.empty() ? "" : hanging.joints.front().name;
  const int number = static_cast<int>(hangings_.size());
  for (const std::string& link : {hanging.parent, hanging.child}) {
    if (!link.empty() && number_of_link_.count(link) == 0)
      hanging.node.refuse("joint '" + joint + "': there is no link '" + link + "'");
  }
  for (std::size_t k = 0; k < hanging.joints.size(); ++k) {
    if (!place_of_joint_.emplace(hanging.joints[k].name, std::pair(number, static_cast<int>(k))).second)
      hanging.joints[k].node.refuse("a second joint '" + hanging.joints[k].name + "'");
  }
  Link& child = links_[static_cast<std::size_t>(number_of_link_.at(hanging.child))];
  if (child.above >= 0)
    hanging.node.refuse("link '" + hanging.child + "' hangs on a second joint, '" + joint + "'");
  child.above = number;
  if (!hanging.parent.empty())
    links_[static_cast<std::size_t>(number_of_link_.at(hanging.parent))].below.push_back(number);
  hangings_.push_back(std::move(hanging));
}

const RobotHanging* RobotBuilder::above(const Link& link) const {
  return link.above < 0 ? nullptr : &hangings_[static_cast<std::size_t>(link.above)];
}

std::string RobotBuilder::only_root(const XmlNode& file) const {
  std::string root;
  for (const Link& link : links_) {
    if (link.above >= 0) continue;
    if (!root.empty()) link.node.refuse("two links hang on no joint: '" + root + "' and '" + link.name + "'");
    root = link.name;
  }
  if (root.empty()) file.refuse("every link hangs on a joint: they go round in a circle");
  return root;
}

void RobotBuilder::finish(const XmlNode& file) {
  if (links_.empty()) file.refuse("a robot without a link");
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const RobotHanging* hanging = above(links_[i]);
    if (hanging == nullptr || hanging->parent.empty()) add_tree(static_cast<int>(i));
  }
  if (placed_ < links_.size())
    file.refuse(std::to_string(links_.size() - placed_) + " links hang on joints that go round in a circle");
  bind_joints();
}

/// Links in the order of the tree: each before those that hang on it.
void RobotBuilder::add_tree(int root) {
  std::vector<std::pair<int, int>> next = {{root, -1}};  // a link, and its parent in the tree
  while (!next.empty()) {
    const auto [number, parent] = next.back();
    next.pop_back();
    Link& link = links_[static_cast<std::size_t>(number)];
    const int here = put_link(link, parent);
    for (std::size_t k = link.below.size(); k-- > 0;) {
      const RobotHanging& hanging = hangings_[static_cast<std::size_t>(link.below[k])];
      next.emplace_back(number_of_link_.at(hanging.child), here);
    }
  }
}

int RobotBuilder::put_step(RobotLink link, const TreeLink& step) {
  robot_.links.push_back(std::move(link));
  robot_.tree.links.push_back(step);
  return static_cast<int>(robot_.links.size()) - 1;
}

int RobotBuilder::put_link(Link& link, int parent) {
  ++placed_;
  RobotLink own;
  own.name = link.name;
  own.shapes = std::move(link.shapes);
  TreeLink step{parent, Placement::identity(3)};
  const RobotHanging* hanging = above(link);
  if (hanging == nullptr) return put_step(std::move(own), step);
  step.origin = hanging->origin;
  for (std::size_t k = 0; k < hanging->joints.size(); ++k) {
    const RobotJoint& joint = hanging->joints[k];
    step.origin = step.origin * shift(joint.anchor);
    step.kind = joint.kind;
    if (joint.kind != JointKind::fixed) step.axis = joint.axis.normalized();
    step.scale = joint.scale;
    step.offset = joint.offset;
    RobotLink moved;
    moved.joint = joint.name;
    moved.lower = joint.lower;
    moved.upper = joint.upper;
    if (k + 1 == hanging->joints.size() && joint.anchor.isZero(0)) {
      moved.name = own.name;
      moved.shapes = std::move(own.shapes);
      return put_step(std::move(moved), step);
    }
    moved.name = own.name + "@" + joint.name;
    step = {put_step(std::move(moved), step), shift(-joint.anchor)};
  }
  return put_step(std::move(own), step);
}

// Joints take values in the order of the tree; a mimic takes another's.
void RobotBuilder::bind_joints() {
  const auto joint_named = [&](const std::string& name) -> const RobotJoint& {
    const auto [hanging, place] = place_of_joint_.at(name);
    return hangings_[static_cast<std::size_t>(hanging)].joints[static_cast<std::size_t>(place)];
  };
  std::map<std::string, int> value_of;
  for (const RobotLink& link : robot_.links) {
    if (link.joint.empty()) continue;
    const RobotJoint& joint = joint_named(link.joint);
    if (joint.kind == JointKind::fixed) {
      robot_.without_value[joint.name] = "is fixed";
    } else if (!joint.mimicked.empty()) {
      robot_.without_value[joint.name] = "mimics '" + joint.mimicked + "'";
    } else {
      value_of[joint.name] = static_cast<int>(robot_.joints.size());
      robot_.joints.push_back(joint.name);
    }
  }
  for (std::size_t i = 0; i < robot_.links.size(); ++i) {
    TreeLink& step = robot_.tree.links[i];
    if (step.kind == JointKind::fixed) continue;
    const RobotJoint& source = source_of(joint_named(robot_.links[i].joint), step);
    step.joint = value_of.at(source.name);
  }
}

/// The joint whose value another one takes in the end, over mimics of mimics; `step` gets how.
const RobotJoint& RobotBuilder::source_of(const RobotJoint& mimic, TreeLink& step) const {
  const RobotJoint* joint = &mimic;
  for (std::size_t steps = 0; !joint->mimicked.empty(); ++steps) {
    const std::string what = "joint '" + joint->name + "' mimics '" + joint->mimicked + "'";
    const auto found = place_of_joint_.find(joint->mimicked);
    if (found == place_of_joint_.end()) joint->node.refuse(what + ", and there is no such joint");
    const auto [hanging, place] = found->second;
    const RobotJoint& next =
        hangings_[static_cast<std::size_t>(hanging)].joints[static_cast<std::size_t>(place)];
    if (next.kind == JointKind::fixed) joint->node.refuse(what + ", which is fixed");
    if (steps > place_of_joint_.size()) joint->node.refuse(what + ": mimics that go round in a circle");
    if (joint != &mimic) {
      step.offset += step.scale * joint->offset;
      step.scale *= joint->scale;
    }
    joint = &next;
  }
  return *joint;
}

}  // namespace raygauge::cli
