// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// MJCF, as far as bodies, joints and the geoms that collide go.
#include <filesystem>
#include <set>
#include <string_view>

#include "raygauge/exceptions.h"
#include "results/text/words.h"
#include "scene/input/mjcf_text.h"
#include "scene/input/robot_builder.h"
#include "scene/input/robot_shapes.h"

namespace raygauge::cli {
namespace {

const std::string kWorld = "world";

class MjcfReader {
 public:
  explicit MjcfReader(const RobotSource& source)
      : source_(source), text_(source), meshes_(source, robot_), builder_(robot_) {}

  Robot read() {
    const XmlNode root{&source_.file, &source_.file.root()};
    const char* name = root.element->Attribute("model");
    robot_.name = name == nullptr ? "MuJoCo Model" : name;
    for (const XmlNode& asset : text_.section("asset")) take_asset(asset);
    for (const XmlNode& equality : text_.section("equality")) take_equality(equality);
    Solid world{kWorld, root, {}, {}, false};
    builder_.add_link(root, kWorld, {});
    for (const XmlNode& child : text_.section("worldbody"))
      add_child(child, world, Placement::identity(3), "");
    builder_.set_shapes(kWorld, std::move(world.shapes));
    couple_joints();
    for (RobotHanging& hanging : hangings_) builder_.hang(std::move(hanging));
    builder_.finish(root);
    for (const XmlNode& contact : text_.section("contact")) take_contact(contact);
    say_what_is_left_out();
    return std::move(robot_);
  }

 private:
  /// A body while its elements are read.
  struct Solid {
    std::string name;
    XmlNode node;
    std::vector<SetPointer> shapes;
    std::vector<RobotJoint> joints;
    bool is_free = false;
  };

  struct Mimic {
    XmlNode node;
    std::string leader;
    double constant, factor;
  };

  void take_asset(const XmlNode& asset) {
    if (std::string_view(asset.element->Name()) != "mesh") return;
    const MjcfElement mesh = text_.with_defaults(asset, "");
    const std::string stem = std::filesystem::path(mesh.text("file", "")).stem().string();
    const std::string name = mesh.text("name", stem);
    if (!assets_.emplace(name, mesh).second) asset.refuse("a second mesh '" + name + "'");
  }

  /// Those that couple two joints are kept: angle = constant + factor (leader - ref of the leader).
  void take_equality(const XmlNode& node) {
    const MjcfElement equality = text_.with_defaults(node, "");
    if (!equality.is_true("active", true)) return;
    const std::string kind = node.element->Name();
    std::vector<double> poly = {0, 1};
    if (equality.has("polycoef")) poly = equality.numbers("polycoef", 1, 5);
    poly.resize(5);
    const bool linear = poly[2] == 0 && poly[3] == 0 && poly[4] == 0;
    if (kind == "joint" && equality.has("joint2") && linear) {
      const Mimic mimic{node, equality.text("joint2", ""), poly[0], poly[1]};
      if (mimics_.emplace(equality.text("joint1", ""), mimic).second) return;
    }
    ++equalities_;
  }

  void add_child(const XmlNode& node, Solid& solid, const Placement& where, const std::string& childclass) {
    const std::string_view kind = node.element->Name();
    if (kind == "body") return add_body(node, solid, where, childclass);
    if (kind == "frame") {
      const Placement inner = where * text_.place_of(MjcfElement(node, nullptr));
      for (const XmlNode& child : text_.children(node))
        add_child(child, solid, inner, own_class(node, childclass));
    } else if (kind == "geom") {
      add_geom(text_.with_defaults(node, childclass), solid, where);
    } else if (kind == "joint" || kind == "freejoint") {
      add_joint(text_.with_defaults(node, childclass), solid, where);
    } else if (ignored_.count(std::string(kind)) == 0) {
      node.refuse("<" + std::string(kind) + "> in body '" + solid.name + "' is not read");
    }
  }

  static std::string own_class(const XmlNode& node, const std::string& childclass) {
    const char* own = node.element->Attribute("childclass");
    return own == nullptr ? childclass : own;
  }

  void add_body(const XmlNode& node, const Solid& parent, const Placement& where,
                const std::string& childclass) {
    const char* name = node.element->Attribute("name");
    Solid solid{name != nullptr ? name : "body " + std::to_string(++unnamed_), node, {}, {}, false};
    // The body's place in the frame of its parent; its children are read first, for its joints.
    const std::size_t place = hangings_.size();
    const Placement origin = where * text_.place_of(MjcfElement(node, nullptr));
    hangings_.push_back({node, parent.name, solid.name, origin, {}});
    for (const XmlNode& child : text_.children(node))
      add_child(child, solid, Placement::identity(3), own_class(node, childclass));
    if (solid.is_free && (parent.name != kWorld || !solid.joints.empty()))
      node.refuse("body '" + solid.name + "' has a free joint, and another one or a body around it");
    // What moves in the world is compared with what stands in it.
    if (parent.name == kWorld && (solid.is_free || !solid.joints.empty())) hangings_[place].parent.clear();
    hangings_[place].joints = std::move(solid.joints);
    builder_.add_link(node, solid.name, std::move(solid.shapes));
  }

