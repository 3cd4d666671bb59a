// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// SDF, as far as models, links, joints, frames and collision shapes go.
#include <cmath>
#include <deque>
#include <filesystem>
#include <optional>
#include <set>
#include <string_view>

#include "cli/input/input_file.h"
#include "raygauge/exceptions.h"
#include "scene/input/robot_builder.h"
#include "scene/input/robot_shapes.h"
#include "scene/input/sdf_frames.h"

namespace raygauge::cli {
namespace {

/// More models that include one another than a world has use for.
constexpr std::size_t kMostIncludes = 1000;

/// A limit as large as this is none, as SDF has it.
constexpr double kNoLimit = 1e16;

/// A model: what names in it begin with, and its own frame.
struct Scope {
  std::string prefix, frame;

  /// The full name of a frame; `usual` for "".
  std::string full(const std::string& name, const std::string& usual) const {
    if (name.empty()) return usual;
    if (name == "world") return "";
    return name == "__model__" ? frame : prefix + name;
  }
};

/// A link, a joint or an include, of which file and in which model.
struct Member {
  const RobotSource* source;
  XmlNode node;
  Scope scope;

  std::string name() const { return scope.prefix + node.text("name"); }
};

/// Where `inner` is as seen from `outer`.
Placement seen_from(const Placement& outer, const Placement& inner) {
  Placement seen = inner;
  seen.R = outer.R.transpose() * inner.R;
  seen.t = outer.R.transpose() * (inner.t - outer.t);
  return make_placement(seen.R, seen.t);
}

class SdfReader {
 public:
  explicit SdfReader(const RobotSource& source) : source_(source), builder_(robot_) {}

  Robot read() {
    const XmlNode root{&source_.file, &source_.file.root()};
    const XmlElement* world = sdf_child(root, "world");
    const XmlElement* model = sdf_child(root, "model");
    if ((world == nullptr) == (model == nullptr)) root.refuse("an SDF file needs one model or one world");
    const XmlNode top{&source_.file, world == nullptr ? model : world};
    if (top.element->NextSiblingElement(top.element->Name()) != nullptr)
      root.refuse("an SDF file needs one model or one world, this has several");
    robot_.name = top.text("name");
    if (world == nullptr)
      read_model({&source_, top, {"", "__model__"}}, "", sdf_pose(top));
    else
      read_members({&source_, top, {"", ""}});
    for (const Member& link : links_) builder_.add_link(link.node, link.name(), {});
    for (const Member& joint : joints_) hang(joint);
    for (const Member& link : links_) take_link(link);
    builder_.finish(root);
    return std::move(robot_);
  }

 private:
  /// The model of `member`, whose scope is the model's own, with its pose relative to a frame. For joints its
  /// frame stands for its canonical link: the one that it names, or else its first.
  void read_model(const Member& member, const std::string& relative_to, const Placement& pose) {
    frames_.add(member.node, member.scope.frame, relative_to, pose);
    const std::size_t first = links_.size();
    read_members(member);
    const char* canonical = member.node.element->Attribute("canonical_link");
    if (canonical != nullptr && *canonical != '\0')
      attached_to_[member.scope.frame] = member.scope.full(canonical, "");
    else if (links_.size() > first)
      attached_to_[member.scope.frame] = links_[first].name();
  }

  void read_members(const Member& model) {
    for (const XmlElement* child = model.node.element->FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement())
      read_member({model.source, {model.node.file, child}, model.scope});
  }

