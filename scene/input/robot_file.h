// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cli/input/hull_note.h"
#include "cli/input/shapes.h"
#include "raygauge/scene/motion.h"

namespace raygauge::cli {

/// A link of a robot with its collision shapes, in the frame of the link, and the joint that it hangs on.
struct RobotLink {
  std::string name;
  std::vector<SetPointer> shapes;                           ///< may be empty
  std::string joint;                                        ///< "": the root
  double lower = -std::numeric_limits<double>::infinity();  ///< limits of the joint, where it has some
  double upper = std::numeric_limits<double>::infinity();
};

/// A robot as its file has it.
struct Robot {
  std::string name;
  KinematicTree tree;                                ///< parents first; several may hang on no link
  std::vector<RobotLink> links;                      ///< by link of the tree
  std::vector<std::string> joints;                   ///< that take a value, in the order of the values
  std::map<std::string, std::string> without_value;  ///< the other ones, and why: "mimics 'a'", "is fixed"
  std::vector<std::string> skipped;                  ///< meshes that were missing: "a.stl of link 'b'"
  std::vector<std::string> left_out;       ///< of the file: "free joint of 'base', which stands still"
  std::vector<std::pair<int, int>> apart;  ///< links that the file does not compare
  Notes notes;                             ///< on meshes that are not convex
  int meshes = 0;                          ///< those that were read
};

/// Where the meshes of robots are, and what becomes of those that are not there.
struct RobotMeshes {
  std::map<std::string, std::string> packages;  ///< folders of package:// names; else those beside the file
  bool skip_missing = false;  ///< a mesh that is not there is named in `skipped`, not refused
  std::string as = {};  ///< how meshes are taken: see take_mesh; the hull of a file without objects is one
                        ///< of the "parts"
};

/// Reads the collision shapes and the joints of a robot in URDF, MJCF or SDF: the root element says which
/// (docs/meshes.md says what is read of each). Names of meshes are relative to the file. Throws
/// InvalidParameterError, naming file, line and link or joint, for what is not understood, a mesh that is
/// missing, a package that is not known.
Robot read_robot(const std::string& path, const RobotMeshes& meshes);

/// What was left out, for people: "left out: …", "left out, for they are missing: …"; nothing: no line.
std::vector<std::string> lines_of_left_out(const Robot& robot);

/// Throws InvalidParameterError, which begins with `what`, for a robot without a mesh.
void check_has_meshes(const Robot& robot, const std::string& what);

/// What a joint that takes a value may be, as its own limits and those of its mimics have it.
struct JointLimits {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool turns = false;  ///< a link turns with it
};

/// Of the joints of a robot that take a value, in their order.
std::vector<JointLimits> limits_of(const Robot& robot);

/// Those within which a path is planned: a joint that turns without limits may go half a turn beyond start
/// and goal. Not finite for one that is shifted without limits.
JointLimits planning_limits(const JointLimits& limits, double start, double goal);

}  // namespace raygauge::cli
