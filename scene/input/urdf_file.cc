// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// URDF: links, and joints that join them.
#include <cstdlib>
#include <string_view>

#include "cli/input/pose_table.h"
#include "raygauge/exceptions.h"
#include "scene/input/robot_builder.h"
#include "scene/input/robot_shapes.h"

namespace raygauge::cli {
namespace {

class UrdfReader {
 public:
  explicit UrdfReader(const RobotSource& source)
      : source_(source), file_(source.file), meshes_(source, robot_), builder_(robot_) {}

  Robot read() {
    refuse_macros();
    const XmlElement& root = file_.root();
    robot_.name = file_.text(root, "name");
    for (const XmlElement* link = root.FirstChildElement("link"); link != nullptr;
         link = link->NextSiblingElement("link"))
      builder_.add_link({&file_, link}, file_.text(*link, "name"), shapes_of(*link));
    if (root.FirstChildElement("link") == nullptr) file_.refuse(root, "a robot without a link");
    for (const XmlElement* joint = root.FirstChildElement("joint"); joint != nullptr;
         joint = joint->NextSiblingElement("joint"))
      builder_.hang(hanging_of(*joint));
    builder_.only_root({&file_, &root});
    builder_.finish({&file_, &root});
    return std::move(robot_);
  }

 private:
  void refuse_macros() const {
    const XmlElement& root = file_.root();
    for (const XmlElement* child = root.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      if (std::string_view(child->Name()).starts_with("xacro:"))
        file_.refuse(*child, std::string("<") + child->Name() +
                                 ">: a xacro file; expand it first, as in: xacro " + source_.path +
                                 " > robot.urdf");
    }
  }

  /// The pose of an <origin> inside the element; none: the identity.
  Placement origin_of(const XmlElement& element) const {
    const XmlElement* origin = element.FirstChildElement("origin");
    if (origin == nullptr) return Placement::identity(3);
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    const Eigen::Vector3d xyz = file_.vector(*origin, "xyz", zero);
    const Eigen::Vector3d rpy = file_.vector(*origin, "rpy", zero);
    return make_placement(rotation_of_rpy(rpy), xyz);
  }

  JointKind kind_of(const XmlElement& joint, const std::string& name) const {
    const std::string type = file_.text(joint, "type");
    if (type == "fixed") return JointKind::fixed;
    if (type == "revolute" || type == "continuous") return JointKind::revolute;
    if (type == "prismatic") return JointKind::prismatic;
    file_.refuse(joint, "joint '" + name + "' is " + type +
                            "; fixed, revolute, continuous and prismatic ones are read");
  }

  RobotHanging hanging_of(const XmlElement& element) const {
    RobotJoint joint;
    joint.node = {&file_, &element};
    joint.name = file_.text(element, "name");
    const auto link_of = [&](const char* role) {
      const XmlElement* link = element.FirstChildElement(role);
      if (link == nullptr) file_.refuse(element, "joint '" + joint.name + "' has no " + role + " link");
      return file_.text(*link, "link");
    };
    RobotHanging hanging{joint.node, link_of("parent"), link_of("child"), Placement::identity(3), {}};
    joint.kind = kind_of(element, joint.name);
    hanging.origin = origin_of(element);
    if (joint.kind != JointKind::fixed) read_movement(element, joint);
    hanging.joints = {joint};
    return hanging;
  }

  void read_movement(const XmlElement& element, RobotJoint& joint) const {
    if (const XmlElement* axis = element.FirstChildElement("axis"))
      joint.axis = file_.vector(*axis, "xyz", joint.axis);
    if (!(joint.axis.norm() > 0)) file_.refuse(element, "joint '" + joint.name + "' has no axis");
    const XmlElement* limit = element.FirstChildElement("limit");
    const bool limited =
        limit != nullptr && (limit->Attribute("lower") != nullptr || limit->Attribute("upper") != nullptr);
    if (limited && file_.text(element, "type") != "continuous") {
      joint.lower = file_.limit(*limit, "lower");
      joint.upper = file_.limit(*limit, "upper");
    }
    if (const XmlElement* mimic = element.FirstChildElement("mimic")) {
      joint.mimicked = file_.text(*mimic, "joint");
      joint.scale = file_.number(*mimic, "multiplier", 1);
      joint.offset = file_.number(*mimic, "offset", 0);
    }
  }

  /// Elements that nobody reads are of other programs, unless one is this word but for a slip.
  void refuse_slip(const XmlElement& link) const {
    const std::string wanted = "collision";
    for (const XmlElement* child = link.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      const std::string name = child->Name();
      const bool alike = std::abs(static_cast<int>(name.size()) - static_cast<int>(wanted.size())) <= 2;
      if (name != wanted && alike && !nearest_name(name, {wanted}).empty())
        file_.refuse(*child,
                     "link '" + file_.text(link, "name") + "': <" + name + ">; did you mean <collision>?");
    }
  }

  std::vector<SetPointer> shapes_of(const XmlElement& link) const {
    refuse_slip(link);
    std::vector<SetPointer> shapes;
    for (const XmlElement* collision = link.FirstChildElement("collision"); collision != nullptr;
         collision = collision->NextSiblingElement("collision")) {
      for (SetPointer& shape : collision_shapes(*collision, file_.text(link, "name")))
        shapes.push_back(std::move(shape));
    }
    return shapes;
  }

  std::vector<SetPointer> collision_shapes(const XmlElement& collision, const std::string& link) const {
    const XmlElement* geometry = collision.FirstChildElement("geometry");
    const XmlElement* shape = geometry == nullptr ? nullptr : geometry->FirstChildElement();
    ShapeSpot spot{{&file_, &collision}, link, {}};
    if (shape == nullptr) spot.refuse("a collision without a shape");
    if (shape->NextSiblingElement() != nullptr) spot.refuse("a collision of more than one shape");
    spot.where = origin_of(collision);
    spot.node.element = shape;
    if (std::string_view(shape->Name()) == "mesh") return mesh_of(spot);
    return {shape_of(spot)};
  }

  SetPointer shape_of(const ShapeSpot& spot) const {
    const XmlElement& shape = *spot.node.element;
    const std::string_view kind = shape.Name();
    if (kind == "sphere") return ball_at(spot, file_.number(shape, "radius"));
    if (kind == "box") {
      file_.text(shape, "size");
      return box_at(spot, file_.vector(shape, "size", Eigen::Vector3d::Zero()) / 2);
    }
    if (kind == "cylinder" || kind == "capsule") {
      // Of a capsule too the length is that of the part between the round ends.
      const double half = file_.number(shape, "length") / 2, radius = file_.number(shape, "radius");
      return kind == "cylinder" ? cylinder_at(spot, half, radius) : capsule_at(spot, half, radius);
    }
    spot.refuse("the collision shape <" + std::string(kind) + "> is not understood");
  }

  std::vector<SetPointer> mesh_of(const ShapeSpot& spot) const {
    const std::string name = spot.node.text("filename");
    const Eigen::Vector3d scale = file_.vector(*spot.node.element, "scale", Eigen::Vector3d::Ones());
    return meshes_.read(spot, name, meshes_.path_of(spot.node, spot.link, name), scale);
  }

  const RobotSource& source_;
  const XmlFile& file_;
  Robot robot_;
  LinkMeshes meshes_;
  RobotBuilder builder_;
};

}  // namespace

Robot urdf_robot(const RobotSource& source) { return UrdfReader(source).read(); }

}  // namespace raygauge::cli
