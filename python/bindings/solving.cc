// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "python/bindings/solving.h"

#include <array>
#include <string>
#include <vector>

#include "raygauge/exceptions.h"
#include "raygauge/methods/options.h"

namespace raygauge::python {
namespace {

constexpr std::array kMethods{DistanceMethod::automatic, DistanceMethod::column_generation,
                              DistanceMethod::newton, DistanceMethod::zheng_yamane};

}  // namespace

DistanceMethod method_of(std::string_view name) {
  for (const DistanceMethod method : kMethods) {
    if (name == to_string(method)) return method;
  }
  std::vector<std::string> names;
  for (const DistanceMethod method : kMethods) names.emplace_back(to_string(method));
  throw UnknownNameError("method", std::string(name), names);
}

DistanceOptions options_of(std::string_view method, double tolerance, double time_limit) {
  DistanceOptions options;
  options.method = method_of(method);
  options.tolerance = tolerance;
  options.time_limit = time_limit;
  if (const std::string problem = validate(options); !problem.empty()) throw InvalidParameterError(problem);
  return options;
}

}  // namespace raygauge::python
