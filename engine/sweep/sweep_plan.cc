// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/sweep_plan.h"

namespace raygauge {
namespace {

template <class T>
std::string completed_parameters(const Registry<T>& registry, const ComponentSpec& spec) {
  return to_string(complete("'" + spec.name + "'", registry.find(spec.name).parameters, spec.parameters));
}

double number_of(const ParameterValue& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return static_cast<double>(*integer);
  return std::get<double>(value);
}

SweepPlan::GeneratorFacts facts_of(const Component<Generator>& component, const ComponentSpec& spec) {
  const Parameters parameters = complete("'" + spec.name + "'", component.parameters, spec.parameters);
  SweepPlan::GeneratorFacts facts;
  facts.parameters = to_string(parameters);
  facts.distance_rounding = component.promises.distance_rounding;
  for (const ParameterInfo& info : component.parameters) {
    if (info.hardness.label.empty()) continue;
    facts.hardness_label = info.hardness.label;
    facts.hardness = info.hardness(number_of(parameters.at(info.name)));
  }
  return facts;
}

}  // namespace

SweepPlan::SweepPlan(const Experiment& experiment, const GeneratorRegistry& generators,
                     const MethodRegistry& methods)
    : experiment_(experiment), methods_(methods) {
  validate(experiment);
  cells_ = grid_of(experiment);
  for (const ComponentSpec& spec : experiment.generators) {
    generators_.push_back(generators.make(spec.name, spec.parameters));
    generator_facts_.push_back(facts_of(generators.find(spec.name), spec));
  }
  for (const ComponentSpec& spec : experiment.methods) {
    methods.make(spec.name, spec.parameters);
    method_parameters_.push_back(completed_parameters(methods, spec));
    roles_.push_back(methods.find(spec.name).role);
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
