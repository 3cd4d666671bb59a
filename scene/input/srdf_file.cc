// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/input/srdf_file.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "cli/input/input_file.h"
#include "cli/input/xml_values.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

/// Of robots that nothing here moves, or of other programs.
constexpr std::string_view kWithoutEffect[] = {"virtual_joint", "passive_joint", "joint_property",
                                               "link_sphere_approximation"};

template <class Visit>
void for_each_child(const XmlElement& element, const Visit& visit) {
  for (const XmlElement* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    visit(*child, std::string_view(child->Name()));
  }
}

class SrdfReader {
 public:
  SrdfReader(const std::string& path, const Robot& robot)
      : robot_(robot), file_(read_text_input(path), path) {
    for (std::size_t i = 0; i < robot.links.size(); ++i) {
      link_numbers_[robot.links[i].name] = static_cast<int>(i);
      if (!robot.links[i].joint.empty()) below_[robot.links[i].joint] = static_cast<int>(i);
    }
  }

  RobotSemantics read() {
    const XmlElement& root = file_.root();
    if (std::string_view(root.Name()) != "robot")
      file_.refuse(root, std::string("not an SRDF file: its root is <") + root.Name() + ">, not <robot>");
    for_each_child(root, [&](const XmlElement& child, std::string_view kind) { take(child, kind); });
    for_each_child(root, [&](const XmlElement& child, std::string_view kind) {
      if (kind == "group_state") take_state(child);
      if (kind == "end_effector") take_end_effector(child);
    });
    take_pairs();
    return std::move(result_);
  }

 private:
  /// States need groups, and pairs each other; they wait.
  void take(const XmlElement& element, std::string_view kind) {
    if (kind == "group") {
      take_group(element);
    } else if (kind == "disable_collisions") {
      if (const auto pair = pair_of(element)) {
        const char* reason = element.Attribute("reason");
        reasons_[*pair] = reason == nullptr ? "" : reason;
      }
    } else if (kind == "enable_collisions") {
      if (const auto pair = pair_of(element)) enabled_.insert(*pair);
    } else if (kind == "disable_default_collisions") {
      if (const auto link = link_of(element, "link")) off_.insert(*link);
    } else if (kind == "link" || kind == "joint") {
      file_.refuse(element, "<" + std::string(kind) + "> is of a URDF file");
    } else if (kind != "group_state" && kind != "end_effector" &&
               std::find(std::begin(kWithoutEffect), std::end(kWithoutEffect), kind) ==
                   std::end(kWithoutEffect)) {
      file_.refuse(element, "<" + std::string(kind) + "> is not understood");
    }
  }

  void note(const std::string& what) {
    if (std::find(result_.unknown.begin(), result_.unknown.end(), what) == result_.unknown.end())
      result_.unknown.push_back(what);
  }

  std::optional<int> link_of(const XmlElement& element, const char* attribute) {
    const std::string name = file_.text(element, attribute);
    const auto found = link_numbers_.find(name);
    if (found != link_numbers_.end()) return found->second;
    note("link '" + name + "'");
    return std::nullopt;
  }

  std::optional<std::pair<int, int>> pair_of(const XmlElement& element) {
    const auto a = link_of(element, "link1"), b = link_of(element, "link2");
    if (!a || !b) return std::nullopt;
    if (*a == *b) file_.refuse(element, "a pair of one link");
    return std::minmax({*a, *b});
  }

  /// The link below the joint.
  std::optional<int> joint_of(const XmlElement& element, const char* attribute) {
    const std::string name = file_.text(element, attribute);
    const auto found = below_.find(name);
    if (found != below_.end()) return found->second;
    note("joint '" + name + "'");
    return std::nullopt;
  }

  void take_group(const XmlElement& element) {
    JointGroup group;
    group.name = file_.text(element, "name");
    if (find(group.name) != nullptr) file_.refuse(element, "a second group '" + group.name + "'");
    group.joints.assign(robot_.joints.size(), false);
    std::set<int> links;
    for_each_child(element, [&](const XmlElement& child, std::string_view kind) {
      take_member(child, kind, group, links);
    });
    group.links.assign(links.begin(), links.end());
    result_.groups.push_back(std::move(group));
  }

