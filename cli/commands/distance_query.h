// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "cli/output/distance_report.h"
#include "raygauge/methods/options.h"
#include "raygauge/sweep/method.h"

namespace raygauge::cli {

/// A distance query by any method of the program.
struct DistanceQuery {
  std::string method = "automatic";  ///< a name or alias of a method, or "automatic": what suits the sets
  DistanceOptions options;           ///< `method` of it is set from the name
  bool engine_options_set = false;   ///< whether an option was chosen that only the engine's methods have
  bool witness = false;
};

/// Answers the query for A and Q of `instance`. Throws UnknownNameError for a method that is not in
/// `methods`, InvalidParameterError for sets that the method does not take or options that it does not have.
DistanceReport answer(const DistanceQuery& query, const Instance& instance, const MethodRegistry& methods);

/// Whether the method passes over sets that memory does not hold.
bool may_stream(const DistanceQuery& query);

}  // namespace raygauge::cli
