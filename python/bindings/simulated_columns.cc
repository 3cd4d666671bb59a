// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "python/bindings/simulated_columns.h"

#include <pybind11/numpy.h>

#include <atomic>
#include <vector>

#include "python/bindings/interrupt.h"
#include "python/bindings/scene_answers.h"
#include "python/bindings/thread_count.h"
#include "scene/simulation/moving_state.h"

namespace raygauge::python {
namespace {

namespace py = pybind11;

/// An array of a number, a word or a vector of each row.
template <class Row, class Get>
py::array column(const std::vector<Row>& rows, const Get& get) {
  using Entry = std::decay_t<decltype(get(rows.front()))>;
  const auto count = static_cast<py::ssize_t>(rows.size());
  if constexpr (std::is_arithmetic_v<Entry>) {
    py::array_t<Entry> array(count);
    for (py::ssize_t i = 0; i < count; ++i) array.mutable_at(i) = get(rows[static_cast<std::size_t>(i)]);
    return array;
  } else {
    constexpr py::ssize_t kSize = Entry::SizeAtCompileTime;
    py::array_t<double> array({count, kSize});
    for (py::ssize_t i = 0; i < count; ++i) {
      const Entry entry = get(rows[static_cast<std::size_t>(i)]);
      for (py::ssize_t k = 0; k < kSize; ++k) array.mutable_at(i, k) = entry[k];
    }
    return array;
  }
}

struct StateRow {
  double time;
  std::int32_t body;
  MovingState at;
};

py::dict states_of(const Simulation& found) {
  std::vector<StateRow> rows;
  for (const double t : found.scene.instants) {
    std::int32_t number = 0;
    for (const Body& body : found.scene.bodies) rows.push_back({t, number++, state_at(*body.motion, t)});
  }
  const auto quaternion = [](const StateRow& row) {
    const Eigen::Quaterniond& q = row.at.rotation;
    return Eigen::Vector4d(q.w(), q.x(), q.y(), q.z());
  };
  py::dict columns;
  columns["time"] = column(rows, [](const StateRow& row) { return row.time; });
  columns["body"] = column(rows, [](const StateRow& row) { return row.body; });
  columns["position"] = column(rows, [](const StateRow& row) { return row.at.place; });
  columns["quaternion"] = column(rows, quaternion);
  columns["velocity"] = column(rows, [](const StateRow& row) { return row.at.velocity; });
  columns["spin"] = column(rows, [](const StateRow& row) { return row.at.spin; });
  return columns;
}

py::dict contacts_of(const std::vector<ContactRecord>& rows) {
  using Row = ContactRecord;
  py::dict columns;
  columns["step"] = column(rows, [](const Row& row) { return row.step; });
  columns["time"] = column(rows, [](const Row& row) { return row.time; });
  columns["body_a"] = column(rows, [](const Row& row) { return row.body_a; });
  columns["body_b"] = column(rows, [](const Row& row) { return row.body_b; });
  columns["impact"] = column(rows, [](const Row& row) { return row.impact; });
  columns["point"] = column(rows, [](const Row& row) { return row.point; });
  columns["normal"] = column(rows, [](const Row& row) { return row.normal; });
  columns["gap"] = column(rows, [](const Row& row) { return row.gap; });
  columns["impulse"] = column(rows, [](const Row& row) { return row.impulse; });
  return columns;
}

py::dict steps_of(const std::vector<StepRecord>& rows) {
  using Row = StepRecord;
  py::dict columns;
  columns["time"] = column(rows, [](const Row& row) { return row.time; });
  columns["substeps"] = column(rows, [](const Row& row) { return row.substeps; });
  columns["impacts"] = column(rows, [](const Row& row) { return row.impacts; });
  columns["contacts"] = column(rows, [](const Row& row) { return row.contacts; });
  columns["residual"] = column(rows, [](const Row& row) { return row.residual; });
  columns["least_distance"] = column(rows, [](const Row& row) { return row.least_distance; });
  columns["kinetic"] = column(rows, [](const Row& row) { return row.kinetic; });
  columns["potential"] = column(rows, [](const Row& row) { return row.potential; });
  columns["momentum"] = column(rows, [](const Row& row) { return row.momentum; });
  columns["angular_momentum"] = column(rows, [](const Row& row) { return row.angular_momentum; });
  return columns;
}

py::dict counters_of(const SimulationCounters& counters) {
  py::dict all;
  all["ball_tests"] = counters.ball_tests;
  all["contact_queries"] = counters.contact_queries;
  all["motion_proofs"] = counters.motion_proofs;
  all["friction_problems"] = counters.friction_problems;
  all["frictionless_problems"] = counters.frictionless_problems;
  all["impact_problems"] = counters.impact_problems;
  all["damped_velocities"] = counters.damped_velocities;
  return all;
}

}  // namespace

py::dict simulated_columns(const Scene& scene, const Dynamics& dynamics, int threads) {
  std::atomic<bool> stop = false;
  SimulationHooks hooks;
  hooks.stop = [&stop] { return stop.load(); };
  hooks.threads = batch_threads(threads);
  Simulation found;
  py::object ended_by = py::none();
  try {
    run_interruptibly(stop, [&] { found = simulate(scene, dynamics, nullptr, hooks); });
  } catch (const SimulationError& error) {
    found = error.done();
    ended_by = py::str(error.what());
  }
  py::dict all;
  all["states"] = states_of(found);
  all["contacts"] = contacts_of(found.contacts);
  all["steps"] = steps_of(found.steps);
  all["counters"] = counters_of(found.counters);
  all["tolerance"] = found.tolerance;
  all["ended_by"] = ended_by;
  all["answers"] = scene_columns(found.scene, threads);
  return all;
}

}  // namespace raygauge::python
