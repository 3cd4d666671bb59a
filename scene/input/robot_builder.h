// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "cli/input/xml_values.h"
#include "scene/input/robot_file.h"

namespace raygauge::cli {

/// A joint between the link that carries it and the one that moves.
struct RobotJoint {
  XmlNode node;
  std::string name;
  JointKind kind = JointKind::fixed;
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero();  ///< a point of its axis, ...
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();   ///< ... which is not 0, both in the frame that moves
  double lower = -std::numeric_limits<double>::infinity(), upper = std::numeric_limits<double>::infinity();
  std::string mimicked;          ///< "": none
  double scale = 1, offset = 0;  ///< of what it mimics; without a mimic, q = scale * value + offset
};

/// Adds a ball joint as turns about the axes x, y and z of a frame, each carried by the one before: they
/// reach every orientation. They are called after `ball`: NAME_x, NAME_y, NAME_z.
void add_ball_joint(const RobotJoint& ball, const Eigen::Matrix3d& frame, std::vector<RobotJoint>& joints);

/// How a link hangs on another one.
struct RobotHanging {
  XmlNode node;
  std::string parent;              ///< "": the base
  std::string child;               ///< the link
  Placement origin;                ///< of the child in the frame of the parent, all joints at 0
  std::vector<RobotJoint> joints;  ///< one after the other, the parent's first; none: they are one solid
};

/// Puts links and joints of any format in the order of a tree. A joint whose anchor is not the origin of its
/// link makes a link of its own, without shapes, called LINK@JOINT.
class RobotBuilder {
 public:
  /// Links and joints go to `robot`, once all are known.
  explicit RobotBuilder(Robot& robot) : robot_(robot) {}

  /// Throws InvalidParameterError for a second link of that name.
  void add_link(const XmlNode& node, const std::string& name, std::vector<SetPointer> shapes);

  /// Of a link that was added without its shapes.
  void set_shapes(const std::string& link, std::vector<SetPointer> shapes);

  /// Throws InvalidParameterError for a link that is not there, that hangs already, or a joint's second name.
  void hang(RobotHanging hanging);

  /// The link that hangs on no other. Throws InvalidParameterError unless there is one.
  std::string only_root(const XmlNode& file) const;

  /// Fills the robot. Throws InvalidParameterError for links that go round in a circle, and for mimics.
  void finish(const XmlNode& file);

 private:
  struct Link {
    XmlNode node;
    std::string name;
    std::vector<SetPointer> shapes;
    int above = -1;          ///< number of its hanging
    std::vector<int> below;  ///< of those on it
  };

  const RobotHanging* above(const Link& link) const;
  void add_tree(int root);
  int put_link(Link& link, int parent);
  int put_step(RobotLink link, const TreeLink& step);
  void bind_joints();
  const RobotJoint& source_of(const RobotJoint& mimic, TreeLink& step) const;

  Robot& robot_;
  std::vector<Link> links_;
  std::size_t placed_ = 0;  ///< of these, in the tree
  std::vector<RobotHanging> hangings_;
  std::map<std::string, int> number_of_link_;
  std::map<std::string, std::pair<int, int>> place_of_joint_;  ///< hanging, and place in it
};

}  // namespace raygauge::cli
