// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/input/scene_source.h"

#include <algorithm>
#include <filesystem>
#include <tuple>
#include <utility>

#include "cli/input/mesh_file.h"
#include "cli/input/mesh_object_file.h"
#include "cli/input/set_file.h"
#include "cli/input/set_source.h"
#include "cli/input/shapes.h"
#include "cli/input/toml_refusal.h"
#include "cli/input/toml_section.h"
#include "engine/numerics/floating_point.h"
#include "raygauge/exceptions.h"
#include "scene/input/scaled_set.h"
#include "scene/input/scene_dynamics.h"
#include "scene/input/scene_motion.h"
#include "scene/input/scene_robot.h"

namespace raygauge::cli {
namespace {

/// The entries of [[name]]; none where there are none.
std::vector<const toml::table*> tables_of(const toml::table& root, const std::string& name) {
  std::vector<const toml::table*> tables;
  const toml::node* node = root.get(name);
  if (node == nullptr) return tables;
  if (!node->is_array()) refuse(*node, name + " must be a list of tables, [[" + name + "]]");
  for (const toml::node& element : *node->as_array()) tables.push_back(&read_table(element, name));
  return tables;
}

/// One text or a list of them.
std::vector<std::string> texts_of(const toml::node& node, const std::string& key) {
  if (!node.is_array()) return {read_text(node, key)};
  std::vector<std::string> texts;
  for (const toml::node& element : *node.as_array()) texts.push_back(read_text(element, key));
  return texts;
}

class SceneReader {
 public:
  SceneReader(const std::string& path, const std::vector<std::string>& overrides, const RobotMeshes& meshes)
      : toml_(read_toml(path, overrides)),
        folder_(std::filesystem::path(path).parent_path()),
        meshes_(meshes) {
    source_.text = toml_.text;
    scene().name = std::filesystem::path(path).stem().string();
  }

  SceneSource read() {
    const toml::table& root = toml_.root;
    reject_unknown_keys(root, "key", scene_keys().at(""));
    const TomlSection keys(root, "");
    keys.text("name", scene().name);
    keys.integer("dimension", {1, kMostSceneDimensions}, dimension_);
    read_time();
    for (const toml::table* table : tables_of(root, "body")) read_body(*table);
    for (const toml::table* table : tables_of(root, "robot")) read_robot(*table);
    if (scene().bodies.empty()) throw EmptySetError(toml_.path + ": a scene needs a [[body]] or a [[robot]]");
    read_ignored();
    for (const toml::table* table : tables_of(root, "query")) read_query(*table);
    read_reactions();
    if (scene().queries.empty() && !source_.dynamics)
      throw InvalidParameterError(toml_.path + ": a scene needs a [[query]], or [dynamics]");
    placed(root, [&] {
      check_scene(scene());
      if (source_.dynamics) check_dynamics(scene(), *source_.dynamics);
      return 0;
    });
    if (const toml::node* node = root.get("plan")) {
      source_.plan = read_plan(read_table(*node, "plan"), scene(), robots_);
      source_.plan->stand(scene());
    }
    for (const SceneRobot& robot : robots_) {
      const int count = static_cast<int>(robot.own.bodies.size());
      const std::string note = note_of_contacts(scene(), robot.own.name, robot.first, count);
      if (!note.empty()) source_.notes.push_back(note);
    }
    return std::move(source_);
  }

 private:
  Scene& scene() { return source_.scene; }

  void read_time() {
    const toml::node* node = toml_.root.get("time");
    if (node == nullptr) {
      scene().instants = {0};
      return;
    }
    const toml::table& table = read_table(*node, "time");
    reject_unknown_keys(table, "[time] key", scene_keys().at("time"));
    const toml::node* instants = table.get("instants");
    if (instants != nullptr && instants->is_array()) {
      const Eigen::VectorXd list = read_vector(*instants, "time.instants");
      scene().instants.assign(list.data(), list.data() + list.size());
      if (table.size() > 1) refuse(table, "time.instants lists all: give no from or to");
      return;
    }
    const double from = table.contains("from") ? read_number(*table.get("from"), "time.from") : 0.0;
    const double to = table.contains("to") ? read_number(*table.get("to"), "time.to") : from;
    if (!(from <= to)) refuse(table, "time.to must not be before time.from");
    const std::int64_t usual = from < to ? 2 : 1;
    const std::int64_t count =
        instants == nullptr ? usual : read_integer(*instants, "time.instants", {1, 1e7});
    if (count > 1 && from == to) refuse(table, "[time] needs to, after from, for more than one instant");
    if (count == 1 && from < to) refuse(table, "[time] has one instant, from: give no to");
    for (std::int64_t k = 0; k < count; ++k) {
      const double s = static_cast<double>(k) / static_cast<double>(std::max<std::int64_t>(count - 1, 1));
      scene().instants.push_back(k == count - 1 ? to : from + s * (to - from));
    }
  }

