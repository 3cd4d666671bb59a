// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "cli/input/toml_source.h"
#include "raygauge/scene/scene.h"
#include "raygauge/simulation.h"

namespace raygauge::cli {

/// The keys of [dynamics] and of the tables in it, by table.
std::map<std::string, std::vector<std::string>> dynamics_keys();

/// The keys of a body that say how it reacts.
std::vector<std::string> body_dynamics_keys();

/// Of a [[body]]. Throws Error, with file and line.
BodyDynamics read_body_dynamics(const toml::table& table, const Body& body);

/// The bodies of a name, which stands at a node.
using BodiesNamed = std::function<const std::vector<int>&(const std::string&, const toml::node&)>;

/// Each combination of dynamics.step and dynamics.tolerance. Throws Error, with file and line.
std::vector<SimulationAccuracy> read_accuracies(const toml::table& table);

/// dynamics.engine: names of engines, "raygauge" the last. Throws Error, with file and line.
std::vector<std::string> read_engines(const toml::table& table);

/// [dynamics], but for the bodies, the engines and the accuracies. Throws Error, with file and line.
Dynamics read_dynamics(const toml::table& table, int dimension, const BodiesNamed& bodies_named);

}  // namespace raygauge::cli
