// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "bench/motionbench_results.h"

#include <cmath>
#include <cstdio>
#include <limits>

#include "raygauge/scene/edge_checker.h"

namespace raygauge::bench {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::string label_of_resolution(double resolution) {
  char text[40] = "proven";
  if (resolution > 0) std::snprintf(text, sizeof text, "samples %g", resolution);
  return text;
}

}  // namespace

PlanResults::PlanResults(const std::string& path, const std::vector<std::string>& environments,
                         const std::vector<double>& resolutions, int problems, double time_limit, int threads,
                         bool processor_time, int joints, int bodies)
    : threads_(threads) {
  experiment_.name = "motionbench";
  experiment_.text = "# written by raygauge_motionbench: plans of MotionBenchMaker problems, not a sweep\n";
  experiment_.repetitions = problems;
  experiment_.warmup = 0;
  experiment_.time_limit = time_limit;
  experiment_.timing = TimingMode::serial;
  experiment_.threads = 1;
  experiment_.n = {joints};
  experiment_.N = {bodies};
  experiment_.tolerance = {EdgeOptions().contact};
  for (const std::string& environment : environments) {
    GeneratorSpec generator;
    generator.name = generator.label = environment;
    experiment_.generators.push_back(generator);
  }
  for (const bool is_proof : {false, true}) {
    for (const double resolution : resolutions) {
      ComponentSpec method;
      method.name = is_proof ? "proof" : "rrt_connect";
      method.label = (is_proof ? "proof of " : "") + label_of_resolution(resolution);
      method.parameters["resolution"] = resolution;
      if (processor_time) method.parameters["clock"] = std::string("processor");
      experiment_.methods.push_back(method);
    }
  }
  validate(experiment_);
  run_ = std::make_unique<RunWriter>(path, experiment_, RunMode::resume,
                                     describe_session(experiment_, threads, {}));
  for (const Record& record : run_->results().records) stored_.emplace(record.cell, record.repetition);
}

bool PlanResults::has(std::size_t environment, int problem) const {
  return stored_.count({environment, problem}) != 0;
}

Record PlanResults::record_of(std::size_t environment, int problem, std::size_t method) const {
  const ComponentSpec& of = experiment_.methods[method];
  Record record;
  record.cell = environment;
  record.generator = experiment_.generators[environment].name;
  record.method = of.label;
  record.method_name = of.name;
  record.method_parameters = to_string(of.parameters);
  record.n = experiment_.n.front();
  record.N = experiment_.N.front();
  record.tolerance = experiment_.tolerance.front();
  record.seed = experiment_.seed;
  record.repetition = problem;
  record.distance = record.lower = record.upper = record.exact_distance = kNaN;
  record.concurrency = threads_;
  return record;
}

void PlanResults::store(std::size_t environment, int problem, int thread, const std::vector<Plan>& plans) {
  CellResult cell;
  cell.cell = environment;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    const Plan& plan = plans[i];
    Record record = record_of(environment, problem, i);
    record.thread = thread;
    record.role = plan.resolution == 0 ? Role::engine : Role::baseline;
    record.seconds = plan.plan_seconds;
    if (plan.solved) record.distance = plan.length();
    record.status = plan.solved ? DistanceStatus::optimal : DistanceStatus::time_limit;
    record.agrees = !plan.collides();
    Record proof = record_of(environment, problem, plans.size() + i);
    proof.thread = thread;
    proof.role = Role::oracle;
    proof.seconds = plan.proof_seconds;
    if (plan.collides()) proof.upper = plan.proof.depth;
    const bool decided = plan.solved && plan.proof.outcome != EdgeOutcome::undecided;
    proof.status = decided ? DistanceStatus::optimal : DistanceStatus::precision_limit;
    if (!plan.solved) proof.status = DistanceStatus::time_limit;
    cell.records.push_back(record);
    cell.records.push_back(proof);
  }
  run_->store(cell);
}

}  // namespace raygauge::bench
