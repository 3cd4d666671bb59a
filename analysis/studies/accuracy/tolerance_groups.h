// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/data/record_groups.h"
#include "analysis/render/report/blocks.h"

namespace raygauge::report {

/// Records of one method at each tolerance, all else but the repetition being equal.
struct ToleranceCurve {
  std::string method;
  Facets facets;                                         ///< problem, n, N
  std::map<double, std::vector<const Record*>> records;  ///< by tolerance
};

/// The curves with at least two tolerances. They point into `records`.
std::vector<ToleranceCurve> tolerance_curves(const RecordGroups& records);

}  // namespace raygauge::report
