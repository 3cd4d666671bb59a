// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/data/filter.h"
#include "raygauge/sweep/instance.h"
#include "raygauge/sweep/record.h"

namespace raygauge::cli {

/// The refutations of wrong answers as text.
struct RefutationReport {
  std::string lines;        ///< one JSON object a line, as docs/analysis.md says
  std::size_t wrong = 0;    ///< answers that are wrong, of competitors or of raygauge
  std::size_t refuted = 0;  ///< those of them that have a line
};

/// Of the wrong answers (see verdict_on()) about two bodies in the records that pass the filter. The bodies
/// are generated again. Throws EmptySetError if no record is of two bodies.
RefutationReport refutation_report(const std::vector<Record>& records, const Filter& filter,
                                   const GeneratorRegistry& generators);

}  // namespace raygauge::cli