  void read_member(const Member& member) {
    const auto& [source, node, scope] = member;
    const std::string_view kind = node.element->Name();
    const std::string relative_to = sdf_relative_to(node);
    if (kind == "link") {
      frames_.add(node, member.name(), scope.full(relative_to, scope.frame), sdf_pose(node));
      link_names_.insert(member.name());
      links_.push_back(member);
    } else if (kind == "joint") {
      const std::string child = scope.full(sdf_text(node, "child", ""), scope.frame);
      frames_.add(node, member.name(), scope.full(relative_to, child), sdf_pose(node));
      joints_.push_back(member);
    } else if (kind == "frame") {
      const char* attached = node.element->Attribute("attached_to");
      const std::string to = scope.full(attached == nullptr ? "" : attached, scope.frame);
      frames_.add(node, member.name(), scope.full(relative_to, to), sdf_pose(node));
      attached_to_[member.name()] = to;
    } else if (kind == "model") {
      read_model({source, node, {member.name() + "::", member.name()}}, scope.full(relative_to, scope.frame),
                 sdf_pose(node));
    } else if (kind == "include") {
      read_include(member);
    } else if (kind == "actor" || kind == "population" || kind == "road") {
      robot_.left_out.push_back("<" + std::string(kind) + ">");
    }
  }

  /// The model of another file: a folder with model.sdf, or a file.
  void read_include(const Member& member) {
    const auto& [source, node, scope] = member;
    if (included_.size() >= kMostIncludes) node.refuse("files that include themselves, or too many");
    for (const char* key : {"placement_frame", "experimental:params"}) {
      if (sdf_child(node, key) != nullptr) node.refuse("<" + std::string(key) + "> is not read");
    }
    if (node.element->BoolAttribute("merge", false)) node.refuse("merge = true is not read");
    const std::string uri = sdf_text(node, "uri", "");
    std::filesystem::path path = LinkMeshes(*source, robot_).path_of(node, uri, uri);
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) path /= "model.sdf";
    if (!std::filesystem::exists(path, ignored)) {
      if (!source_.meshes.skip_missing) node.refuse("there is no model " + path.string());
      robot_.skipped.push_back(uri);
      return;
    }
    const RobotSource& inner = include(path.string());
    const XmlNode model{&inner.file, inner.file.root().FirstChildElement("model")};
    if (model.element == nullptr) node.refuse(path.string() + " has no model");
    const std::string name = scope.prefix + sdf_text(node, "name", model.text("name"));
    const XmlNode& placed = sdf_child(node, "pose") == nullptr ? model : node;
    read_model({&inner, model, {name + "::", name}}, scope.full(sdf_relative_to(placed), scope.frame),
               sdf_pose(placed));
  }

  const RobotSource& include(const std::string& path) {
    const std::string& kept = paths_.emplace_back(path);
    const XmlFile& file = files_.emplace_back(read_text_input(path), path);
    return included_.emplace_back(RobotSource{kept, source_.meshes, file});
  }

  /// The full name of the link that a frame is fixed to; "" is the world.
  std::string link_of(const Member& joint, const char* role) const {
    const std::string given = sdf_text(joint.node, role, "");
    if (given.empty()) joint.node.refuse("joint '" + joint.name() + "' has no " + role + " link");
    std::string name = joint.scope.full(given, "");
    for (std::size_t steps = 0; !name.empty() && link_names_.count(name) == 0; ++steps) {
      const auto found = attached_to_.find(name);
      if (found == attached_to_.end() || steps > attached_to_.size())
        joint.node.refuse("joint '" + joint.name() + "': there is no link '" + given + "'");
      name = found->second;
    }
    return name;
  }

  void hang(const Member& member) {
    const XmlNode& node = member.node;
    RobotHanging hanging{node, link_of(member, "parent"), link_of(member, "child"), {}, {}};
    if (hanging.child.empty()) node.refuse("joint '" + member.name() + "': its child is the world");
    const Placement child = frames_.in_world(node, hanging.child);
    hanging.origin = seen_from(frames_.in_world(node, hanging.parent), child);
    const Placement here = seen_from(child, frames_.in_world(node, member.name()));
    RobotJoint joint;
    joint.node = node;
    joint.name = member.name();
    joint.anchor = here.t;
    const std::string type = node.text("type");
    if (type == "fixed") {
      joint.anchor.setZero();
      hanging.joints = {joint};
    } else if (type == "ball") {
      add_ball_joint(joint, here.R, hanging.joints);
    } else if (type == "revolute2" || type == "universal") {
      hanging.joints = {moving(member, "axis", child, here, joint),
                        moving(member, "axis2", child, here, joint)};
      hanging.joints.back().name += "_2";
    } else if (type == "revolute" || type == "continuous" || type == "prismatic") {
      hanging.joints = {moving(member, "axis", child, here, joint)};
    } else {
      node.refuse("joint '" + member.name() + "' is " + type + ", which is not read");
    }
    hangs_.insert(hanging.child);
    builder_.hang(std::move(hanging));
  }

