// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "raygauge/sweep/experiment.h"
#include "raygauge/sweep/instance.h"
#include "raygauge/sweep/method.h"
#include "raygauge/sweep/record.h"

namespace raygauge {

/// An experiment with its names looked up: what all threads of a sweep share, unchanged from then on.
class SweepPlan {
 public:
  /// Refers to `experiment` and `methods`, which outlive it. Throws what validate, grid_of and the registries
  /// throw: after construction every component of the experiment is known to exist and its parameters to be
  /// valid.
  SweepPlan(const Experiment& experiment, const GeneratorRegistry& generators, const MethodRegistry& methods);

  const Experiment& experiment() const noexcept { return experiment_; }
  const std::vector<Cell>& cells() const noexcept { return cells_; }
  const Generator& generator(const Cell& cell) const { return *generators_[cell.generator]; }

  /// What a generator says of all its instances, and is copied into their records.
  struct GeneratorFacts {
    SharedText parameters;  ///< "separation=1.5": every parameter, defaults included
    double distance_rounding = 0;
    SharedText hardness_label;
    double hardness = std::numeric_limits<double>::quiet_NaN();
  };
  const GeneratorFacts& generator_facts(const Cell& cell) const { return generator_facts_[cell.generator]; }

  /// Whose method `index` of the experiment is.
  Role role(std::size_t index) const { return roles_[index]; }

  /// Every parameter of method `index`, defaults included.
  SharedText method_parameters(std::size_t index) const { return method_parameters_[index]; }

  /// A fresh set of the experiment's methods, for one thread.
  std::vector<std::unique_ptr<SolveMethod>> make_methods() const;

  /// Instance `repetition` of a cell. Throws what the generator throws; InvalidParameterError tells the cell.
  Instance instance(const Cell& cell, int repetition) const;

  /// What the cell asks of one solve.
  SolveRequest request(const Cell& cell) const { return {cell.tolerance, experiment_.time_limit}; }

 private:
  const Experiment& experiment_;
  const MethodRegistry& methods_;
  std::vector<Cell> cells_;
  std::vector<std::unique_ptr<Generator>> generators_;
  std::vector<GeneratorFacts> generator_facts_;
  std::vector<Role> roles_;
  std::vector<SharedText> method_parameters_;
};

}  // namespace raygauge
