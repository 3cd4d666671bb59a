// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "scene/input/robot_formats.h"

namespace raygauge::cli {

/// A class of defaults: what its elements, or those of the classes around it, say.
struct MjcfClass {
  const MjcfClass* around = nullptr;
  std::vector<XmlNode> elements;  ///< a later one wins
};

/// An element with the defaults of its class behind it.
class MjcfElement {
 public:
  MjcfElement(const XmlNode& node, const MjcfClass* defaults);

  const XmlNode& node() const { return levels_.front(); }
  bool has(const char* name) const { return find(name) != nullptr; }
  std::string text(const char* name, const std::string& otherwise) const;
  double number(const char* name, double otherwise) const;
  Eigen::Vector3d vector(const char* name, const Eigen::Vector3d& otherwise) const;
  std::vector<double> numbers(const char* name, std::size_t least, std::size_t most) const;
  bool is_true(const char* name, bool otherwise) const;  ///< "true" or "false"

  /// The innermost level that has one of these attributes, and which; null: none.
  const XmlNode* first_with(const std::vector<const char*>& names, const char*& which) const;

 private:
  const XmlNode* find(const char* name) const;

  std::vector<XmlNode> levels_;  ///< the element, then its defaults from inside out
};

/// The text of an MJCF model: files that it includes, compiler settings, defaults.
class MjcfText {
 public:
  /// Throws InvalidParameterError for a file that is missing, included twice, or not MJCF.
  explicit MjcfText(const RobotSource& source);

  /// The elements in `parent`, those of included files in the place of <include>.
  std::vector<XmlNode> children(const XmlNode& parent);

  /// The elements in all sections of that name.
  std::vector<XmlNode> section(const std::string& name);

  /// The element with the defaults of its own class, or else of `childclass`. Throws InvalidParameterError
  /// for a class that is not there.
  MjcfElement with_defaults(const XmlNode& node, const std::string& childclass) const;

  /// Its pos and orientation (quat, axisangle, euler, xyaxes or zaxis).
  Placement place_of(const MjcfElement& element) const;

  /// An angle of the file in radians.
  double radians(double angle) const { return angle * angle_unit_; }

  bool autolimits() const { return autolimits_; }

  /// Where the file of a mesh is.
  std::string mesh_path(const std::string& file) const;

 private:
  const XmlFile& load(const XmlNode& include);
  void read_compiler(const XmlNode& compiler);
  void read_defaults(const XmlNode& node, MjcfClass* around);
  Eigen::Matrix3d rotation_of(const MjcfElement& element) const;
  Eigen::Matrix3d rotation_by(const XmlNode& level, const char* attribute) const;

  const RobotSource& source_;
  std::deque<XmlFile> included_;
  std::map<std::string, bool> loaded_;  ///< by path
  std::map<const XmlElement*, const XmlFile*> file_of_include_;
  std::map<std::string, MjcfClass> classes_;
  std::string main_class_ = "main", eulerseq_ = "xyz", mesh_folder_;
  double angle_unit_ = EIGEN_PI / 180;
  bool autolimits_ = true, strip_path_ = false;
};

}  // namespace raygauge::cli
