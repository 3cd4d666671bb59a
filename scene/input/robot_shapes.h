// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/input/mesh_file.h"
#include "cli/input/xml_values.h"
#include "raygauge/scene/motion.h"
#include "scene/input/robot_formats.h"

namespace raygauge::cli {

/// A collision shape's element, whose link it is, and where it is on the link.
struct ShapeSpot {
  XmlNode node;
  std::string link;
  Placement where;

  /// Throws InvalidParameterError "FILE:LINE: link 'LINK': what".
  [[noreturn]] void refuse(const std::string& what) const;
};

// Shapes of links in any format: numbers of their own frame are rounded once, as those of the file are, so
// that solvers see a ball, a cylinder or points and not an image of these. What the engine refuses is refused
// at the spot.
SetPointer ball_at(const ShapeSpot& spot, double radius);
SetPointer box_at(const ShapeSpot& spot, const Eigen::Vector3d& half);
SetPointer ellipsoid_at(const ShapeSpot& spot, const Eigen::Vector3d& radii);
SetPointer cylinder_at(const ShapeSpot& spot, double half_length, double radius);  ///< along z
SetPointer capsule_at(const ShapeSpot& spot, double half_length, double radius);   ///< between the round ends
SetPointer half_space_at(const ShapeSpot& spot, const Eigen::Vector3d& normal);    ///< what is behind it

/// Meshes of the links of one robot. Those that are missing are added to robot.skipped if source.meshes say
/// so, those that are not convex to robot.notes.
class LinkMeshes {
 public:
  LinkMeshes(const RobotSource& source, Robot& robot) : source_(source), robot_(robot) {}

  /// Where a mesh is: package://NAME/… and model://NAME/… by the folders of packages, or else the folder NAME
  /// beside or above the file; file://…; other names beside the file. "": it is in a package that is not
  /// known, if such meshes may be missing.
  std::string path_of(const XmlNode& node, const std::string& link, const std::string& name) const;

  /// The mesh in the file `path`, called `name` in notes, with its vertices scaled and then placed. None: it
  /// is missing and may be.
  std::vector<SetPointer> read(const ShapeSpot& spot, const std::string& name, const std::string& path,
                               const Eigen::Vector3d& scale) const;

  /// The same of a mesh that is read already.
  std::vector<SetPointer> take(const ShapeSpot& spot, const std::string& name, MeshFile mesh,
                               const Eigen::Vector3d& scale) const;

 private:
  const RobotSource& source_;
  Robot& robot_;
};

}  // namespace raygauge::cli
