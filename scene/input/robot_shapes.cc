// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/input/robot_shapes.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "cli/input/mesh_object_file.h"
#include "raygauge/exceptions.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/half_space.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/prepared_set.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::cli {
namespace {

namespace fs = std::filesystem;

/// Hulls of so many points are prepared, once for all checkers and scenes of the robot: of the UR5's, with 70
/// to 220 vertices among 230 to 600 points, this took a fifth off the time of a free edge.
constexpr Eigen::Index kPrepared = 100;

/// What the function makes; its errors are of the spot.
template <class Make>
auto at(const ShapeSpot& spot, const Make& make) {
  try {
    return make();
  } catch (const Error& error) {
    spot.refuse(error.what());
  }
}

template <class Set, class... Values>
SetPointer made(const ShapeSpot& spot, const Values&... values) {
  return at(spot, [&] { return std::make_shared<const Set>(values...); });
}

Eigen::MatrixXd corners_of(const Eigen::Vector3d& half) {
  Eigen::MatrixXd corners(3, 8);
  for (Eigen::Index i = 0; i < 8; ++i) {
    for (Eigen::Index k = 0; k < 3; ++k) corners(k, i) = (i >> k & 1) != 0 ? half[k] : -half[k];
  }
  return corners;
}

Eigen::MatrixXd placed_points(const Eigen::MatrixXd& points, const Placement& where) {
  if (where.R.isIdentity(0) && where.t.isZero(0)) return points;
  return (where.R * points).colwise() + Vector(where.t);
}

template <class Round>
SetPointer round_at(const ShapeSpot& spot, double half_length, double radius) {
  const Eigen::Vector3d half(0, 0, half_length);
  const Vector p = spot.where.t - spot.where.R * half, q = spot.where.t + spot.where.R * half;
  return made<Round>(spot, p, q, radius);
}

}  // namespace

void ShapeSpot::refuse(const std::string& what) const { node.refuse("link '" + link + "': " + what); }

SetPointer ball_at(const ShapeSpot& spot, double radius) {
  return made<Ball>(spot, Vector(spot.where.t), radius);
}

SetPointer box_at(const ShapeSpot& spot, const Eigen::Vector3d& half) {
  if (!(half.minCoeff() >= 0)) return made<Box>(spot, -half, half);  // which says what is wrong
  if (!spot.where.R.isIdentity(0)) return made<PointSet>(spot, placed_points(corners_of(half), spot.where));
  return made<Box>(spot, Vector(spot.where.t - half), Vector(spot.where.t + half));
}

SetPointer ellipsoid_at(const ShapeSpot& spot, const Eigen::Vector3d& radii) {
  if (!(radii.minCoeff() >= 0)) spot.refuse("ellipsoid: radii must not be negative");
  return made<Ellipsoid>(spot, Vector(spot.where.t), Eigen::MatrixXd(spot.where.R * radii.asDiagonal()));
}

SetPointer cylinder_at(const ShapeSpot& spot, double half_length, double radius) {
  return round_at<Cylinder>(spot, half_length, radius);
}

SetPointer capsule_at(const ShapeSpot& spot, double half_length, double radius) {
  return round_at<Capsule>(spot, half_length, radius);
}

SetPointer half_space_at(const ShapeSpot& spot, const Eigen::Vector3d& normal) {
  const Vector turned = spot.where.R * normal;
  return made<HalfSpace>(spot, turned, turned.dot(Vector(spot.where.t)));
}

std::string LinkMeshes::path_of(const XmlNode& node, const std::string& link, const std::string& name) const {
  constexpr std::string_view kPackage = "package://";
  constexpr std::string_view kModel = "model://";
  constexpr std::string_view kFile = "file://";
  const fs::path beside = fs::path(source_.path).parent_path();
  if (name.starts_with(kFile)) return name.substr(kFile.size());
  const bool model = name.starts_with(kModel);
  if (!model && !name.starts_with(kPackage)) return (beside / name).string();
  const std::string rest = name.substr(model ? kModel.size() : kPackage.size());
  const std::string package = rest.substr(0, rest.find('/'));
  const auto folder = source_.meshes.packages.find(package);
  if (folder != source_.meshes.packages.end())
    return (fs::path(folder->second) / rest.substr(std::min(rest.size(), package.size() + 1))).string();
  std::error_code ignored;
  if (fs::is_directory(beside / package, ignored)) return (beside / rest).string();
  for (fs::path up = fs::absolute(source_.path, ignored).parent_path(); up.has_relative_path();
       up = up.parent_path()) {
    if (up.filename() == package) return (up.parent_path() / rest).string();
  }
  if (source_.meshes.skip_missing) return "";
  ShapeSpot{node, link, {}}.refuse("the folder of package '" + package + "' is not known; say --package " +
                                   package + "=FOLDER");
}

std::vector<SetPointer> LinkMeshes::read(const ShapeSpot& spot, const std::string& name,
                                         const std::string& path, const Eigen::Vector3d& scale) const {
  if ((scale.array() == 0).any()) spot.refuse("scale = 0 leaves nothing of a mesh");
  std::error_code ignored;
  if (!fs::exists(path, ignored)) {
    if (!source_.meshes.skip_missing)
      spot.refuse("there is no mesh " + path + " (--skip-missing-meshes leaves it out)");
    robot_.skipped.push_back(name + " of link '" + spot.link + "'");
    return {};
  }
  return take(spot, name, at(spot, [&] { return read_mesh(path); }), scale);
}

std::vector<SetPointer> LinkMeshes::take(const ShapeSpot& spot, const std::string& name, MeshFile mesh,
                                         const Eigen::Vector3d& scale) const {
  mesh.vertices = placed_points(scale.asDiagonal() * mesh.vertices, spot.where);
  if (scale.prod() < 0) {  // a mirror turns every triangle about
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  }
  ++robot_.meshes;
  const bool one_part = source_.meshes.as == "parts" && !has_objects(mesh);
  std::vector<SetPointer> sets = at(spot, [&] {
    return take_mesh(mesh, name + " of link '" + spot.link + "'", one_part ? "hull" : source_.meshes.as,
                     robot_.notes);
  });
  for (SetPointer& set : sets) {
    const PointSet* points = as_point_set(*set);
    if (points != nullptr && points->size() >= kPrepared) set = made<PreparedSet>(spot, *points);
  }
  return sets;
}

}  // namespace raygauge::cli