  void take_member(const XmlElement& child, std::string_view kind, JointGroup& group, std::set<int>& links) {
    if (kind == "link") {
      if (const auto link = link_of(child, "name")) add(*link, group, links);
    } else if (kind == "joint" || kind == "passive_joint") {
      const auto link = joint_of(child, "name");
      if (link && kind == "joint") add(*link, group, links);
    } else if (kind == "chain") {
      take_chain(child, group, links);
    } else if (kind == "group") {
      const std::string name = file_.text(child, "name");
      const JointGroup* other = find(name);
      if (other == nullptr) file_.refuse(child, "there is no group '" + name + "' before this one");
      links.insert(other->links.begin(), other->links.end());
      for (std::size_t i = 0; i < group.joints.size(); ++i)
        if (other->joints[i]) group.joints[i] = true;
    } else {
      file_.refuse(child, "<" + std::string(kind) + "> of group '" + group.name + "' is not understood");
    }
  }

  /// A link, and the joint above it.
  void add(int link, JointGroup& group, std::set<int>& links) const {
    links.insert(link);
    const TreeLink& step = robot_.tree.links[static_cast<std::size_t>(link)];
    if (step.kind != JointKind::fixed) group.joints[static_cast<std::size_t>(step.joint)] = true;
  }

  /// From the tip up to the base; the joint above the base does not belong.
  void take_chain(const XmlElement& child, JointGroup& group, std::set<int>& links) {
    const auto base = link_of(child, "base_link"), tip = link_of(child, "tip_link");
    if (!base || !tip) return;
    for (int link = *tip; link != *base; link = robot_.tree.links[static_cast<std::size_t>(link)].parent) {
      if (link < 0) {
        file_.refuse(child, "no chain goes from '" + file_.text(child, "base_link") + "' to '" +
                                file_.text(child, "tip_link") + "'");
      }
      add(link, group, links);
    }
    links.insert(*base);
  }

  void take_state(const XmlElement& element) {
    const std::string name = file_.text(element, "name"), of = file_.text(element, "group");
    JointGroup* group = find(of);
    if (group == nullptr) file_.refuse(element, "there is no group '" + of + "'");
    std::map<int, double>& values = group->states[name];
    for_each_child(element, [&](const XmlElement& child, std::string_view kind) {
      if (kind != "joint") file_.refuse(child, "<" + std::string(kind) + "> of a state is not understood");
      const auto value = file_.number(child, "value");
      const std::string joint = file_.text(child, "name");
      const auto found = std::find(robot_.joints.begin(), robot_.joints.end(), joint);
      if (found != robot_.joints.end()) {
        values[static_cast<int>(found - robot_.joints.begin())] = value;
      } else if (robot_.without_value.count(joint) == 0) {
        note("joint '" + joint + "'");
      }
    });
  }

  void take_end_effector(const XmlElement& element) {
    EndEffector effector{file_.text(element, "name"), file_.text(element, "group"),
                         file_.text(element, "parent_link"), ""};
    link_of(element, "parent_link");
    if (const char* parent = element.Attribute("parent_group")) effector.parent_group = parent;
    for (const std::string& group : {effector.group, effector.parent_group}) {
      if (!group.empty() && find(group) == nullptr)
        file_.refuse(element, "there is no group '" + group + "'");
    }
    result_.end_effectors.push_back(std::move(effector));
  }

  /// Links that are off by default meet none, but for pairs that are enabled.
  void take_pairs() {
    for (const int off : off_) {
      for (int other = 0; other < static_cast<int>(robot_.links.size()); ++other) {
        const std::pair<int, int> pair = std::minmax({off, other});
        if (other != off && enabled_.count(pair) == 0) reasons_.emplace(pair, "Default");
      }
    }
    for (const auto& [pair, reason] : reasons_) result_.disabled.push_back({pair.first, pair.second, reason});
  }

  JointGroup* find(const std::string& name) {
    const auto found = std::find_if(result_.groups.begin(), result_.groups.end(),
                                    [&](const JointGroup& group) { return group.name == name; });
    return found == result_.groups.end() ? nullptr : &*found;
  }

  const Robot& robot_;
  XmlFile file_;
  RobotSemantics result_;
  std::map<std::string, int> link_numbers_, below_;
  std::map<std::pair<int, int>, std::string> reasons_;
  std::set<std::pair<int, int>> enabled_;
  std::set<int> off_;
};

}  // namespace

const JointGroup& RobotSemantics::group(const std::string& name, const std::string& place) const {
  std::vector<std::string> known;
  for (const JointGroup& group : groups) {
    if (group.name == name) return group;
    known.push_back(group.name);
  }
  throw UnknownNameError("group of the SRDF file", name, known, place);
}

RobotSemantics read_srdf(const std::string& path, const Robot& robot) {
  return SrdfReader(path, robot).read();
}

}  // namespace raygauge::cli
