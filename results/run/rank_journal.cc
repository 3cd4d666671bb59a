// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/run/rank_journal.h"

#include <cstdint>

#include "results/run/run_directory.h"

namespace raygauge {

RankJournal::RankJournal(const std::filesystem::path& target, const Experiment& experiment, int session)
    : arranger_(experiment),
      session_(session),
      journal_(journal_path(target, static_cast<std::uint64_t>(session_))) {}

void RankJournal::store(const CellResult& cell) {
  journal_.append(cell.cell, arranger_.arranged(cell, session_));
}

}  // namespace raygauge
