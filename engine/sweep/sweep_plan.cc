// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/sweep_plan.h"

namespace raygauge {
namespace {

template <class T>
std::string completed_parameters(const Registry<T>& registry, const ComponentSpec& spec) {
  return to_string(complete("'" + spec.name + "'", registry.find(spec.name).parameters, spec.parameters));
}

}  // namespace

SweepPlan::SweepPlan(const Experiment& experiment, const GeneratorRegistry& generators,
                     const MethodRegistry& methods)
    : experiment_(experiment), methods_(methods) {
  validate(experiment);
  cells_ = grid_of(experiment);
  for (const ComponentSpec& spec : experiment.generators) {
    generators_.push_back(generators.make(spec.name, spec.parameters));
    generator_parameters_.push_back(completed_parameters(generators, spec));
  }
  for (const ComponentSpec& spec : experiment.methods) {
    methods.make(spec.name, spec.parameters);
    method_parameters_.push_back(completed_parameters(methods, spec));
  }
}

std::vector<std::unique_ptr<SolveMethod>> SweepPlan::make_methods() const {
  std::vector<std::unique_ptr<SolveMethod>> made;
  for (const ComponentSpec& spec : experiment_.methods) {
    made.push_back(methods_.make(spec.name, spec.parameters));
  }
  return made;
}

Instance SweepPlan::instance(const Cell& cell, int repetition) const {
  try {
    return generator(cell).generate({experiment_.seed, cell.n, cell.N, repetition});
  } catch (const InvalidParameterError& error) {
    throw InvalidParameterError(
        "cell " + std::to_string(cell.index) + " (generator '" + experiment_.generators[cell.generator].name +
        "', n = " + std::to_string(cell.n) + ", N = " + std::to_string(cell.N) + "): " + error.what());
  }
}

}  // namespace raygauge
