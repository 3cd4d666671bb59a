// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/run/rank_journal.h"

#include <cstdint>
#include <utility>

#include "results/disk/run_directory.h"

namespace raygauge {

RankJournal::RankJournal(const std::filesystem::path& target, const Experiment& experiment,
                         RecordSource source)
    : arranger_(experiment),
      source_(std::move(source)),
      journal_(journal_path(target, static_cast<std::uint64_t>(source_.session))) {}

void RankJournal::store(const CellResult& cell) {
  journal_.append(cell.cell, arranger_.arranged(cell, source_));
}

}  // namespace raygauge
