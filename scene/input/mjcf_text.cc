// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/input/mjcf_text.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "cli/input/input_file.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

namespace fs = std::filesystem;

const std::vector<const char*> kOrientations = {"quat", "axisangle", "euler", "xyaxes", "zaxis"};

std::vector<double> counted_numbers(const XmlNode& node, const char* name, std::size_t least,
                                    std::size_t most) {
  std::vector<double> numbers = node.file->numbers(*node.element, name);
  if (numbers.size() < least || numbers.size() > most)
    node.refuse(std::string(name) + " has " + std::to_string(numbers.size()) + " numbers, " +
                std::to_string(least) + (most > least ? " or more" : "") + " are expected");
  return numbers;
}

Eigen::Vector3d unit(const XmlNode& node, const char* name, const Eigen::Vector3d& vector) {
  if (!(vector.norm() > 0)) node.refuse(std::string(name) + " has no direction");
  return vector.normalized();
}

}  // namespace

MjcfElement::MjcfElement(const XmlNode& node, const MjcfClass* defaults) : levels_{node} {
  const std::string_view kind = node.element->Name();
  for (; defaults != nullptr; defaults = defaults->around) {
    for (std::size_t k = defaults->elements.size(); k-- > 0;) {
      if (kind == defaults->elements[k].element->Name()) levels_.push_back(defaults->elements[k]);
    }
  }
}

const XmlNode* MjcfElement::find(const char* name) const {
  for (const XmlNode& level : levels_) {
    if (level.element->Attribute(name) != nullptr) return &level;
  }
  return nullptr;
}

const XmlNode* MjcfElement::first_with(const std::vector<const char*>& names, const char*& which) const {
  for (const XmlNode& level : levels_) {
    for (const char* name : names) {
      which = name;
      if (level.element->Attribute(name) != nullptr) return &level;
    }
  }
  return nullptr;
}

std::string MjcfElement::text(const char* name, const std::string& otherwise) const {
  const XmlNode* level = find(name);
  return level == nullptr ? otherwise : level->text(name);
}

double MjcfElement::number(const char* name, double otherwise) const {
  const XmlNode* level = find(name);
  return level == nullptr ? otherwise : level->file->number(*level->element, name);
}

Eigen::Vector3d MjcfElement::vector(const char* name, const Eigen::Vector3d& otherwise) const {
  const XmlNode* level = find(name);
  return level == nullptr ? otherwise : level->file->vector(*level->element, name, otherwise);
}

std::vector<double> MjcfElement::numbers(const char* name, std::size_t least, std::size_t most) const {
  const XmlNode* level = find(name);
  return counted_numbers(level == nullptr ? node() : *level, name, least, most);
}

bool MjcfElement::is_true(const char* name, bool otherwise) const {
  const std::string value = text(name, otherwise ? "true" : "false");
  if (value != "true" && value != "false") find(name)->refuse(std::string(name) + " must be true or false");
  return value == "true";
}

MjcfText::MjcfText(const RobotSource& source) : source_(source) {
  classes_[main_class_];
  for (const XmlNode& compiler : section("")) {
    if (std::string_view(compiler.element->Name()) == "compiler") read_compiler(compiler);
  }
  for (const XmlNode& part : section("")) {
    if (std::string_view(part.element->Name()) == "default") read_defaults(part, nullptr);
  }
}

const XmlFile& MjcfText::load(const XmlNode& include) {
  const auto known = file_of_include_.find(include.element);
  if (known != file_of_include_.end()) return *known->second;
  const std::string path = (fs::path(source_.path).parent_path() / include.text("file")).string();
  if (!loaded_.emplace(path, true).second) include.refuse(path + " is included a second time");
  std::error_code ignored;
  if (!fs::exists(path, ignored)) include.refuse("there is no file " + path);
  const XmlFile& file = included_.emplace_back(read_text_input(path), path);
  const std::string_view root = file.root().Name();
  if (root != "mujoco" && root != "mujocoinclude")
    file.refuse(file.root(), "not MJCF: its root is <" + std::string(root) + ">");
  return *(file_of_include_[include.element] = &file);
}

std::vector<XmlNode> MjcfText::children(const XmlNode& parent) {
  std::vector<XmlNode> all;
  for (const XmlElement* child = parent.element->FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    const XmlNode node{parent.file, child};
    if (std::string_view(child->Name()) != "include") {
      all.push_back(node);
      continue;
    }
    const XmlFile& file = load(node);
    const std::vector<XmlNode> inside = children({&file, &file.root()});
    all.insert(all.end(), inside.begin(), inside.end());
  }
  return all;
}

std::vector<XmlNode> MjcfText::section(const std::string& name) {
  std::vector<XmlNode> all = children({&source_.file, &source_.file.root()});
  if (name.empty()) return all;
  std::vector<XmlNode> inside;
  for (const XmlNode& part : all) {
    if (part.element->Name() != name) continue;
    const std::vector<XmlNode> own = children(part);
    inside.insert(inside.end(), own.begin(), own.end());
  }
  return inside;
}

