// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/input/urdf_shapes.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "cli/input/mesh_file.h"
#include "cli/input/mesh_object_file.h"
#include "cli/input/pose_table.h"
#include "raygauge/exceptions.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/cylinder.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/prepared_set.h"

namespace raygauge::cli {
namespace {

namespace fs = std::filesystem;

/// Hulls of so many points are prepared, once for all checkers and scenes of the robot: of the UR5's, with 70
/// to 220 vertices among 230 to 600 points, this took a fifth off the time of a free edge.
constexpr Eigen::Index kPrepared = 100;

/// Reads the shapes of one link.
class ShapeReader {
 public:
  ShapeReader(const XmlFile& file, std::string link, const std::string& path, const RobotMeshes& meshes,
              Robot& robot)
      : file_(file), link_(std::move(link)), path_(path), meshes_(meshes), robot_(robot) {}

  /// None: a mesh that is missing and may be.
  std::vector<SetPointer> read(const XmlElement& collision) const {
    const XmlElement* geometry = collision.FirstChildElement("geometry");
    const XmlElement* shape = geometry == nullptr ? nullptr : geometry->FirstChildElement();
    if (shape == nullptr) refuse(collision, "a collision without a shape");
    if (shape->NextSiblingElement() != nullptr) refuse(*geometry, "a collision of more than one shape");
    const Placement where = urdf_origin(file_, collision);
    try {
      if (std::string_view(shape->Name()) == "mesh") return mesh_of(*shape, where);
      return {shape_of(*shape, where)};
    } catch (const EngineError& error) {
      refuse(*shape, error.message);
    }
  }

 private:
  /// What the engine says of a shape; it has no place yet.
  struct EngineError {
    std::string message;
  };

  [[noreturn]] void refuse(const XmlElement& element, const std::string& what) const {
    file_.refuse(element, "link '" + link_ + "': " + what);
  }

  template <class Set, class... Values>
  static SetPointer made(const Values&... values) {
    try {
      return std::make_shared<const Set>(values...);
    } catch (const Error& error) {
      throw EngineError{error.what()};
    }
  }

  /// Where it is on the link: numbers of its own frame are rounded once, as those of the file are, so that
  /// solvers see a ball, a cylinder or points and not an image of these.
  SetPointer shape_of(const XmlElement& shape, const Placement& where) const {
    const std::string_view kind = shape.Name();
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    if (kind == "sphere") return made<Ball>(Vector(where.t), file_.number(shape, "radius"));
    if (kind == "box") {
      file_.text(shape, "size");
      const Eigen::Vector3d half = file_.vector(shape, "size", zero) / 2;
      if (!(half.minCoeff() >= 0)) return made<Box>(-half, half);  // which says what is wrong
      if (where.R.isIdentity(0)) return made<Box>(Vector(where.t - half), Vector(where.t + half));
      return made<PointSet>(placed_points(corners_of(half), where));
    }
    if (kind == "cylinder" || kind == "capsule") {
      // Of a capsule too the length is that of the part between the round ends.
      const Eigen::Vector3d half(0, 0, file_.number(shape, "length") / 2);
      const double radius = file_.number(shape, "radius");
      const Vector p = where.t - where.R * half, q = where.t + where.R * half;
      return kind == "cylinder" ? made<Cylinder>(p, q, radius) : made<Capsule>(p, q, radius);
    }
    refuse(shape, "the collision shape <" + std::string(kind) + "> is not understood");
  }

  static Eigen::MatrixXd corners_of(const Eigen::Vector3d& half) {
    Eigen::MatrixXd corners(3, 8);
    for (Eigen::Index i = 0; i < 8; ++i) {
      for (Eigen::Index k = 0; k < 3; ++k) corners(k, i) = (i >> k & 1) != 0 ? half[k] : -half[k];
    }
    return corners;
  }

  static Eigen::MatrixXd placed_points(const Eigen::MatrixXd& points, const Placement& where) {
    if (where.R.isIdentity(0) && where.t.isZero(0)) return points;
    return (where.R * points).colwise() + Vector(where.t);
  }

