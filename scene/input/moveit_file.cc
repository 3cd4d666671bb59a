// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/input/moveit_file.h"

#include <yaml-cpp/yaml.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>

#include "cli/input/input_file.h"
#include "raygauge/exceptions.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::cli {
namespace {

using Set = std::shared_ptr<const ConvexSet>;

/// A message, and refusals that name its lines.
class Message {
 public:
  explicit Message(const std::string& path) : path_(path) {
    try {
      root_ = YAML::Load(read_text_input(path));
    } catch (const YAML::Exception& error) {
      throw InvalidParameterError(path + ":" + std::to_string(error.mark.line + 1) +
                                  ": not YAML that can be read: " + error.msg);
    }
    if (!root_.IsMap()) refuse(root_, "a message of MoveIt has keys");
  }

  const YAML::Node& root() const { return root_; }

  [[noreturn]] void refuse(const YAML::Node& node, const std::string& what) const {
    const int line = node.IsDefined() ? node.Mark().line + 1 : 1;
    throw InvalidParameterError(path_ + ":" + std::to_string(line) + ": " + what);
  }

  YAML::Node need(const YAML::Node& node, const char* key) const {
    if (!node.IsMap() || !node[key]) refuse(node, std::string("there is no ") + key);
    return node[key];
  }

  std::string text(const YAML::Node& node) const {
    if (!node.IsScalar()) refuse(node, "a word must stand here");
    return node.Scalar();
  }

  double number(const YAML::Node& node) const {
    double value = 0;
    if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value))
      refuse(node, "a finite number must stand here");
    return value;
  }

  /// A list of so many numbers, or a map with these keys.
  std::vector<double> numbers(const YAML::Node& node, const std::string& keys) const {
    std::vector<double> values;
    if (node.IsMap()) {
      for (const char key : keys) values.push_back(number(need(node, std::string(1, key).c_str())));
      return values;
    }
    for (const YAML::Node& value : list(node)) values.push_back(number(value));
    if (values.size() != keys.size()) refuse(node, std::to_string(keys.size()) + " numbers must stand here");
    return values;
  }

  /// By value: a loop over it keeps a node that is found in passing.
  YAML::Node list(const YAML::Node& node) const {
    if (!node.IsSequence()) refuse(node, "a list must stand here");
    return node;
  }

  /// Nothing may stand under this key.
  void reject(const YAML::Node& node, const char* key) const {
    if (node.IsScalar() || node.IsSequence()) refuse(node, "keys must stand here");
    if (node[key] && node[key].size() > 0) refuse(node[key], std::string(key) + " are not understood");
  }

 private:
  std::string path_;
  YAML::Node root_;
};

class ObstacleReader {
 public:
  explicit ObstacleReader(const Message& message) : message_(message) {}

  Body read(const YAML::Node& object) const {
    const std::string name = message_.text(message_.need(object, "id"));
    message_.reject(object, "planes");
    Placement frame = Placement::identity(3);
    if (object["pose"]) frame = pose(object["pose"]);
    std::vector<Set> parts;
    for (const char* kind : {"primitives", "meshes"}) {
      if (!object[kind]) continue;
      const bool mesh = std::string(kind) == "meshes";
      const YAML::Node poses = message_.need(object, mesh ? "mesh_poses" : "primitive_poses");
      if (message_.list(object[kind]).size() != message_.list(poses).size())
        message_.refuse(object[kind], "there must be a pose for each of the " + std::string(kind));
      for (std::size_t i = 0; i < poses.size(); ++i) {
        const Placement where = frame * pose(poses[i]);
        parts.push_back(mesh ? mesh_of(object[kind][i], where) : primitive(object[kind][i], where));
      }
    }
    try {
      return make_body(name, parts, std::make_shared<StaticMotion>(Placement::identity(3)));
    } catch (const Error& error) {
      message_.refuse(object, "object '" + name + "': " + error.what());
    }
  }

 private:
  Placement pose(const YAML::Node& node) const {
    const std::vector<double> p = message_.numbers(message_.need(node, "position"), "xyz");
    const std::vector<double> q = message_.numbers(message_.need(node, "orientation"), "xyzw");
    const Eigen::Quaterniond turn(q[3], q[0], q[1], q[2]);
    if (!(std::fabs(turn.norm() - 1) <= 1e-3)) message_.refuse(node, "a quaternion must have the length 1");
    return make_placement(turn.normalized().toRotationMatrix(), Vector(Eigen::Vector3d(p[0], p[1], p[2])));
  }

  static Set points(const Eigen::MatrixXd& own, const Placement& where) {
    return std::make_shared<PointSet>((where.R * own).colwise() + Vector(where.t));
  }

