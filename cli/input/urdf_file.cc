// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/urdf_file.h"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <utility>

#include "cli/input/input_file.h"
#include "cli/input/mesh_file.h"
#include "raygauge/exceptions.h"
#include "raygauge/sets/affine_image.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/cylinder.h"
#include "raygauge/sets/point_set.h"

namespace raygauge::cli {
namespace {

namespace fs = std::filesystem;

/// Keeps what the URDF library complains of, which otherwise goes to standard error.
class KeptMessages final : public console_bridge::OutputHandler {
 public:
  KeptMessages() { console_bridge::useOutputHandler(this); }
  ~KeptMessages() override { console_bridge::restorePreviousOutputHandler(); }

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && first_error.empty()) first_error = text;
  }

  std::string first_error;
};

Placement placement_of(const urdf::Pose& pose) {
  Eigen::Quaterniond q(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z);
  return make_placement(q.normalized().toRotationMatrix(),
                        Eigen::Vector3d(pose.position.x, pose.position.y, pose.position.z));
}

class UrdfReader {
 public:
  UrdfReader(std::string path, const std::map<std::string, std::string>& packages)
      : path_(std::move(path)), packages_(packages) {}

  Robot read() {
    const std::string text = read_input(path_);
    urdf::ModelInterfaceSharedPtr model;
    {
      KeptMessages messages;
      model = urdf::parseURDF(text);
      if (model == nullptr || model->getRoot() == nullptr || !messages.first_error.empty()) {
        refuse(messages.first_error.empty() ? "not a URDF file" : messages.first_error);
      }
    }
    robot_.name = model->getName();
    add(*model->getRoot(), -1, nullptr);
    bind_joints();
    return std::move(robot_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw InvalidParameterError(path_ + ": " + what);
  }

  void add(const urdf::Link& link, int parent, const urdf::Joint* joint) {
    const int number = static_cast<int>(robot_.tree.links.size());
    robot_.tree.links.push_back(joint == nullptr ? TreeLink{-1, Placement::identity(3)}
                                                 : tree_link(*joint, parent));
    joints_.push_back(joint);
    if (parent >= 0) robot_.joined.emplace_back(parent, number);
    robot_.links.push_back({link.name, shapes_of(link)});
    for (const urdf::LinkSharedPtr& child : link.child_links) add(*child, number, child->parent_joint.get());
  }

  TreeLink tree_link(const urdf::Joint& joint, int parent) const {
    TreeLink link{parent, placement_of(joint.parent_to_joint_origin_transform)};
    if (joint.type == urdf::Joint::FIXED) return link;
    if (joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS) {
      link.kind = JointKind::revolute;
    } else if (joint.type == urdf::Joint::PRISMATIC) {
      link.kind = JointKind::prismatic;
    } else {
      refuse("joint '" + joint.name + "' is neither fixed, revolute, continuous nor prismatic");
    }
    link.axis = {joint.axis.x, joint.axis.y, joint.axis.z};
    if (!(link.axis.norm() > 0)) refuse("joint '" + joint.name + "' has no axis");
    link.axis.normalize();
    return link;
  }

  // Joints take values in the order of the file's tree; a mimic takes another's.
  void bind_joints() {
    std::map<std::string, int> number;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const urdf::Joint* joint = joints_[i];
      if (joint == nullptr || joint->type == urdf::Joint::FIXED || joint->mimic != nullptr) continue;
      number[joint->name] = static_cast<int>(robot_.joints.size());
      robot_.tree.links[i].joint = number[joint->name];
      robot_.joints.push_back(joint->name);
    }
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const urdf::Joint* joint = joints_[i];
      if (joint == nullptr || joint->mimic == nullptr || joint->type == urdf::Joint::FIXED) continue;
      const auto found = number.find(joint->mimic->joint_name);
      if (found == number.end()) {
        refuse("joint '" + joint->name + "' mimics '" + joint->mimic->joint_name + "', which takes no value");
      }
      robot_.tree.links[i].joint = found->second;
      robot_.tree.links[i].scale = joint->mimic->multiplier;
      robot_.tree.links[i].offset = joint->mimic->offset;
    }
  }

  std::vector<SetPointer> shapes_of(const urdf::Link& link) const {
    std::vector<SetPointer> shapes;
    std::vector<urdf::CollisionSharedPtr> collisions = link.collision_array;
    if (collisions.empty() && link.collision != nullptr) collisions.push_back(link.collision);
    for (const urdf::CollisionSharedPtr& collision : collisions) {
      if (collision->geometry == nullptr) refuse("link '" + link.name + "': a collision without a shape");
      const Placement where = placement_of(collision->origin);
      shapes.push_back(AffineImage::rigid(shape_of(*collision->geometry, link.name), where.R, where.t));
    }
    return shapes;
  }

  SetPointer shape_of(const urdf::Geometry& geometry, const std::string& link) const {
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    if (geometry.type == urdf::Geometry::SPHERE) {
      return std::make_shared<Ball>(zero, static_cast<const urdf::Sphere&>(geometry).radius);
    }
    if (geometry.type == urdf::Geometry::BOX) {
      const urdf::Vector3& size = static_cast<const urdf::Box&>(geometry).dim;
      const Eigen::Vector3d half(size.x / 2, size.y / 2, size.z / 2);
      return std::make_shared<Box>(-half, half);
    }
    if (geometry.type == urdf::Geometry::CYLINDER) {
      const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
      const Eigen::Vector3d half(0, 0, cylinder.length / 2);
      return std::make_shared<Cylinder>(-half, half, cylinder.radius);
    }
    if (geometry.type != urdf::Geometry::MESH)
      refuse("link '" + link + "': a collision shape that is not understood");
    const auto& mesh = static_cast<const urdf::Mesh&>(geometry);
    Eigen::MatrixXd vertices;
    try {
      vertices = read_mesh_vertices(mesh_path(mesh.filename, link));
    } catch (const Error& error) {
      refuse("link '" + link + "': " + error.what());
    }
    const Eigen::Vector3d scale(mesh.scale.x, mesh.scale.y, mesh.scale.z);
    return std::make_shared<PointSet>(scale.asDiagonal() * vertices);
  }

  std::string mesh_path(const std::string& name, const std::string& link) const {
    constexpr std::string_view kPackage = "package://";
    constexpr std::string_view kFile = "file://";
    if (name.starts_with(kFile)) return name.substr(kFile.size());
    if (!name.starts_with(kPackage)) return (fs::path(path_).parent_path() / name).string();
    const std::string rest = name.substr(kPackage.size());
    const std::string package = rest.substr(0, rest.find('/'));
    const auto folder = packages_.find(package);
    if (folder == packages_.end()) {
      refuse("link '" + link + "': the folder of package '" + package + "' is not known; say --package " +
             package + "=FOLDER");
    }
    return (fs::path(folder->second) / rest.substr(std::min(rest.size(), package.size() + 1))).string();
  }

  std::string path_;
  const std::map<std::string, std::string>& packages_;
  Robot robot_;
  std::vector<const urdf::Joint*> joints_;
};

}  // namespace

Robot read_urdf(const std::string& path, const std::map<std::string, std::string>& packages) {
  return UrdfReader(path, packages).read();
}

}  // namespace raygauge::cli