  SetPointer read_named(const std::string& name) { return read_set_source(name, {}, &source_.notes); }

  /// A set by name or by a table; a mesh that is named is taken `as_it_is`, or its hull.
  SetPointer set_of(const toml::node& node, const std::string& what, bool as_it_is) {
    if (node.is_string()) {
      const std::string name = (folder_ / read_text(node, what)).string();
      return placed(node, [&] { return as_it_is ? set_as_it_is(name) : read_named(name); });
    }
    return read_set_table(read_table(node, what), folder_,
                          [this](const std::string& name) { return read_named(name); });
  }

  SetPointer set_as_it_is(const std::string& name) {
    return is_mesh_file(name) ? take_mesh(read_mesh(name), name, "", source_.notes).front()
                              : read_named(name);
  }

  /// body.file as body.as says.
  std::vector<SetPointer> read_file(const toml::node& file, const toml::table& table) {
    std::vector<std::string> names = texts_of(file, "body.file");
    for (std::string& name : names) name = (folder_ / name).string();
    const toml::node* node = table.get("as");
    const std::string as = node == nullptr ? "" : read_text(*node, "body.as");
    if (node != nullptr) check_way_to_take_a_mesh(as, "body.as", place_of(*node));
    if (file.is_array() && (as != "parts" || names.empty()))
      refuse(file, "a list of files is for as = \"parts\", a convex part each");
    if (as == "parts") return read_parts(names, source_.notes);
    const std::string& name = names.front();
    if (as.empty()) return {set_as_it_is(name)};
    if (!is_mesh_file(name))
      refuse(*node, "body.as is for meshes and folders of them, which " + name + " is not");
    return take_mesh(read_mesh(name), name, as, source_.notes);
  }

  std::vector<SetPointer> parts_of(const toml::table& table) {
    const int given = static_cast<int>(table.contains("shape")) + static_cast<int>(table.contains("parts")) +
                      static_cast<int>(table.contains("file"));
    if (given != 1) refuse(table, "a body needs one of shape, parts and file");
    std::vector<SetPointer> parts;
    if (const toml::node* node = table.get("shape")) parts.push_back(set_of(*node, "body.shape", true));
    if (const toml::node* node = table.get("parts")) {
      if (!node->is_array()) refuse(*node, "body.parts must be a list of shapes");
      for (const toml::node& element : *node->as_array())
        parts.push_back(set_of(element, "body.parts", true));
    }
    if (const toml::node* node = table.get("file")) {
      parts = placed(*node, [&] { return read_file(*node, table); });
    } else if (const toml::node* as = table.get("as")) {
      refuse(*as, "body.as says how a mesh is taken that body.file names");
    }
    if (const toml::node* node = table.get("scale")) {
      const double scale = read_real(*node, "body.scale", {-kLargestScale, kLargestScale});
      if (scale == 0) refuse(*node, "body.scale must not be 0");
      for (SetPointer& part : parts) part = placed(*node, [&] { return scaled(part, scale); });
    }
    return parts;
  }

  // A shape's own keys beside its name are the usual slip.
  void check_shape_is_no_name(const toml::table& table) const {
    const auto name = table["shape"].value<std::string>();
    const auto is_named = [&name](const Shape& shape) { return shape.name == *name; };
    if (name && !std::filesystem::exists(folder_ / *name) &&
        std::any_of(shapes().begin(), shapes().end(), is_named))
      refuse(*table.get("shape"),
             "body.shape names a set file or is a table: shape = { shape = \"" + *name + "\", ... }");
  }

