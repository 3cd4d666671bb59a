// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/input/robot_file.h"

namespace raygauge::cli {

/// Two links that an SRDF file leaves out of all questions about contacts.
struct DisabledPair {
  int link_a = 0, link_b = 0;  ///< of the robot; link_a < link_b
  std::string reason;          ///< "Adjacent", "Never", "Default", ...; may be empty
};

/// Joints of a robot that move together, and links.
struct JointGroup {
  std::string name;
  std::vector<int> links;    ///< rising
  std::vector<bool> joints;  ///< by joint of the robot that takes a value: whether it belongs
  std::map<std::string, std::map<int, double>> states;  ///< values of joints, by the joint's number
};

struct EndEffector {
  std::string name, group, parent_link, parent_group;
};

/// What an SRDF file says of a robot.
struct RobotSemantics {
  std::vector<DisabledPair> disabled;  ///< sorted, each once
  std::vector<JointGroup> groups;
  std::vector<EndEffector> end_effectors;
  std::vector<std::string> unknown;  ///< links that the robot does not have, and what has no effect here

  /// Throws UnknownNameError, `place` standing in front.
  const JointGroup& group(const std::string& name, const std::string& place) const;
};

/// Reads the pairs of links that are disabled (disable_collisions, disable_default_collisions,
/// enable_collisions), groups (links, joints, chains, other groups), group states and end effectors of an
/// SRDF file. A link or a joint that the robot does not have is named in `unknown`. Virtual and passive
/// joints have no effect. Throws InvalidParameterError, naming file and line, for what is not understood.
RobotSemantics read_srdf(const std::string& path, const Robot& robot);

}  // namespace raygauge::cli
