// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/input/urdf_file.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "cli/input/input_file.h"
#include "cli/input/xml_values.h"
#include "raygauge/exceptions.h"
#include "scene/input/urdf_shapes.h"

namespace raygauge::cli {
namespace {

/// A <joint>, and what it joins.
struct Joint {
  const XmlElement* element = nullptr;
  std::string name, parent, child;
  TreeLink link;
  std::string mimicked;  ///< "": none
  double lower = -std::numeric_limits<double>::infinity(), upper = std::numeric_limits<double>::infinity();
};

JointKind kind_of(const XmlFile& file, const XmlElement& joint, const std::string& name) {
  const std::string type = file.text(joint, "type");
  if (type == "fixed") return JointKind::fixed;
  if (type == "revolute" || type == "continuous") return JointKind::revolute;
  if (type == "prismatic") return JointKind::prismatic;
  file.refuse(
      joint, "joint '" + name + "' is " + type + "; fixed, revolute, continuous and prismatic ones are read");
}

Joint joint_of(const XmlFile& file, const XmlElement& element) {
  Joint joint;
  joint.element = &element;
  joint.name = file.text(element, "name");
  const auto link_of = [&](const char* role) {
    const XmlElement* link = element.FirstChildElement(role);
    if (link == nullptr) file.refuse(element, "joint '" + joint.name + "' has no " + role + " link");
    return file.text(*link, "link");
  };
  joint.parent = link_of("parent");
  joint.child = link_of("child");
  joint.link.kind = kind_of(file, element, joint.name);
  joint.link.origin = urdf_origin(file, element);
  if (joint.link.kind == JointKind::fixed) return joint;
  if (const XmlElement* axis = element.FirstChildElement("axis"))
    joint.link.axis = file.vector(*axis, "xyz", joint.link.axis);
  if (!(joint.link.axis.norm() > 0)) file.refuse(element, "joint '" + joint.name + "' has no axis");
  joint.link.axis.normalize();
  const XmlElement* limit = element.FirstChildElement("limit");
  const bool limited =
      limit != nullptr && (limit->Attribute("lower") != nullptr || limit->Attribute("upper") != nullptr);
  if (limited && file.text(element, "type") != "continuous") {
    joint.lower = file.limit(*limit, "lower");
    joint.upper = file.limit(*limit, "upper");
  }
  if (const XmlElement* mimic = element.FirstChildElement("mimic")) {
    joint.mimicked = file.text(*mimic, "joint");
    joint.link.scale = file.number(*mimic, "multiplier", 1);
    joint.link.offset = file.number(*mimic, "offset", 0);
  }
  return joint;
}

class UrdfReader {
 public:
  UrdfReader(const std::string& path, const RobotMeshes& meshes)
      : path_(path), meshes_(meshes), file_(read_text_input(path), path) {}

  Robot read() {
    check_language();
    const XmlElement& root = file_.root();
    robot_.name = file_.text(root, "name");
    for (const XmlElement* link = root.FirstChildElement("link"); link != nullptr;
         link = link->NextSiblingElement("link")) {
      if (!links_.emplace(file_.text(*link, "name"), link).second)
        file_.refuse(*link, "a second link '" + file_.text(*link, "name") + "'");
      if (first_link_ == nullptr) first_link_ = link;
    }
    if (first_link_ == nullptr) file_.refuse(root, "a robot without a link");
    for (const XmlElement* joint = root.FirstChildElement("joint"); joint != nullptr;
         joint = joint->NextSiblingElement("joint")) {
      take_joint(joint_of(file_, *joint));
    }
    add_links();
    bind_joints();
    return std::move(robot_);
  }

 private:
  void check_language() const {
    const XmlElement& root = file_.root();
    if (std::string_view(root.Name()) != "robot")
      file_.refuse(root, std::string("not a URDF file: its root is <") + root.Name() + ">, not <robot>");
    for (const XmlElement* child = root.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      if (std::string_view(child->Name()).starts_with("xacro:"))
        file_.refuse(*child, std::string("<") + child->Name() +
                                 ">: a xacro file; expand it first, as in: xacro " + path_ + " > robot.urdf");
    }
  }

  void take_joint(Joint joint) {
    const XmlElement& element = *joint.element;
    for (const std::string& link : {joint.parent, joint.child}) {
      if (links_.count(link) == 0)
        file_.refuse(element, "joint '" + joint.name + "': there is no link '" + link + "'");
    }
    if (!number_of_joint_.emplace(joint.name, static_cast<int>(joints_.size())).second)
      file_.refuse(element, "a second joint '" + joint.name + "'");
    if (!joint_above_.emplace(joint.child, static_cast<int>(joints_.size())).second)
      file_.refuse(element, "link '" + joint.child + "' hangs on a second joint, '" + joint.name + "'");
    joints_below_[joint.parent].push_back(static_cast<int>(joints_.size()));
    joints_.push_back(std::move(joint));
  }

  std::string root_link() const {
    std::string root;
    for (const XmlElement* link = first_link_; link != nullptr; link = link->NextSiblingElement("link")) {
      const std::string name = file_.text(*link, "name");
      if (joint_above_.count(name) != 0) continue;
      if (!root.empty()) file_.refuse(*link, "two links hang on no joint: '" + root + "' and '" + name + "'");
      root = name;
    }
    if (root.empty()) file_.refuse(file_.root(), "every link hangs on a joint: they go round in a circle");
    return root;
  }

