// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "python/bindings/solving.h"

#include <array>

#include "raygauge/exceptions.h"
#include "raygauge/sweep/method.h"

namespace raygauge::python {
namespace {

constexpr std::array kMethods{DistanceMethod::automatic, DistanceMethod::column_generation,
                              DistanceMethod::newton, DistanceMethod::zheng_yamane};

}  // namespace

DistanceMethod method_of(const std::string& name) {
  for (const DistanceMethod method : kMethods) {
    if (current_method_name(name) == to_string(method)) return method;
  }
  std::vector<std::string> names;
  for (const DistanceMethod method : kMethods) names.emplace_back(to_string(method));
  throw UnknownNameError("method", name, names);
}

DistanceOptions options_of(const std::string& method, double tolerance, double time_limit) {
  DistanceOptions options;
  options.method = method_of(method);
  options.tolerance = tolerance;
  options.time_limit = time_limit;
  return options;
}

}  // namespace raygauge::python