void MjcfText::read_compiler(const XmlNode& compiler) {
  const MjcfElement element(compiler, nullptr);
  const std::string angle = element.text("angle", "");
  if (angle == "radian") {
    angle_unit_ = 1;
  } else if (angle == "degree") {
    angle_unit_ = EIGEN_PI / 180;
  } else if (!angle.empty()) {
    compiler.refuse("angle must be radian or degree, got '" + angle + "'");
  }
  if (element.text("coordinate", "local") != "local")
    compiler.refuse("coordinate = global is not read: save the model with local coordinates");
  eulerseq_ = element.text("eulerseq", eulerseq_);
  if (eulerseq_.size() != 3 || eulerseq_.find_first_not_of("xyzXYZ") != std::string::npos)
    compiler.refuse("eulerseq must be three of x, y, z, X, Y and Z, got '" + eulerseq_ + "'");
  mesh_folder_ = element.text("meshdir", element.text("assetdir", mesh_folder_));
  autolimits_ = element.is_true("autolimits", autolimits_);
  strip_path_ = element.is_true("strippath", strip_path_);
}

void MjcfText::read_defaults(const XmlNode& node, MjcfClass* around) {
  const char* name = node.element->Attribute("class");
  if (around != nullptr && name == nullptr) node.refuse("a <default> in another one needs a class");
  if (around == nullptr && name != nullptr && main_class_ == "main" && name != main_class_) {
    classes_.erase(main_class_);  // the class of all may have a name of its own
    main_class_ = name;
  }
  MjcfClass& here = classes_[name == nullptr ? main_class_ : name];
  here.around = around;
  for (const XmlNode& child : children(node)) {
    if (std::string_view(child.element->Name()) == "default")
      read_defaults(child, &here);
    else
      here.elements.push_back(child);
  }
}

MjcfElement MjcfText::with_defaults(const XmlNode& node, const std::string& childclass) const {
  const char* own = node.element->Attribute("class");
  const std::string name = own != nullptr ? own : (childclass.empty() ? main_class_ : childclass);
  const auto found = classes_.find(name);
  if (found == classes_.end()) node.refuse("there is no default class '" + name + "'");
  return {node, &found->second};
}

Placement MjcfText::place_of(const MjcfElement& element) const {
  const Eigen::Vector3d pos = element.vector("pos", Eigen::Vector3d::Zero());
  return make_placement(rotation_of(element), pos);
}

Eigen::Matrix3d MjcfText::rotation_of(const MjcfElement& element) const {
  const char* attribute = nullptr;
  const XmlNode* level = element.first_with(kOrientations, attribute);
  if (level == nullptr) return Eigen::Matrix3d::Identity();
  return rotation_by(*level, attribute);
}

Eigen::Matrix3d MjcfText::rotation_by(const XmlNode& level, const char* attribute) const {
  using Eigen::AngleAxisd, Eigen::Vector3d;
  const std::string_view kind = attribute;
  const std::size_t count = kind == "xyaxes" ? 6 : kind == "quat" || kind == "axisangle" ? 4 : 3;
  const std::vector<double> v = counted_numbers(level, attribute, count, count);
  const Vector3d first(v[0], v[1], v[2]);
  if (kind == "quat") {
    const Eigen::Quaterniond quaternion(v[0], v[1], v[2], v[3]);
    if (!(quaternion.norm() > 0)) level.refuse("quat is 0");
    return quaternion.normalized().toRotationMatrix();
  }
  if (kind == "axisangle") return AngleAxisd(radians(v[3]), unit(level, attribute, first)).toRotationMatrix();
  if (kind == "zaxis")
    return Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), unit(level, attribute, first))
        .toRotationMatrix();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  if (kind == "xyaxes") {
    const Vector3d x = unit(level, attribute, first), y(v[3], v[4], v[5]);
    rotation << x, unit(level, attribute, y - x.dot(y) * x), Vector3d::Zero();
    rotation.col(2) = rotation.col(0).cross(rotation.col(1));
    return rotation;
  }
  for (std::size_t k = 0; k < 3; ++k) {  // small letters: axes that turn along
    const bool along = eulerseq_[k] >= 'x';
    const Eigen::Matrix3d turn =
        AngleAxisd(radians(v[k]), Vector3d::Unit(eulerseq_[k] - (along ? 'x' : 'X'))).toRotationMatrix();
    rotation = along ? Eigen::Matrix3d(rotation * turn) : Eigen::Matrix3d(turn * rotation);
  }
  return rotation;
}

std::string MjcfText::mesh_path(const std::string& file) const {
  const fs::path name = strip_path_ ? fs::path(file).filename() : fs::path(file);
  return (fs::path(source_.path).parent_path() / mesh_folder_ / name).string();
}

}  // namespace raygauge::cli
