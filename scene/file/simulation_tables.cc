// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/file/simulation_tables.h"

#include "results/journal/csv.h"

namespace raygauge {
namespace {

template <class Row>
std::string csv_of(const SimulationTables& tables, const std::vector<Column<Row>>& all,
                   const std::vector<Row>& rows, const std::vector<std::string>& bodies) {
  const auto entry = [&](const Column<Row>& column, const Row& row) {
    const Value value = column.get(row);
    if (!column.name.starts_with("body")) return csv_field(value);
    return csv_field(bodies.at(static_cast<std::size_t>(std::get<std::int32_t>(value))));
  };
  return csv_table(all, rows, entry, tables.simulations.size() > 1 ? "" : "simulation");
}

}  // namespace

// clang-format off
const std::vector<Column<SimulationRow>>& simulation_columns() {
  using Row = SimulationRow;
  static const std::vector<Column<Row>> kColumns = {
    column("simulation", "1", "number, from coarse to fine", &Row::simulation),
    column("step", "s", "the longest step", &Row::step),
    column("tolerance", "1", "δ relative to the smallest body", &Row::tolerance),
    column("delta", "1", "δ", &Row::delta),
    column("seconds", "s", "wall time", &Row::seconds),
    column("steps", "1", "steps", &Row::steps),
    column("cuts", "1", "cuts of steps", &Row::cuts),
    column("impacts", "1", "laws of impact evaluated", &Row::impacts),
    column("contacts", "1", "points of contact problems", &Row::contacts),
    column("unproven", "1", "steps without a proven distance", &Row::unproven),
    column("residual", "1", "largest relative residual; NaN: not known", &Row::residual),
    column("least_distance", "1", "proven, but for unproven steps; at most 0", &Row::least_distance),
    column("energy_change", "1", "at the end less at the start", &Row::energy_change),
    column("energy_rise", "1", "most by which it rose between two steps", &Row::energy_rise),
    column("error", "1", "farthest that a body is from where the finest has it", &Row::error),
    later(column("engine", "", "whose motion it is", &Row::engine), std::string("raygauge")),
  };
  return kColumns;
}

const std::vector<Column<StateRow>>& state_columns() {
  using Row = StateRow;
  static const std::vector<Column<Row>> kColumns = {
    column("time", "s", "instant", &Row::time),
    column("body", "1", "row of /bodies", &Row::body),
    column("x", "1", "place of the centre of mass; of a body that does not react, of its frame", &Row::x),
    column("y", "1", "the same", &Row::y),
    column("z", "1", "the same; 0 in the plane", &Row::z),
    column("qw", "1", "rotation of the body's axes as a unit quaternion", &Row::qw),
    column("qx", "1", "the same", &Row::qx),
    column("qy", "1", "the same", &Row::qy),
    column("qz", "1", "the same", &Row::qz),
    column("vx", "1/s", "velocity of that place", &Row::vx),
    column("vy", "1/s", "the same", &Row::vy),
    column("vz", "1/s", "the same", &Row::vz),
    column("wx", "1/s", "angular velocity", &Row::wx),
    column("wy", "1/s", "the same", &Row::wy),
    column("wz", "1/s", "the same", &Row::wz),
    column("simulation", "1", "row of /simulations", &Row::simulation),
  };
  return kColumns;
}

const std::vector<Column<ContactRow>>& contact_columns() {
  using Row = ContactRow;
  static const std::vector<Column<Row>> kColumns = {
    column("step", "1", "row of /steps", &Row::step),
    column("time", "s", "of the beginning of the substep, or of the impact", &Row::time),
    column("body_a", "1", "row of /bodies", &Row::body_a),
    column("body_b", "1", "row of /bodies", &Row::body_b),
    column("kind", "", "contact: over a substep; impact: by the law of restitution, at one moment", &Row::kind),
    column("x", "1", "point of contact", &Row::x),
    column("y", "1", "the same", &Row::y),
    column("z", "1", "the same", &Row::z),
    column("nx", "1", "unit normal, from body b to body a", &Row::nx),
    column("ny", "1", "the same", &Row::ny),
    column("nz", "1", "the same", &Row::nz),
    column("gap", "1", "how far the bodies are apart there", &Row::gap),
    column("px", "1", "impulse on body a", &Row::px),
    column("py", "1", "the same", &Row::py),
    column("pz", "1", "the same", &Row::pz),
    column("simulation", "1", "row of /simulations", &Row::simulation),
  };
  return kColumns;
}

const std::vector<Column<StepRow>>& step_columns() {
  using Row = StepRow;
  static const std::vector<Column<Row>> kColumns = {
    column("time", "s", "end of the step", &Row::time),
    column("substeps", "1", "1, and 1 more for each time that it was cut", &Row::substeps),
    column("impacts", "1", "laws of impact evaluated", &Row::impacts),
    column("contacts", "1", "points of contact problems", &Row::contacts),
    column("residual", "1", "largest residual of a contact problem, relative", &Row::residual),
    column("least_distance", "1", "proven: no pair was closer at any time of the step; -inf: nothing is proven", &Row::least_distance),
    column("kinetic", "1", "kinetic energy at the end", &Row::kinetic),
    column("potential", "1", "potential energy at the end, of gravity", &Row::potential),
    column("px", "1", "momentum at the end, of all bodies that react", &Row::px),
    column("py", "1", "the same", &Row::py),
    column("pz", "1", "the same", &Row::pz),
    column("lx", "1", "their angular momentum about the origin", &Row::lx),
    column("ly", "1", "the same", &Row::ly),
    column("lz", "1", "the same", &Row::lz),
    column("simulation", "1", "row of /simulations", &Row::simulation),
  };
  return kColumns;
}
// clang-format on

std::string states_csv(const SimulationTables& tables, const std::vector<std::string>& bodies) {
  return csv_of(tables, state_columns(), tables.states, bodies);
}

std::string contacts_csv(const SimulationTables& tables, const std::vector<std::string>& bodies) {
  return csv_of(tables, contact_columns(), tables.contacts, bodies);
}

std::string steps_csv(const SimulationTables& tables) {
  return csv_of(tables, step_columns(), tables.steps, {});
}

std::string simulations_csv(const SimulationTables& tables) {
  return csv_of(tables, simulation_columns(), tables.simulations, {});
}

}  // namespace raygauge
