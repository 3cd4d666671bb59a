// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "cli/output/json_text.h"
#include "raygauge/methods/result.h"
#include "raygauge/queries/membership.h"

namespace raygauge::cli {

/// What a report says of a set.
struct ReportedSet {
  SupportStructure structure = SupportStructure::unknown;
  std::ptrdiff_t n_points = 0;  ///< 0: it is no point set
};

/// One answered query, as the program reports it.
struct DistanceReport {
  DistanceResult result;
  std::string method;
  double tolerance = 0;
  double seconds = 0;  ///< building the method's model and the solve
  int n = 0;
  ReportedSet A;
  ReportedSet Q;
  bool witness = false;  ///< whether the contact point was asked for

  /// Whether the origin lies in the interior of Q, as a gauge needs, and if not a direction with all of Q on
  /// one side. Of point sets it is checked, in at most the time of the solve, or in 10 ms.
  OriginInInterior precondition;
  double check_seconds = 0;  ///< of that check
};

/// The object that --json prints: distance, lower, upper, status, violated_preconditions
/// ("origin_in_interior_of_Q" where that is proven false), unchecked_preconditions (the same where a check
/// would have taken longer than the solve), method, n, n_points_A, n_points_Q (null
/// where the set is no point set), normal, contact_point (with --witness: empty where there is none),
/// origin_weights (of contains_origin), counters.
Json distance_json(const DistanceReport& report);

/// Several lines for people.
std::string distance_text(const DistanceReport& report);

/// What the answer says of A and Q as two objects, in one sentence. "In contact" is claimed only of a solve
/// that met its tolerance and whose certified interval holds 1.
std::string verdict(const DistanceResult& result);

}  // namespace raygauge::cli