  RobotJoint moving(const Member& member, const char* name, const Placement& child, const Placement& here,
                    RobotJoint joint) const {
    const XmlElement* element = sdf_child(member.node, name);
    if (element == nullptr) member.node.refuse("joint '" + member.name() + "' has no <" + name + ">");
    const XmlNode axis{member.node.file, element};
    const std::string type = member.node.text("type");
    joint.kind = type == "prismatic" ? JointKind::prismatic : JointKind::revolute;
    if (joint.kind == JointKind::prismatic) joint.anchor.setZero();
    const Eigen::Vector3d xyz = sdf_vector(axis, "xyz", Eigen::Vector3d::UnitZ());
    if (!(xyz.norm() > 0)) axis.refuse("joint '" + member.name() + "' has no axis");
    const std::optional<std::string> frame = frame_of_axis(member, axis);
    joint.axis = frame ? Eigen::Vector3d(child.R.transpose() * (frames_.in_world(axis, *frame).R * xyz))
                       : Eigen::Vector3d(here.R * xyz);
    if (type != "continuous") read_limits(axis, joint);
    if (const XmlElement* mimic = element->FirstChildElement("mimic"))
      read_mimic({axis.file, mimic}, member.scope, joint);
    return joint;
  }

  /// The frame that the numbers of an axis are in; none: that of the joint.
  static std::optional<std::string> frame_of_axis(const Member& member, const XmlNode& axis) {
    const char* frame =
        sdf_child(axis, "xyz") == nullptr ? nullptr : sdf_child(axis, "xyz")->Attribute("expressed_in");
    if (frame != nullptr && *frame != '\0') return member.scope.full(frame, "");
    const bool old = member.source->file.root().DoubleAttribute("version", 2) < 1.45;  // up to 1.4
    const std::string in_model = sdf_text(axis, "use_parent_model_frame", old ? "1" : "0");
    if (in_model == "1" || in_model == "true") return member.scope.frame;
    return std::nullopt;
  }

  static void read_limits(const XmlNode& axis, RobotJoint& joint) {
    const XmlElement* limit = sdf_child(axis, "limit");
    if (limit == nullptr) return;
    const double lower = sdf_number({axis.file, limit}, "lower", -kNoLimit);
    const double upper = sdf_number({axis.file, limit}, "upper", kNoLimit);
    if (lower > -kNoLimit) joint.lower = lower;
    if (upper < kNoLimit) joint.upper = upper;
  }

  /// q = multiplier (leader - reference) + offset.
  static void read_mimic(const XmlNode& mimic, const Scope& scope, RobotJoint& joint) {
    const char* axis = mimic.element->Attribute("axis");
    const bool second = axis != nullptr && std::string_view(axis) == "axis2";
    joint.mimicked = scope.prefix + mimic.text("joint") + (second ? "_2" : "");
    joint.scale = sdf_number(mimic, "multiplier", 1);
    joint.offset = sdf_number(mimic, "offset", 0) - joint.scale * sdf_number(mimic, "reference", 0);
  }

  /// The shapes of a link; one that hangs on no joint stands where the file puts it.
  void take_link(const Member& member) {
    const std::string name = member.name();
    if (hangs_.count(name) == 0)
      builder_.hang({member.node, "", name, frames_.in_world(member.node, name), {}});
    std::vector<SetPointer> shapes;
    for (const XmlElement* element = sdf_child(member.node, "collision"); element != nullptr;
         element = element->NextSiblingElement("collision"))
      take_collision(member, {member.node.file, element}, shapes);
    builder_.set_shapes(name, std::move(shapes));
  }

