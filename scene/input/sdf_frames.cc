// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/input/sdf_frames.h"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <string_view>

#include "cli/input/byte_reader.h"
#include "cli/input/number_word.h"
#include "cli/input/pose_table.h"

namespace raygauge::cli {

const XmlElement* sdf_child(const XmlNode& node, const char* name) {
  return node.element->FirstChildElement(name);
}

std::string sdf_text(const XmlNode& node, const char* name, const std::string& otherwise) {
  const XmlElement* child = sdf_child(node, name);
  if (child == nullptr) return otherwise;
  const std::string text = child->GetText() == nullptr ? "" : child->GetText();
  const std::size_t begin = text.find_first_not_of(" \t\r\n"), end = text.find_last_not_of(" \t\r\n");
  return begin == std::string::npos ? "" : text.substr(begin, end + 1 - begin);
}

std::vector<double> sdf_numbers(const XmlNode& node) {
  const std::string text = node.element->GetText() == nullptr ? "" : node.element->GetText();
  std::vector<double> numbers;
  for (const std::string_view word : words_of(text)) {
    const std::optional<double> number = number_of(word);
    if (!number || std::isnan(*number))
      node.refuse("<" + std::string(node.element->Name()) + ">: " + quoted(word) + " is not a number");
    numbers.push_back(*number);
  }
  return numbers;
}

double sdf_number(const XmlNode& node, const char* name) {
  const XmlElement* child = sdf_child(node, name);
  if (child == nullptr) node.refuse("<" + std::string(node.element->Name()) + "> needs <" + name + ">");
  const std::vector<double> numbers = sdf_numbers({node.file, child});
  if (numbers.size() != 1) node.file->refuse(*child, "<" + std::string(name) + "> must be one number");
  return numbers.front();
}

double sdf_number(const XmlNode& node, const char* name, double otherwise) {
  return sdf_child(node, name) == nullptr ? otherwise : sdf_number(node, name);
}

Eigen::Vector3d sdf_vector(const XmlNode& node, const char* name, const Eigen::Vector3d& otherwise) {
  const XmlElement* child = sdf_child(node, name);
  if (child == nullptr) return otherwise;
  const std::vector<double> numbers = sdf_numbers({node.file, child});
  Eigen::Vector3d vector = numbers.size() == 3 ? Eigen::Vector3d(numbers.data()) : otherwise;
  if (numbers.size() != 3 || !vector.allFinite())
    node.file->refuse(*child, "<" + std::string(name) + "> must be three finite numbers");
  return vector;
}

Placement sdf_pose(const XmlNode& node) {
  const XmlElement* child = sdf_child(node, "pose");
  if (child == nullptr) return Placement::identity(3);
  const XmlNode pose{node.file, child};
  const std::vector<double> v = sdf_numbers(pose);
  if (v.empty()) return Placement::identity(3);
  const char* format = child->Attribute("rotation_format");
  const bool quaternion = format != nullptr && std::string_view(format) == "quat_xyzw";
  if (v.size() != (quaternion ? 7U : 6U))
    pose.refuse("<pose> has " + std::to_string(v.size()) + " numbers, " + (quaternion ? "7" : "6") +
                " are expected");
  for (const double number : v) {
    if (!std::isfinite(number)) pose.refuse("<pose> must be finite numbers");
  }
  const Eigen::Vector3d at(v[0], v[1], v[2]);
  if (quaternion) {
    const Eigen::Quaterniond turn(v[6], v[3], v[4], v[5]);
    if (!(turn.norm() > 0)) pose.refuse("the quaternion of a <pose> is 0");
    return make_placement(turn.normalized().toRotationMatrix(), at);
  }
  const bool degrees = child->BoolAttribute("degrees", false);
  const Eigen::Vector3d rpy = Eigen::Vector3d(v[3], v[4], v[5]) * (degrees ? EIGEN_PI / 180 : 1);
  return make_placement(rotation_of_rpy(rpy), at);
}

std::string sdf_relative_to(const XmlNode& node) {
  const XmlElement* pose = sdf_child(node, "pose");
  const char* frame = pose == nullptr ? nullptr : pose->Attribute("relative_to");
  return frame == nullptr ? "" : frame;
}

void SdfFrames::add(const XmlNode& node, const std::string& name, const std::string& relative_to,
                    const Placement& pose) {
  if (!frames_.emplace(name, Frame{relative_to, pose}).second)
    node.refuse("a second model, link, joint or frame '" + name + "'");
}

Placement SdfFrames::in_world(const XmlNode& node, const std::string& name) const {
  Placement place = Placement::identity(3);
  std::string here = name;
  for (std::size_t steps = 0; !here.empty(); ++steps) {
    const auto found = frames_.find(here);
    if (found == frames_.end()) node.refuse("there is no frame '" + here + "'");
    if (steps > frames_.size()) node.refuse("the pose of '" + name + "' is relative to itself");
    place = found->second.pose * place;
    here = found->second.relative_to;
  }
  return place;
}

}  // namespace raygauge::cli
