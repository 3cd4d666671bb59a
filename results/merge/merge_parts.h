// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "results/provenance/provenance.h"

namespace raygauge {

struct MergeOptions {
  bool mixed_builds = false;  ///< parts of different builds of raygauge or its solvers are merged too
  bool partial = false;       ///< parts that lack cells are merged too
};

struct MergeSummary {
  std::uint64_t records = 0;
  std::uint64_t cells = 0;     ///< whole ones
  std::uint64_t repeated = 0;  ///< records left out, because an earlier part has them
  Provenance provenance;
};

/// Joins the parts of one experiment (shards, finished or not) into the results file `target`, each
/// repetition of each cell once: of a repetition in several parts the first is kept. Memory does not grow
/// with the number of records, but for 40 bytes a cell and part; a file without a name holds the rows
/// meanwhile.
///
/// Throws, with nothing written:
///   ResultsExistError     `target` or parts of a run into it are there,
///   RunLockedError        a part is being written,
///   OtherExperimentError  parts of different experiments,
///   ResultsError          parts of different builds; a repetition whose answers differ in two parts; cells
///                         that no part has,
///   ResultsError, SchemaVersionError  a part cannot be read, or the target not be written.
MergeSummary merge_parts(const std::vector<std::filesystem::path>& parts, const std::filesystem::path& target,
                         const MergeOptions& options = {});

}  // namespace raygauge