  std::vector<SetPointer> mesh_of(const XmlElement& mesh, const Placement& where) const {
    const std::string name = file_.text(mesh, "filename");
    const Eigen::Vector3d scale = file_.vector(mesh, "scale", Eigen::Vector3d::Ones());
    if ((scale.array() == 0).any()) refuse(mesh, "scale = 0 leaves nothing of a mesh");
    const std::string found = mesh_path(mesh, name);
    std::error_code ignored;
    if (!fs::exists(found, ignored)) {
      if (skip(name)) return {};
      refuse(mesh, "there is no mesh " + found + " (--skip-missing-meshes leaves it out)");
    }
    try {
      return taken(placed_mesh(read_mesh(found), scale, where), name + " of link '" + link_ + "'");
    } catch (const Error& error) {
      refuse(mesh, error.what());
    }
  }

  static MeshFile placed_mesh(MeshFile file, const Eigen::Vector3d& scale, const Placement& where) {
    file.vertices = placed_points(scale.asDiagonal() * file.vertices, where);
    if (scale.prod() < 0) {  // a mirror turns every triangle about
      for (Triangle& triangle : file.triangles) std::swap(triangle[1], triangle[2]);
    }
    return file;
  }

  std::vector<SetPointer> taken(const MeshFile& file, const std::string& name) const {
    ++robot_.meshes;
    const bool one_part = meshes_.as == "parts" && !has_objects(file);
    std::vector<SetPointer> sets = take_mesh(file, name, one_part ? "hull" : meshes_.as, robot_.notes);
    for (SetPointer& set : sets) {
      const PointSet* points = as_point_set(*set);
      if (points != nullptr && points->size() >= kPrepared) set = made<PreparedSet>(*points);
    }
    return sets;
  }

  bool skip(const std::string& name) const {
    if (meshes_.skip_missing) robot_.skipped.push_back(name + " of link '" + link_ + "'");
    return meshes_.skip_missing;
  }

  /// "" for one in a package that is not known, if such meshes may be missing.
  std::string mesh_path(const XmlElement& mesh, const std::string& name) const {
    constexpr std::string_view kPackage = "package://";
    constexpr std::string_view kFile = "file://";
    if (name.starts_with(kFile)) return name.substr(kFile.size());
    if (!name.starts_with(kPackage)) return (fs::path(path_).parent_path() / name).string();
    const std::string rest = name.substr(kPackage.size());
    const std::string package = rest.substr(0, rest.find('/'));
    const auto folder = meshes_.packages.find(package);
    if (folder != meshes_.packages.end())
      return (fs::path(folder->second) / rest.substr(std::min(rest.size(), package.size() + 1))).string();
    std::error_code ignored;
    const fs::path beside = fs::path(path_).parent_path();
    if (fs::is_directory(beside / package, ignored)) return (beside / rest).string();
    if (meshes_.skip_missing) return "";
    refuse(mesh,
           "the folder of package '" + package + "' is not known; say --package " + package + "=FOLDER");
  }

  const XmlFile& file_;
  std::string link_;
  const std::string& path_;
  const RobotMeshes& meshes_;
  Robot& robot_;
};

/// Elements that nobody reads are of other programs, unless one is this word but for a slip.
void refuse_slip(const XmlFile& file, const XmlElement& link) {
  const std::string wanted = "collision";
  for (const XmlElement* child = link.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    const std::string name = child->Name();
    const bool alike = std::abs(static_cast<int>(name.size()) - static_cast<int>(wanted.size())) <= 2;
    if (name != wanted && alike && !nearest_name(name, {wanted}).empty())
      file.refuse(*child,
                  "link '" + file.text(link, "name") + "': <" + name + ">; did you mean <collision>?");
  }
}

}  // namespace

Placement urdf_origin(const XmlFile& file, const XmlElement& element) {
  const XmlElement* origin = element.FirstChildElement("origin");
  if (origin == nullptr) return Placement::identity(3);
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  const Eigen::Vector3d xyz = file.vector(*origin, "xyz", zero);
  const Eigen::Vector3d rpy = file.vector(*origin, "rpy", zero);
  return make_placement(rotation_of_rpy(rpy), xyz);
}

std::vector<SetPointer> urdf_shapes(const XmlFile& file, const XmlElement& link, const std::string& path,
                                    const RobotMeshes& meshes, Robot& robot) {
  refuse_slip(file, link);
  const ShapeReader reader(file, file.text(link, "name"), path, meshes, robot);
  std::vector<SetPointer> shapes;
  for (const XmlElement* collision = link.FirstChildElement("collision"); collision != nullptr;
       collision = collision->NextSiblingElement("collision")) {
    for (SetPointer& shape : reader.read(*collision)) shapes.push_back(std::move(shape));
  }
  return shapes;
}

}  // namespace raygauge::cli
