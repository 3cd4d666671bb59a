// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "cli/output/distance_report.h"
#include "engine/queries/point_stream.h"
#include "engine/queries/streamed_distance.h"
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

/// The points of a dataset FILE.h5:/NAME that are too many for memory to be wasted on them, 2^28 bytes in
/// double precision, where the file holds them as they are; nullptr for every other source.
std::unique_ptr<PointStream> open_stream(const std::string& source);

/// Whether the query can be answered by passes over a file: by the engine's default method or
/// column_generation, without limits on its basis changes.
bool can_stream(const DistanceQuery& query);

/// Answers the query of sets of which some are streams.
DistanceReport answer_streamed(const DistanceQuery& query, const StreamedDistance::Source& A,
                               const StreamedDistance::Source& Q);

}  // namespace raygauge::cli