  Set primitive(const YAML::Node& node, const Placement& where) const {
    const YAML::Node type = message_.need(node, "type"), sizes = message_.need(node, "dimensions");
    const std::string kind = message_.text(type);
    const bool box = kind == "box" || kind == "1", ball = kind == "sphere" || kind == "2";
    if (!box && !ball && kind != "cylinder" && kind != "3")
      message_.refuse(type, "the primitive '" + kind + "' is not understood");
    const std::vector<double> d = message_.numbers(sizes, box ? "xyz" : (ball ? "r" : "hr"));
    try {
      if (ball) return std::make_shared<Ball>(Vector(where.t), d[0]);
      if (!box) {
        const Vector half = Vector(where.R.col(2)) * (d[0] / 2);
        return std::make_shared<Cylinder>(Vector(where.t) - half, Vector(where.t) + half, d[1]);
      }
      const Eigen::Vector3d half = Eigen::Vector3d(d[0], d[1], d[2]) / 2;
      if (!(half.minCoeff() >= 0)) message_.refuse(sizes, "a box must not have a negative side");
      Eigen::MatrixXd corners(3, 8);
      for (Eigen::Index i = 0; i < 8; ++i)
        for (Eigen::Index k = 0; k < 3; ++k) corners(k, i) = (i >> k & 1) != 0 ? half[k] : -half[k];
      return points(corners, where);
    } catch (const Error& error) {
      message_.refuse(node, error.what());
    }
  }

  Set mesh_of(const YAML::Node& node, const Placement& where) const {
    const YAML::Node vertices = message_.list(message_.need(node, "vertices"));
    if (vertices.size() == 0) message_.refuse(vertices, "a mesh without a vertex");
    Eigen::MatrixXd own(3, static_cast<Eigen::Index>(vertices.size()));
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const std::vector<double> p = message_.numbers(vertices[i], "xyz");
      own.col(static_cast<Eigen::Index>(i)) = Eigen::Vector3d(p[0], p[1], p[2]);
    }
    return points(own, where);
  }

  const Message& message_;
};

void take_matrix(const Message& message, const YAML::Node& matrix, MoveItScene& scene) {
  const YAML::Node names = message.list(message.need(matrix, "entry_names"));
  const YAML::Node rows = message.list(message.need(matrix, "entry_values"));
  if (rows.size() != names.size()) message.refuse(rows, "the collision matrix must have a row for each name");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    YAML::Node row = rows[i];
    if (row.IsMap()) row = message.need(row, "enabled");
    if (message.list(row).size() != names.size())
      message.refuse(row, "a row of the collision matrix must have an entry for each name");
    for (std::size_t k = i + 1; k < names.size(); ++k) {
      bool allowed = false;
      if (!YAML::convert<bool>::decode(row[k], allowed))
        message.refuse(row[k], "true or false must stand here");
      if (allowed) scene.allowed.emplace_back(message.text(names[i]), message.text(names[k]));
    }
  }
}

}  // namespace

MoveItScene read_moveit_scene(const std::string& path) {
  const Message message(path);
  MoveItScene scene;
  const YAML::Node world = message.need(message.root(), "world");
  message.reject(world, "octomap");
  if (const YAML::Node state = message.root()["robot_state"])
    message.reject(state, "attached_collision_objects");
  if (const YAML::Node objects = world["collision_objects"]) {
    for (const YAML::Node& object : message.list(objects))
      scene.obstacles.push_back(ObstacleReader(message).read(object));
  }
  if (const YAML::Node matrix = message.root()["allowed_collision_matrix"])
    take_matrix(message, matrix, scene);
  return scene;
}

MoveItRequest read_moveit_request(const std::string& path) {
  const Message message(path);
  MoveItRequest request;
  request.group = message.text(message.need(message.root(), "group_name"));
  const YAML::Node state = message.need(message.need(message.root(), "start_state"), "joint_state");
  const YAML::Node names = message.list(message.need(state, "name"));
  const YAML::Node values = message.list(message.need(state, "position"));
  if (names.size() != values.size()) message.refuse(values, "there must be a position for each joint");
  for (std::size_t i = 0; i < names.size(); ++i)
    request.start[message.text(names[i])] = message.number(values[i]);
  const YAML::Node goals = message.list(message.need(message.root(), "goal_constraints"));
  if (goals.size() != 1) message.refuse(goals, "a request must have one goal");
  for (const char* kind : {"position_constraints", "orientation_constraints", "visibility_constraints"})
    message.reject(goals[0], kind);
  for (const YAML::Node& joint : message.list(message.need(goals[0], "joint_constraints")))
    request.goal[message.text(message.need(joint, "joint_name"))] =
        message.number(message.need(joint, "position"));
  return request;
}

}  // namespace raygauge::cli