  void add_joint(const MjcfElement& element, Solid& solid, const Placement& where) {
    const bool free = std::string_view(element.node().element->Name()) == "freejoint";
    const std::string type = free ? "free" : element.text("type", "hinge");
    if (type == "free") {
      solid.is_free = true;
      robot_.left_out.push_back("the free joint of body '" + solid.name + "', which stays where it stands");
      return;
    }
    RobotJoint joint;
    joint.node = element.node();
    joint.name = element.text("name", solid.name + " joint " + std::to_string(solid.joints.size() + 1));
    joint.anchor = where.R * element.vector("pos", Eigen::Vector3d::Zero()) + where.t;
    if (type == "ball") {
      if (element.has("range")) robot_.left_out.push_back("the limit of the ball joint '" + joint.name + "'");
      return add_ball_joint(joint, where.R, solid.joints);
    }
    if (type != "hinge" && type != "slide") element.node().refuse("joint '" + joint.name + "' is " + type);
    joint.kind = type == "hinge" ? JointKind::revolute : JointKind::prismatic;
    if (joint.kind == JointKind::prismatic) joint.anchor.setZero();
    joint.axis = where.R * element.vector("axis", Eigen::Vector3d::UnitZ());
    if (!(joint.axis.norm() > 0)) element.node().refuse("joint '" + joint.name + "' has no axis");
    const double unit = type == "hinge" ? text_.radians(1) : 1;
    const double ref = unit * element.number("ref", 0);
    read_limits(element, unit, ref, joint);
    reference_[joint.name] = ref;
    joint.offset = -ref;
    solid.joints.push_back(joint);
  }

  /// Those of the file are of the value; q is 0 at the value `ref`.
  void read_limits(const MjcfElement& element, double unit, double ref, RobotJoint& joint) const {
    const std::string limited = element.text("limited", "auto");
    if (limited != "auto" && limited != "true" && limited != "false")
      element.node().refuse("limited must be true, false or auto, got '" + limited + "'");
    const bool automatic = limited == "auto" && text_.autolimits() && element.has("range");
    if (limited != "true" && !automatic) return;
    const std::vector<double> range = element.numbers("range", 2, 2);
    joint.lower = unit * range[0] - ref;
    joint.upper = unit * range[1] - ref;
  }

  void add_geom(const MjcfElement& geom, Solid& solid, const Placement& where) {
    if (geom.number("contype", 1) == 0 && geom.number("conaffinity", 1) == 0) {
      ++visual_;
      return;
    }
    const std::string mesh = geom.text("mesh", "");
    const std::string type = geom.text("type", mesh.empty() ? "sphere" : "mesh");
    ShapeSpot spot{geom.node(), solid.name, where};
    const auto none = Eigen::Vector3d::Zero();
    Eigen::Vector3d size = none;
    if (geom.has("size")) {
      const std::vector<double> numbers = geom.numbers("size", 1, 3);
      std::copy(numbers.begin(), numbers.end(), size.begin());
    }
    if (geom.has("fromto") && type != "mesh" && type != "plane") {
      spot.where = where * along(geom, type, size);
    } else {
      spot.where = where * text_.place_of(geom);
    }
    if (type == "plane") return add_plane(geom, spot, solid);
    if (type == "mesh") return add_mesh(mesh, spot, solid);
    if (!mesh.empty()) spot.refuse("a " + type + " that is fitted to a mesh is not read");
    solid.shapes.push_back(shape_of(type, spot, size));
  }

  static SetPointer shape_of(const std::string& type, const ShapeSpot& spot, const Eigen::Vector3d& size) {
    if (type == "sphere") return ball_at(spot, size[0]);
    if (type == "box") return box_at(spot, size);
    if (type == "ellipsoid") return ellipsoid_at(spot, size);
    if (type == "capsule") return capsule_at(spot, size[1], size[0]);
    if (type == "cylinder") return cylinder_at(spot, size[1], size[0]);
    spot.refuse("a geom of type " + type + " is not read");
  }

  /// The frame in the middle between two points, z along them; their distance goes to `size`.
  static Placement along(const MjcfElement& geom, const std::string& type, Eigen::Vector3d& size) {
    const std::vector<double> v = geom.numbers("fromto", 6, 6);
    const Eigen::Vector3d from(v[0], v[1], v[2]), to(v[3], v[4], v[5]), line = from - to;
    if (!(line.norm() > 0)) geom.node().refuse("the points of fromto are the same");
    const bool round = type == "capsule" || type == "cylinder";
    if (!round) size[1] = size[0];
    size[round ? 1 : 2] = line.norm() / 2;
    const Eigen::Matrix3d turn =
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), line.normalized()).toRotationMatrix();
    return make_placement(turn, (from + to) / 2);
  }

  /// Half-spaces are bodies of their own, which move with the body that has them.
  void add_plane(const MjcfElement& geom, const ShapeSpot& spot, const Solid& solid) {
    const std::string name = geom.node().element->Attribute("name") != nullptr
                                 ? geom.text("name", "")
                                 : solid.name + " plane " + std::to_string(++planes_);
    builder_.add_link(geom.node(), name, {half_space_at(spot, Eigen::Vector3d::UnitZ())});
    hangings_.push_back({geom.node(), solid.name, name, Placement::identity(3), {}});
  }