  void read_body(const toml::table& table) {
    check_shape_is_no_name(table);
    reject_unknown_keys(table, "[[body]] key", scene_keys().at("body"));
    const std::vector<SetPointer> parts = parts_of(table);
    if (dimension_ == 0) dimension_ = parts.front()->dimension();
    std::string name = "body" + std::to_string(scene().bodies.size() + 1);
    TomlSection(table, "body").text("name", name);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i]->dimension() != dimension_)
        refuse(table, "part " + std::to_string(i + 1) + " of body '" + name + "' lives in R^" +
                          std::to_string(parts[i]->dimension()) + ", the scene in R^" +
                          std::to_string(dimension_));
    }
    const MotionPointer motion = read_motion(table, dimension_, folder_, scene().instants.front());
    const Body body = placed(table, [&] { return make_body(name, parts, motion); });
    reactions_.emplace_back(&table, read_body_dynamics(table, body));
    add(table, body,
        table.contains("group") ? texts_of(*table.get("group"), "body.group") : std::vector<std::string>());
  }

  void add(const toml::table& table, const Body& body, const std::vector<std::string>& group_names) {
    const int number = static_cast<int>(scene().bodies.size());
    if (groups_.count(body.name) != 0)
      refuse(table, "there is a body or a group '" + body.name + "' already");
    groups_[body.name] = {number};
    single_[body.name] = true;
    for (const std::string& name : group_names) {
      if (single_[name]) refuse(table, "the group '" + name + "' has the name of a body");
      groups_[name].push_back(number);
    }
    scene().bodies.push_back(body);
  }

  void read_robot(const toml::table& table) {
    if (dimension_ == 0) dimension_ = 3;
    if (dimension_ != 3) refuse(table, "a robot needs a scene of 3 dimensions");
    const int first = static_cast<int>(scene().bodies.size());
    RobotBodies robot =
        read_robot_bodies(table, folder_, scene().instants.front(), scene().instants.back(), meshes_);
    std::vector<std::string> groups = {robot.name};
    if (const toml::node* node = table.get("group")) {
      for (const std::string& group : texts_of(*node, "robot.group")) groups.push_back(group);
    }
    for (const Body& body : robot.bodies) add(table, body, groups);
    reactions_.resize(scene().bodies.size());
    for (const auto& [a, b] : robot.joined) scene().ignored.emplace_back(first + a, first + b);
    for (const std::string& note : robot.notes) add_note(note, source_.notes);
    robots_.push_back({std::move(robot), first});
  }

  const std::vector<int>& bodies_named(const std::string& name, const toml::node& node) {
    const auto found = groups_.find(name);
    if (found != groups_.end()) return found->second;
    std::vector<std::string> known;
    for (const auto& [group, members] : groups_) known.push_back(group);
    throw UnknownNameError("body or group", name, known, place_of(node));
  }

  void read_ignored() {
    const toml::node* node = toml_.root.get("ignore");
    if (node == nullptr) return;
    if (!node->is_array()) refuse(*node, "ignore must be a list of pairs of names");
    for (const toml::node& element : *node->as_array()) {
      const std::vector<std::string> pair = texts_of(element, "ignore");
      if (pair.size() != 2) refuse(element, "ignore must be a list of pairs of names");
      for (const int a : bodies_named(pair[0], element)) {
        for (const int b : bodies_named(pair[1], element)) scene().ignored.emplace_back(a, b);
      }
    }
  }

  /// [dynamics], or the refusal of keys that have no effect without it.
  void read_reactions() {
    const toml::node* node = toml_.root.get("dynamics");
    if (node != nullptr) {
      source_.dynamics =
          read_dynamics(read_table(*node, "dynamics"), dimension_,
                        [this](const std::string& name, const toml::node& at) -> const std::vector<int>& {
                          return bodies_named(name, at);
                        });
      set_accuracies(source_, read_accuracies(*node->as_table()));
      source_.engines = read_engines(*node->as_table());
    }
    for (const auto& [table, how] : reactions_) {
      if (source_.dynamics) source_.dynamics->bodies.push_back(how);
      if (source_.dynamics || table == nullptr) continue;
      for (const std::string& key : body_dynamics_keys()) {
        if (table->contains(key))
          refuse(*table->get(key), "body." + key + " has no effect without [dynamics]");
      }
    }
  }

  void read_query(const toml::table& table) {
    reject_unknown_keys(table, "[[query]] key", scene_keys().at("query"));
    const TomlSection keys(table, "query");
    SceneQuery query;
    query.name = "query" + std::to_string(scene().queries.size() + 1);
    keys.text("name", query.name);
    read_groups(table, query);
    query.effects = read_effects(table);
    const std::string metric = read_metric(table, query);
    const Range positive{0, kInfinity, true};
    keys.real("within", positive, query.within);
    keys.real("contact", positive, query.contact);
    keys.integer("nearest", {1, 1e6}, query.nearest);
    keys.real("clearance_tolerance", {0, 1, true}, query.clearance_tolerance);
    keys.boolean("every_instant", query.every_instant);
    require_use(table, query.effects);
    std::vector<double> tolerances = {query.tolerance};
    keys.reals("tolerance", {0, 1, true}, tolerances);
    for (const double tolerance : tolerances) {
      query.tolerance = tolerance;
      scene().queries.push_back(query);
      source_.metrics.push_back(metric);
    }
  }

  /// A key that no effect of the query looks at is refused.
  static void require_use(const toml::table& table, SceneEffects effects) {
    const std::vector<std::tuple<const char*, SceneEffects, const char*>> uses = {
        {"contact", kContinuousEffects, "time_of_impact or clearance"},
        {"clearance_tolerance", SceneEffects::clearance, "clearance"},
        {"every_instant", SceneEffects::separated, "separated"}};
    for (const auto& [key, users, names] : uses) {
      if (table.contains(key) && !has_effect(effects, users))
        refuse(*table.get(key), std::string("query.") + key + " has no effect without " + names);
    }
  }

  void read_groups(const toml::table& table, SceneQuery& query) {
    const toml::node* node = table.get("between");
    if (node == nullptr) {
      for (int i = 0; i < static_cast<int>(scene().bodies.size()); ++i) query.group_1.push_back(i);
      query.group_2 = query.group_1;
      return;
    }
    const std::vector<std::string> names = texts_of(*node, "query.between");
    if (names.empty() || names.size() > 2) refuse(*node, "query.between names one group or two");
    query.group_1 = bodies_named(names.front(), *node);
    query.group_2 = bodies_named(names.back(), *node);
    if (pairs_of(scene(), query).empty()) refuse(*node, "query.between leaves no pair of bodies");
  }

  static SceneEffects read_effects(const toml::table& table) {
    const toml::node* node = table.get("effects");
    if (node == nullptr) refuse(table, "a query needs effects");
    SceneEffects effects = SceneEffects::none;
    for (const std::string& asked : texts_of(*node, "query.effects"))
      effects = effects | effect_named(asked, place_of(*node));
    return effects;
  }

  std::string read_metric(const toml::table& table, SceneQuery& query) {
    std::string word = "euclidean";
    const toml::node* node = table.get("metric");
    if (node != nullptr && !(node->is_string() && read_text(*node, "query.metric") == word)) {
      word = node->is_string() ? read_text(*node, "query.metric") : "set";
      if (node->is_table() && node->as_table()->get("shape") != nullptr) {
        word = read_text(*node->as_table()->get("shape"), "shape");
      }
      query.metric.Q = placed(*node, [&] { return set_of(*node, "query.metric", false); });
    }
    if (const toml::node* body = table.get("metric_body")) {
      if (query.metric.euclidean()) refuse(*body, "query.metric_body needs a metric of its own");
      const std::vector<int>& named = bodies_named(read_text(*body, "query.metric_body"), *body);
      if (named.size() != 1) refuse(*body, "query.metric_body must be one body");
      query.metric.body = named.front();
    }
    return word;
  }

  TomlSource toml_;
  std::filesystem::path folder_;
  const RobotMeshes& meshes_;
  SceneSource source_;
  int dimension_ = 0;
  std::map<std::string, std::vector<int>> groups_;
  std::map<std::string, bool> single_;
  std::vector<SceneRobot> robots_;
  std::vector<std::pair<const toml::table*, BodyDynamics>> reactions_;  ///< by body; null: a robot's link
};

}  // namespace

void set_accuracies(SceneSource& source, std::vector<SimulationAccuracy> accuracies) {
  source.accuracies = std::move(accuracies);
  source.dynamics->step = source.accuracies.back().step;
  source.dynamics->tolerance = source.accuracies.back().tolerance;
}

SceneSource read_scene(const std::string& path, const std::vector<std::string>& overrides,
                       const RobotMeshes& meshes) {
  return SceneReader(path, overrides, meshes).read();
}

}  // namespace raygauge::cli
