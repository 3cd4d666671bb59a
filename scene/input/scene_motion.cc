// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/input/scene_motion.h"

#include <utility>
#include <vector>

#include "cli/input/pose_table.h"
#include "cli/input/toml_refusal.h"
#include "cli/input/toml_values.h"
#include "raygauge/exceptions.h"
#include "scene/input/motion_file.h"

namespace raygauge::cli {
namespace {

Placement pose_of(const toml::table& table, int n, const std::string& key) {
  const PoseEntry pose = read_pose_entry(table, n, key);
  return placed(table, [&] { return make_placement(pose.R, pose.t); });
}

MotionPointer read_keyframes(const toml::node& node, int n) {
  const toml::array* list = node.as_array();
  if (list == nullptr) refuse(node, "motion.keyframes must be a list of tables");
  std::vector<double> times;
  std::vector<Placement> frames;
  std::vector<std::string> known = pose_keys();
  known.emplace_back("time");
  for (const toml::node& element : *list) {
    const toml::table* frame = element.as_table();
    if (frame == nullptr) refuse(element, "a keyframe must be a table with a time");
    reject_unknown_keys(*frame, "key of a keyframe", known);
    if (!frame->contains("time")) refuse(element, "a keyframe needs a time");
    times.push_back(read_number(*frame->get("time"), "keyframe.time"));
    frames.push_back(pose_of(*frame, n, "keyframe"));
  }
  return placed(node, [&]() -> MotionPointer { return std::make_shared<KeyframeMotion>(times, frames); });
}

MotionPointer read_rates(const toml::table& table, Placement first, int n, double start) {
  TwistMotion::Rates rates;
  rates.velocity.setZero(n);
  if (const toml::node* node = table.get("velocity"))
    rates.velocity = vector_of_length(*node, "motion.velocity", n);
  if (const toml::node* node = table.get("acceleration")) {
    rates.acceleration = vector_of_length(*node, "motion.acceleration", n);
  }
  if (const toml::node* node = table.get("spin")) {
    if (n == 2) rates.spin[2] = read_number(*node, "motion.spin");
    if (n != 2) rates.spin = vector_of_length(*node, "motion.spin", 3);
  }
  return placed(table, [&]() -> MotionPointer {
    return std::make_shared<TwistMotion>(std::move(first), rates, start);
  });
}

}  // namespace

Placement read_pose(const toml::table& table, int dimension, const std::string& key) {
  reject_unknown_keys(table, "key of a pose", pose_keys());
  return pose_of(table, dimension, key);
}

MotionPointer read_motion(const toml::table& body, int dimension, const std::filesystem::path& folder,
                          double start) {
  Placement first = Placement::identity(dimension);
  if (const toml::node* node = body.get("pose")) {
    if (!node->is_table()) refuse(*node, "pose must be a table, as in { translation = [1, 2] }");
    first = read_pose(*node->as_table(), dimension, "pose");
  }
  const toml::node* node = body.get("motion");
  if (node == nullptr) return std::make_shared<StaticMotion>(first);
  const toml::table* table = &read_table(*node, "motion");
  reject_unknown_keys(*table, "key of a motion", {"keyframes", "file", "velocity", "acceleration", "spin"});
  const toml::node* keyframes = table->get("keyframes");
  const toml::node* file = table->get("file");
  if ((keyframes != nullptr || file != nullptr) && (body.contains("pose") || table->size() > 1)) {
    refuse(*node, "keyframes and file say all of a motion: give no pose, no rates and not both");
  }
  if (keyframes != nullptr) return read_keyframes(*keyframes, dimension);
  if (file != nullptr) {
    const std::string name = (folder / read_text(*file, "motion.file")).string();
    return placed(*file, [&] { return read_pose_file(name, dimension); });
  }
  return read_rates(*table, first, dimension, start);
}

}  // namespace raygauge::cli
