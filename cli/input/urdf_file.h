// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cli/input/shapes.h"
#include "raygauge/scene/joint_motion.h"

namespace raygauge::cli {

/// A link of a robot with its collision shapes, in the frame of the link.
struct RobotLink {
  std::string name;
  std::vector<SetPointer> shapes;  ///< may be empty
};

/// A robot as its URDF file has it.
struct Robot {
  std::string name;
  KinematicTree tree;                       ///< parents first
  std::vector<RobotLink> links;             ///< by link of the tree
  std::vector<std::string> joints;          ///< that take a value, in the order of the values; no mimics
  std::vector<std::pair<int, int>> joined;  ///< links that a joint joins
};

/// Reads the collision shapes (boxes, spheres, cylinders, meshes as their convex hulls) and the joints
/// (fixed, revolute, continuous, prismatic, mimics) of a URDF file. `packages` are the folders of package://
/// names; other names of meshes are relative to the file. Throws InvalidParameterError, naming file and link
/// or joint, for what is not understood: a joint of another type, a mesh that is missing, a package that is
/// not known, text that is not URDF.
Robot read_urdf(const std::string& path, const std::map<std::string, std::string>& packages);

}  // namespace raygauge::cli