  void take_collision(const Member& link, const XmlNode& collision, std::vector<SetPointer>& shapes) {
    const std::string name = link.name();
    ShapeSpot spot{collision, name, sdf_pose(collision)};
    const std::string frame = link.scope.full(sdf_relative_to(collision), name);
    if (frame != name)
      spot.where =
          seen_from(frames_.in_world(collision, name), frames_.in_world(collision, frame)) * spot.where;
    const XmlElement* geometry = sdf_child(collision, "geometry");
    const XmlElement* shape = geometry == nullptr ? nullptr : geometry->FirstChildElement();
    if (shape == nullptr) spot.refuse("a collision without a shape");
    spot.node.element = shape;
    const std::string_view kind = shape->Name();
    if (kind == "empty") return;
    if (kind == "mesh") {
      for (SetPointer& set : mesh_of(*link.source, spot)) shapes.push_back(std::move(set));
    } else if (kind == "plane") {
      add_plane(name + " " + collision.text("name"), spot, name);
    } else {
      shapes.push_back(shape_of(std::string(kind), spot));
    }
  }

  /// A half-space is a body of its own, which moves with the link.
  void add_plane(const std::string& name, const ShapeSpot& spot, const std::string& link) {
    const Eigen::Vector3d normal = sdf_vector(spot.node, "normal", Eigen::Vector3d::UnitZ());
    builder_.add_link(spot.node, name, {half_space_at(spot, normal)});
    builder_.hang({spot.node, link, name, Placement::identity(3), {}});
  }

  static SetPointer shape_of(const std::string& kind, const ShapeSpot& spot) {
    if (kind == "box") {
      sdf_numbers_needed(spot, "size");
      return box_at(spot, sdf_vector(spot.node, "size", Eigen::Vector3d::Zero()) / 2);
    }
    if (kind == "ellipsoid") {
      sdf_numbers_needed(spot, "radii");
      return ellipsoid_at(spot, sdf_vector(spot.node, "radii", Eigen::Vector3d::Zero()));
    }
    if (kind == "sphere") return ball_at(spot, sdf_number(spot.node, "radius"));
    if (kind != "cylinder" && kind != "capsule")
      spot.refuse("the collision shape <" + kind + "> is not understood");
    const double half = sdf_number(spot.node, "length") / 2, radius = sdf_number(spot.node, "radius");
    return kind == "cylinder" ? cylinder_at(spot, half, radius) : capsule_at(spot, half, radius);
  }

  static void sdf_numbers_needed(const ShapeSpot& spot, const char* name) {
    if (sdf_child(spot.node, name) == nullptr)
      spot.refuse("<" + std::string(spot.node.element->Name()) + "> needs <" + name + ">");
  }

  std::vector<SetPointer> mesh_of(const RobotSource& source, const ShapeSpot& spot) {
    const std::string uri = sdf_text(spot.node, "uri", "");
    if (uri.empty()) spot.refuse("<mesh> needs <uri>");
    if (sdf_child(spot.node, "submesh") != nullptr) spot.refuse("<submesh> is not read");
    const LinkMeshes meshes(source, robot_);
    const Eigen::Vector3d scale = sdf_vector(spot.node, "scale", Eigen::Vector3d::Ones());
    return meshes.read(spot, uri, meshes.path_of(spot.node, spot.link, uri), scale);
  }

  const RobotSource& source_;
  Robot robot_;
  RobotBuilder builder_;
  SdfFrames frames_;
  std::vector<Member> links_, joints_;
  std::set<std::string> link_names_;
  std::map<std::string, std::string> attached_to_;  ///< of frames and models
  std::set<std::string> hangs_;
  std::deque<std::string> paths_;
  std::deque<XmlFile> files_;
  std::deque<RobotSource> included_;
};

}  // namespace

Robot sdf_robot(const RobotSource& source) { return SdfReader(source).read(); }

}  // namespace raygauge::cli
