// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cli/input/xml_values.h"
#include "raygauge/scene/motion.h"

namespace raygauge::cli {

/// Children of an SDF element whose text is a value. Each throws InvalidParameterError for another text.
const XmlElement* sdf_child(const XmlNode& node, const char* name);
std::string sdf_text(const XmlNode& node, const char* name, const std::string& otherwise);
std::vector<double> sdf_numbers(const XmlNode& node);
double sdf_number(const XmlNode& node, const char* name);  ///< refused where it is missing
double sdf_number(const XmlNode& node, const char* name, double otherwise);
Eigen::Vector3d sdf_vector(const XmlNode& node, const char* name, const Eigen::Vector3d& otherwise);

/// The <pose> in an element; none: the identity.
Placement sdf_pose(const XmlNode& node);

/// The frame that the <pose> is relative to; "": that of the kind of the element.
std::string sdf_relative_to(const XmlNode& node);

/// The frames of an SDF file, by full name (MODEL::LINK), each relative to another one; "" is the world.
class SdfFrames {
 public:
  /// Throws InvalidParameterError for a second frame of that name.
  void add(const XmlNode& node, const std::string& name, const std::string& relative_to,
           const Placement& pose);

  bool has(const std::string& name) const { return frames_.count(name) != 0; }

  /// Where a frame is in the world. Throws InvalidParameterError, at `node`, for one that is not there, or is
  /// relative to itself.
  Placement in_world(const XmlNode& node, const std::string& name) const;

 private:
  struct Frame {
    std::string relative_to;
    Placement pose;
  };

  std::map<std::string, Frame> frames_;
};

}  // namespace raygauge::cli
