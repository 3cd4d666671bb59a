// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/simulation_part.h"

#include <iterator>
#include <utility>

#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

template <class Row>
std::vector<Row> rows_from(const std::vector<Row>& rows, std::size_t first) {
  return {rows.begin() + static_cast<std::ptrdiff_t>(first), rows.end()};
}

template <class Row>
void append(std::vector<Row>& rows, const std::vector<Row>& more) {
  rows.insert(rows.end(), more.begin(), more.end());
}

}  // namespace

SimulationCounters& SimulationCounters::operator+=(const SimulationCounters& more) {
  ball_tests += more.ball_tests;
  contact_queries += more.contact_queries;
  motion_proofs += more.motion_proofs;
  friction_problems += more.friction_problems;
  frictionless_problems += more.frictionless_problems;
  impact_problems += more.impact_problems;
  damped_velocities += more.damped_velocities;
  return *this;
}

SimulationLog::Ends SimulationLog::ends() const {
  Ends now{steps.size(), contacts.size(), {}, counters};
  for (const auto& of_body : pieces) now.pieces.push_back(of_body.size());
  return now;
}

void SimulationLog::begin_step() { begun_ = ends(); }

void SimulationLog::take_step_back() {
  contacts.erase(contacts.begin() + static_cast<std::ptrdiff_t>(begun_.contacts), contacts.end());
  for (std::size_t b = 0; b < pieces.size(); ++b)
    pieces[b].erase(pieces[b].begin() + static_cast<std::ptrdiff_t>(begun_.pieces[b]), pieces[b].end());
  counters = begun_.counters;
}

SimulationPart SimulationLog::next_part(SimulationState state) {
  SimulationPart part;
  part.first_step = static_cast<std::int64_t>(stored_.steps);
  part.steps = rows_from(steps, stored_.steps);
  part.contacts = rows_from(contacts, stored_.contacts);
  for (std::size_t b = 0; b < pieces.size(); ++b)
    part.pieces.push_back(rows_from(pieces[b], stored_.pieces[b]));
  part.counters = counters;
  part.state = std::move(state);
  stored_ = ends();
  return part;
}

void SimulationLog::add(const SimulationPart& part) {
  if (part.first_step != static_cast<std::int64_t>(steps.size()) || part.pieces.size() != pieces.size() ||
      part.state.bodies.size() != pieces.size())
    throw InvalidParameterError("simulation: a part does not follow the one before it");
  append(steps, part.steps);
  append(contacts, part.contacts);
  for (std::size_t b = 0; b < pieces.size(); ++b) append(pieces[b], part.pieces[b]);
  counters = part.counters;
  stored_ = ends();
}

}  // namespace raygauge