  /// Links in the order of the tree: each before those that hang on it.
  void add_links() {
    struct Next {
      std::string link;
      int parent, joint;
    };
    std::vector<Next> next = {{root_link(), -1, -1}};
    while (!next.empty()) {
      const Next here = std::move(next.back());
      next.pop_back();
      add_link(here.link, here.parent, here.joint);
      const std::vector<int>& below = joints_below_[here.link];
      const int number = static_cast<int>(robot_.links.size()) - 1;
      for (std::size_t k = below.size(); k-- > 0;)
        next.push_back({joints_[static_cast<std::size_t>(below[k])].child, number, below[k]});
    }
    if (robot_.links.size() == links_.size()) return;
    file_.refuse(file_.root(), std::to_string(links_.size() - robot_.links.size()) +
                                   " links hang on joints that go round in a circle");
  }

  void add_link(const std::string& name, int parent, int joint) {
    RobotLink link;
    link.name = name;
    link.shapes = urdf_shapes(file_, *links_.at(name), path_, meshes_, robot_);
    TreeLink step{-1, Placement::identity(3)};
    if (joint >= 0) {
      const Joint& above = joints_[static_cast<std::size_t>(joint)];
      link.joint = above.name;
      link.lower = above.lower;
      link.upper = above.upper;
      step = above.link;
      step.parent = parent;
    }
    robot_.links.push_back(std::move(link));
    robot_.tree.links.push_back(step);
  }

  // Joints take values in the order of the tree; a mimic takes another's.
  void bind_joints() {
    std::map<std::string, int> value_of;
    for (const RobotLink& link : robot_.links) {
      if (link.joint.empty()) continue;
      const Joint& joint = joint_named(link.joint);
      if (joint.link.kind == JointKind::fixed) {
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
      const Joint& source = source_of(joint_named(robot_.links[i].joint), step);
      step.joint = value_of.at(source.name);
    }
  }

  const Joint& joint_named(const std::string& name) const {
    return joints_[static_cast<std::size_t>(number_of_joint_.at(name))];
  }

  /// The joint whose value another one takes in the end, over mimics of mimics; `step` gets how.
  const Joint& source_of(const Joint& mimic, TreeLink& step) const {
    const Joint* joint = &mimic;
    for (std::size_t steps = 0; !joint->mimicked.empty(); ++steps) {
      const std::string what = "joint '" + joint->name + "' mimics '" + joint->mimicked + "'";
      const auto found = number_of_joint_.find(joint->mimicked);
      if (found == number_of_joint_.end())
        file_.refuse(*joint->element, what + ", and there is no such joint");
      const Joint& next = joints_[static_cast<std::size_t>(found->second)];
      if (next.link.kind == JointKind::fixed) file_.refuse(*joint->element, what + ", which is fixed");
      if (steps > joints_.size()) file_.refuse(*joint->element, what + ": mimics that go round in a circle");
      if (joint != &mimic) {
        step.offset += step.scale * joint->link.offset;
        step.scale *= joint->link.scale;
      }
      joint = &next;
    }
    return *joint;
  }

  const std::string& path_;
  const RobotMeshes& meshes_;
  XmlFile file_;
  Robot robot_;
  const XmlElement* first_link_ = nullptr;
  std::map<std::string, const XmlElement*> links_;
  std::vector<Joint> joints_;
  std::map<std::string, int> number_of_joint_, joint_above_;
  std::map<std::string, std::vector<int>> joints_below_;
};

}  // namespace

Robot read_urdf(const std::string& path, const RobotMeshes& meshes) {
  return UrdfReader(path, meshes).read();
}

void check_has_meshes(const Robot& robot, const std::string& what) {
  if (robot.meshes == 0 && robot.skipped.empty())
    throw InvalidParameterError(what + " says how meshes are taken, and robot '" + robot.name + "' has none");
}

std::vector<JointLimits> limits_of(const Robot& robot) {
  std::vector<JointLimits> limits(robot.joints.size());
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const TreeLink& step = robot.tree.links[i];
    if (step.kind == JointKind::fixed) continue;
    JointLimits& of = limits[static_cast<std::size_t>(step.joint)];
    if (step.kind == JointKind::revolute) of.turns = true;
    if (step.scale == 0) continue;
    const double one = (robot.links[i].lower - step.offset) / step.scale;
    const double other = (robot.links[i].upper - step.offset) / step.scale;
    of.lower = std::max(of.lower, std::min(one, other));
    of.upper = std::min(of.upper, std::max(one, other));
  }
  return limits;
}

JointLimits planning_limits(const JointLimits& limits, double start, double goal) {
  JointLimits range = limits;
  if (!range.turns) return range;
  if (!std::isfinite(range.lower)) range.lower = std::min(start, goal) - EIGEN_PI;
  if (!std::isfinite(range.upper)) range.upper = std::max(start, goal) + EIGEN_PI;
  return range;
}

}  // namespace raygauge::cli
