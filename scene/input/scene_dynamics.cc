// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/input/scene_dynamics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/input/pose_table.h"
#include "cli/input/toml_refusal.h"
#include "cli/input/toml_section.h"
#include "engine/numerics/floating_point.h"
#include "scene/input/scene_source.h"

namespace raygauge::cli {
namespace {

const Range kPositive{0, kInfinity, true};
constexpr double kMost = 1e300;

// n numbers of R^n, with zeros behind them.
Eigen::Vector3d vector_of(const toml::node& node, const std::string& key, int n) {
  Eigen::Vector3d all = Eigen::Vector3d::Zero();
  all.head(n) = vector_of_length(node, key, n);
  return all;
}

ContactLaw law_of(const toml::table& table, const std::string& place) {
  const TomlSection keys(table, place);
  ContactLaw law;
  keys.real("friction", {0, kMost}, law.friction);
  keys.real("restitution", {0, 1}, law.restitution);
  return law;
}

// A number in the plane; in space three principal moments along the axes, or a matrix.
Eigen::Matrix3d inertia_of(const toml::node& node, int n) {
  if (n == 2) return Eigen::Vector3d(0, 0, read_real(node, "body.inertia", kPositive)).asDiagonal();
  const bool rows = node.is_array() && !node.as_array()->empty() && node.as_array()->get(0)->is_array();
  if (!rows) return vector_of(node, "body.inertia", 3).asDiagonal();
  const Eigen::MatrixXd matrix = read_matrix(node, "body.inertia");
  if (matrix.rows() != 3 || matrix.cols() != 3)
    refuse(node, "body.inertia must be 3 numbers, or 3 rows of 3");
  return matrix;
}

PairLaw read_pair(const toml::node& node, const BodiesNamed& bodies_named) {
  const toml::table& table = read_table(node, "dynamics.pair");
  reject_unknown_keys(table, "[[dynamics.pair]] key", dynamics_keys().at("dynamics.pair"));
  const toml::node* between = table.get("between");
  if (between == nullptr || !between->is_array() || between->as_array()->size() != 2)
    refuse(node, "dynamics.pair.between must name two bodies or groups");
  const toml::array& names = *between->as_array();
  PairLaw pair;
  pair.group_1 = bodies_named(read_text(names[0], "dynamics.pair.between"), *between);
  pair.group_2 = bodies_named(read_text(names[1], "dynamics.pair.between"), *between);
  pair.law = law_of(table, "dynamics.pair");
  return pair;
}

}  // namespace

std::map<std::string, std::vector<std::string>> dynamics_keys() {
  return {{"dynamics",
           {"gravity", "contact", "damping", "step", "tolerance", "overlap_at_start", "pair", "engine"}},
          {"dynamics.contact", {"friction", "restitution"}},
          {"dynamics.damping", {"linear", "angular"}},
          {"dynamics.pair", {"between", "friction", "restitution"}}};
}

std::vector<std::string> body_dynamics_keys() {
  return {"density", "mass", "inertia", "velocity", "angular_velocity"};
}

BodyDynamics read_body_dynamics(const toml::table& table, const Body& body) {
  const int n = body.dimension();
  const TomlSection keys(table, "body");
  std::optional<double> mass, density;
  keys.real("mass", kPositive, mass);
  keys.real("density", kPositive, density);
  BodyDynamics how;
  if (mass && density) refuse(table, "a body has a mass or a density, not both");
  if (!mass && table.contains("inertia")) refuse(*table.get("inertia"), "body.inertia needs a mass");
  if (!mass && !density) {
    for (const char* key : {"velocity", "angular_velocity"}) {
      if (table.contains(key))
        refuse(*table.get(key),
               std::string("body.") + key +
                   " needs a mass or a density; a body that does not react follows its motion");
    }
    return how;
  }
  std::optional<Eigen::Matrix3d> inertia;
  if (const toml::node* node = table.get("inertia")) inertia = inertia_of(*node, n);
  how = placed(table, [&] { return reacting_body(body, mass, density, inertia); });
  if (const toml::node* node = table.get("velocity")) how.velocity = vector_of(*node, "body.velocity", n);
  if (const toml::node* node = table.get("angular_velocity")) {
    if (n == 2) how.spin[2] = read_number(*node, "body.angular_velocity");
    if (n == 3) how.spin = vector_of(*node, "body.angular_velocity", 3);
  }
  return how;
}

std::vector<SimulationAccuracy> read_accuracies(const toml::table& table) {
  const SimulationAccuracy usual;
  std::vector<double> steps = {usual.step}, tolerances = {usual.tolerance};
  const TomlSection keys(table, "dynamics");
  keys.reals("step", kPositive, steps);
  keys.reals("tolerance", {1e-9, 0.1}, tolerances);
  return accuracies_of(std::move(steps), std::move(tolerances));
}

std::vector<std::string> read_engines(const toml::table& table) {
  static const std::vector<std::string> kKnown = {"bullet", "ode", "mujoco", kOwnEngine};
  const toml::node* node = table.get("engine");
  if (node == nullptr) return {kOwnEngine};
  std::vector<std::string> named;
  if (!node->is_array()) named.push_back(read_text(*node, "dynamics.engine"));
  for (std::size_t k = 0; node->is_array() && k < node->as_array()->size(); ++k)
    named.push_back(read_text((*node->as_array())[k], "dynamics.engine"));
  std::vector<std::string> engines;
  for (const std::string& one : kKnown) {
    if (std::erase(named, one) > 0) engines.push_back(one);
  }
  if (!named.empty() || engines.empty())
    refuse(*node, "dynamics.engine must name raygauge, bullet, ode or mujoco");
  return engines;
}

Dynamics read_dynamics(const toml::table& table, int dimension, const BodiesNamed& bodies_named) {
  reject_unknown_keys(table, "[dynamics] key", dynamics_keys().at("dynamics"));
  Dynamics dynamics;
  if (dimension != 2 && dimension != 3) refuse(table, "dynamics: bodies react in 2 or 3 dimensions");
  if (const toml::node* node = table.get("gravity"))
    dynamics.gravity = vector_of(*node, "dynamics.gravity", dimension);
  if (const toml::node* node = table.get("contact")) {
    const toml::table& contact = read_table(*node, "dynamics.contact");
    reject_unknown_keys(contact, "key of dynamics.contact", dynamics_keys().at("dynamics.contact"));
    dynamics.contact = law_of(contact, "dynamics.contact");
  }
  if (const toml::node* node = table.get("damping")) {
    const toml::table& damping = read_table(*node, "dynamics.damping");
    reject_unknown_keys(damping, "key of dynamics.damping", dynamics_keys().at("dynamics.damping"));
    const TomlSection keys(damping, "dynamics.damping");
    dynamics.damping.emplace();
    keys.real("linear", {0, kMost}, dynamics.damping->linear);
    keys.real("angular", {0, kMost}, dynamics.damping->angular);
  }
  if (const toml::node* node = table.get("overlap_at_start")) {
    const std::string wanted = read_text(*node, "dynamics.overlap_at_start");
    if (wanted != "refuse" && wanted != "resolve")
      refuse(*node, R"(dynamics.overlap_at_start must be "refuse" or "resolve")");
    if (!dynamics.contact) refuse(*node, "dynamics.overlap_at_start has no effect without dynamics.contact");
    if (wanted == "resolve") dynamics.overlap_at_start = StartOverlap::resolved;
  }
  if (const toml::node* node = table.get("pair")) {
    if (!node->is_array()) refuse(*node, "dynamics.pair must be a list of tables, [[dynamics.pair]]");
    if (!dynamics.contact) refuse(*node, "dynamics.pair has no effect without dynamics.contact");
    for (const toml::node& element : *node->as_array())
      dynamics.pairs.push_back(read_pair(element, bodies_named));
  }
  return dynamics;
}

}  // namespace raygauge::cli