  void add_mesh(const std::string& name, const ShapeSpot& spot, Solid& solid) {
    const auto found = assets_.find(name);
    if (found == assets_.end()) spot.refuse("there is no mesh '" + name + "'");
    for (SetPointer& set : mesh_of(found->second, name, spot)) solid.shapes.push_back(std::move(set));
  }

  std::vector<SetPointer> mesh_of(const MjcfElement& asset, const std::string& name,
                                  const ShapeSpot& spot) const {
    if (asset.has("builtin")) spot.refuse("the built-in mesh '" + name + "' is not read");
    if (asset.has("refpos") || asset.has("refquat"))
      spot.refuse("mesh '" + name + "': refpos and refquat are not read; place the geom instead");
    const Eigen::Vector3d scale = asset.vector("scale", Eigen::Vector3d::Ones());
    if (asset.has("file")) {
      const std::string file = asset.text("file", "");
      return meshes_.read(spot, file, text_.mesh_path(file), scale);
    }
    return meshes_.take(spot, name, written_mesh(asset, spot), scale);
  }

  /// Of a mesh whose numbers are in the file itself.
  static MeshFile written_mesh(const MjcfElement& asset, const ShapeSpot& spot) {
    const std::vector<double> numbers = asset.numbers("vertex", 3, static_cast<std::size_t>(-1));
    MeshFile mesh;
    mesh.vertices = Eigen::Matrix3Xd::Map(numbers.data(), 3, static_cast<Eigen::Index>(numbers.size() / 3));
    if (numbers.size() % 3 != 0) spot.refuse("the coordinates in vertex are not three for each");
    if (!asset.has("face")) return mesh;
    const std::vector<double> corners = asset.numbers("face", 3, static_cast<std::size_t>(-1));
    if (corners.size() % 3 != 0) spot.refuse("the numbers in face are not three for each");
    for (std::size_t k = 0; k < corners.size(); k += 3) {
      Triangle triangle;
      for (std::size_t i = 0; i < 3; ++i) {
        const double corner = corners[k + i];
        if (!(corner >= 0 && corner < static_cast<double>(mesh.vertices.cols())))
          spot.refuse("face names a vertex that is not there");
        triangle[i] = static_cast<std::int32_t>(corner);
      }
      mesh.triangles.push_back(triangle);
    }
    return mesh;
  }

  /// Couplings of joints, now that the joints are known. A leader that follows a third joint has to be 0 in
  /// the file's own pose, as the builder adds up what mimics of mimics do.
  void couple_joints() {
    for (RobotHanging& hanging : hangings_) {
      for (RobotJoint& joint : hanging.joints) {
        const auto found = mimics_.find(joint.name);
        if (found == mimics_.end()) continue;
        const auto& [node, leader, constant, factor] = found->second;
        const auto reference = reference_.find(leader);
        if (reference == reference_.end()) node.refuse("joint '" + leader + "' is no hinge and no slide");
        if (mimics_.count(leader) != 0 && reference->second != 0)
          node.refuse("joint '" + leader + "' follows another one, and its ref is not 0");
        joint.mimicked = leader;
        joint.scale = factor;
        joint.offset = constant - factor * reference->second;
      }
    }
  }

  void take_contact(const XmlNode& node) {
    if (std::string_view(node.element->Name()) == "pair") ++pairs_;
    if (std::string_view(node.element->Name()) != "exclude") return;
    const auto link = [&](const char* attribute) {
      const std::string name = node.text(attribute);
      for (std::size_t i = 0; i < robot_.links.size(); ++i) {
        if (robot_.links[i].name == name) return static_cast<int>(i);
      }
      node.refuse("there is no body '" + name + "'");
    };
    const int a = link("body1"), b = link("body2");
    robot_.apart.emplace_back(a, b);
  }

  void say_what_is_left_out() {
    const auto say = [&](int count, const std::string& one, const std::string& several) {
      if (count > 0) robot_.left_out.push_back(counted(count, one, several));
    };
    say(visual_, "geom without contacts (contype and conaffinity 0)",
        "geoms without contacts (contype and conaffinity 0)");
    say(equalities_, "equality constraint", "equality constraints");
    say(pairs_, "contact pair", "contact pairs");
  }

  const RobotSource& source_;
  MjcfText text_;
  Robot robot_;
  LinkMeshes meshes_;
  RobotBuilder builder_;
  std::vector<RobotHanging> hangings_;
  std::map<std::string, MjcfElement> assets_;
  std::map<std::string, Mimic> mimics_;
  std::map<std::string, double> reference_;  ///< of joints: their value in the file's own pose
  const std::set<std::string> ignored_ = {"inertial", "site", "camera", "light", "plugin"};
  int unnamed_ = 0, planes_ = 0, visual_ = 0, equalities_ = 0, pairs_ = 0;
};

}  // namespace

Robot mjcf_robot(const RobotSource& source) { return MjcfReader(source).read(); }

}  // namespace raygauge::cli
