// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <atomic>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "baselines/command_method.h"
#include "baselines/registry.h"
#include "cli/input/experiment_file.h"
#include "cli/output/progress.h"
#include "engine/sweep/share.h"
#include "generators/registry.h"
#include "python/bindings/interrupt.h"
#include "python/sweeps/components.h"
#include "python/sweeps/loading.h"
#include "python/sweeps/planning.h"
#include "raygauge/sweep.h"
#include "results/run/identity.h"
#include "results/run/output_place.h"
#include "results/run/run_writer.h"
#include "results/run/stored_cells.h"

namespace raygauge::python {
namespace {

namespace py = pybind11;

/// What raygauge.run was asked for.
struct RunRequest {
  std::string source;
  std::string output;
  std::optional<int> threads;
  bool resume = false;
  bool force = false;
  bool progress = false;
  std::vector<ComponentVersion> versions;
};

RunMode mode_of(const RunRequest& request) {
  if (request.resume) return RunMode::resume;
  return request.force ? RunMode::force : RunMode::create;
}

/// Runs the sweep into its file, as the command `run` does; without the lock. What is done is kept when
/// `stop` is set.
void sweep(const RunRequest& request, const GeneratorRegistry& generators, const MethodRegistry& methods,
           Interpreter& interpreter, const std::atomic<bool>& stop) {
  Experiment experiment = cli::read_experiment(request.source, {}, generators, methods);
  if (request.threads) experiment.threads = *request.threads;
  output_place({request.output, OutputKind::results, {".h5", ".hdf5"}, {request.source}, request.force});
  const int threads = sweep_threads(experiment, grid_of(experiment).size());
  RunWriter writer(request.output, experiment, mode_of(request),
                   describe_session(experiment, threads, request.versions));
  cli::ProgressDisplay display(stderr, writer.done().size());
  SweepHooks hooks;
  hooks.stop = [&] { return stop.load(); };
  hooks.time = [&](SolveMethod& method, const SolveRequest& solve, double min_seconds) {
    return time_in_turn(interpreter, method, solve, min_seconds);
  };
  if (request.progress) hooks.progress = [&](const SweepProgress& progress) { display.show(progress); };
  const DoneCells done = done_repetitions({&writer.results().records}, experiment_identity(experiment));
  const SweepSummary summary = run_sweep(experiment, generators, methods, writer, done, hooks, SweepShare{});
  writer.finish(summary.calibration);
}

/// raygauge.run of an experiment that names methods or generators in Python. `failures` takes the exception
/// that such a function raised.
void run(const RunRequest& request, const py::list& methods, const py::list& generators, py::list failures) {
  const py::module_ components = py::module_::import("raygauge.components");
  Interpreter interpreter(components.attr("failure_text"));
  GeneratorRegistry all_generators("generator");
  MethodRegistry all_methods("method");
  register_generators(all_generators);
  register_engine_methods(all_methods);
  register_baselines(all_methods);
  register_command_method(all_methods);
  for (const py::handle component : generators) {
    add_python_generator(all_generators, interpreter, py::reinterpret_borrow<py::object>(component));
  }
  for (const py::handle component : methods) {
    add_python_method(all_methods, interpreter, py::reinterpret_borrow<py::object>(component),
                      components.attr("answer_of"));
  }
  std::atomic<bool> stop = false;
  try {
    run_interruptibly(stop, [&] { sweep(request, all_generators, all_methods, interpreter, stop); });
  } catch (...) {
    if (const py::object raised = interpreter.first_exception(); !raised.is_none()) failures.append(raised);
    throw;
  }
}

std::vector<ComponentVersion> versions_of(const std::vector<std::pair<std::string, std::string>>& own) {
  std::vector<ComponentVersion> versions;
  for (const auto& [name, version] : solver_versions()) versions.push_back({name, version});
  for (const auto& [name, version] : own) versions.push_back({name, version});
  return versions;
}

}  // namespace
}  // namespace raygauge::python

PYBIND11_MODULE(_sweeps, module) {
  namespace py = pybind11;
  using raygauge::python::RunRequest;
  py::module_::import("raygauge._raygauge");  // the sets' classes
  module.doc() =
      "What needs the program's libraries: sweeps with methods and generators in Python, and readers of "
      "files.";
  raygauge::python::bind_loading(module);
  raygauge::python::bind_planning(module);
  module.def(
      "run",
      [](std::string source, std::string output, std::optional<int> threads, bool resume, bool force,
         bool progress, const py::list& methods, const py::list& generators,
         const std::vector<std::pair<std::string, std::string>>& versions, py::list failures) {
        const RunRequest request{std::move(source),
                                 std::move(output),
                                 threads,
                                 resume,
                                 force,
                                 progress,
                                 raygauge::python::versions_of(versions)};
        raygauge::python::run(request, methods, generators, std::move(failures));
      },
      py::kw_only(), py::arg("source"), py::arg("output"), py::arg("threads"), py::arg("resume"),
      py::arg("force"), py::arg("progress"), py::arg("methods"), py::arg("generators"), py::arg("versions"),
      py::arg("failures"), "See raygauge.run.");
}
