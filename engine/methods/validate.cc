// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/methods/options.h"

#include "engine/kernels/kernel.h"
#include "engine/numerics/number_text.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

std::string problem_of_kernels(InstructionSet instruction_set) {
  try {
    kernels_for(instruction_set);
    return {};
  } catch (const InvalidParameterError& error) {
    return error.what();
  }
}

}  // namespace

std::string validate(const DistanceOptions& options) {
  if (!(options.tolerance > 0 && options.tolerance < 1))
    return "tolerance must lie in (0, 1), got " + shortest_text(options.tolerance);
  if (options.max_iterations < 0)
    return "max_iterations must not be negative, got " + std::to_string(options.max_iterations);
  if (!(options.time_limit >= 0))
    return "time_limit must not be negative, got " + shortest_text(options.time_limit);
  if (options.threads < 1 || options.threads > kMostThreads) {
    return "threads must lie in 1 … " + std::to_string(kMostThreads) + ", got " +
           std::to_string(options.threads);
  }
  if (options.stop_rule == StopRule::published_sigma && options.method != DistanceMethod::zheng_yamane) {
    return "stop_rule published_sigma belongs to method zheng_yamane";
  }
  return problem_of_kernels(options.instruction_set);
}

}  // namespace raygauge
