// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/run/stored_cells.h"

#include "results/run/identity.h"

namespace raygauge {

void append_results(ResultsFile& results, const ResultsFile& more) {
  if (results.provenance.sessions.empty()) {
    results = more;
    return;
  }
  const auto offset = static_cast<int>(results.provenance.sessions.size());
  std::vector<Session>& sessions = results.provenance.sessions;
  sessions.insert(sessions.end(), more.provenance.sessions.begin(), more.provenance.sessions.end());
  for (const Record& record : more.records) {
    results.records.push_back(record);
    results.records.back().session += offset;
  }
  sort_by_cell(results.records);
}

DoneCells done_repetitions(const std::vector<const std::vector<Record>*>& lists,
                           const std::string& identity) {
  const int repetitions = repetitions_of_whole_cells(identity);
  DoneCells done;
  for (const std::vector<Record>* records : lists) {
    const Record* before = nullptr;  // most often another method's on the same instance
    for (const Record& record : *records) {
      if (!before || record.cell != before->cell || record.repetition != before->repetition)
        done.add(record.cell, record.repetition, repetitions);
      before = &record;
    }
  }
  return done;
}

}  // namespace raygauge
