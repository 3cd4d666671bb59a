// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/data/filter.h"
#include "raygauge/sweep/instance.h"
#include "raygauge/sweep/record.h"
#include "results/disk/atomic_file.h"

namespace raygauge::cli {

/// How many wrong answers there are, of competitors or of raygauge, and how many of them are refuted.
struct RefutationCount {
  std::size_t wrong = 0;
  std::size_t refuted = 0;
  std::string open;  ///< the first of the others, in words: its method and its bodies
};

/// Puts a line, one JSON object as docs/analysis.md says, for each wrong answer (see verdict_on()) about two
/// bodies in the records that pass the filter, as far as it can be refuted. The bodies are generated again.
/// Throws EmptySetError if no record is of two bodies, and what `put` throws.
RefutationCount put_refutations(const std::vector<Record>& records, const Filter& filter,
                                const GeneratorRegistry& generators, const ByteSink& put);

}  // namespace raygauge::cli
