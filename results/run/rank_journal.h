// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "results/journal/cell_journal.h"
#include "results/run/stored_records.h"

namespace raygauge {

/// What a process stores that works on a run which another process has opened: its cells, in a journal of its
/// own in the run directory. The one with the RunWriter merges it at the end.
class RankJournal final : public RecordSink {
 public:
  /// The session of `source` has been begun by RunWriter::begin(). Throws ResultsError.
  RankJournal(const std::filesystem::path& target, const Experiment& experiment, RecordSource source);

  void store(const CellResult& cell) override;

 private:
  RecordArranger arranger_;
  RecordSource source_;
  CellJournal journal_;
};

}  // namespace raygauge
