// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/merge.h"

#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "analysis/render/number_text.h"
#include "analysis/render/words.h"
#include "raygauge/exceptions.h"
#include "results/run/results_file.h"

namespace raygauge {
namespace {

std::string slowdown_text(const Calibration& calibration) {
  std::string text;
  for (const Calibration::Entry& entry : calibration.entries)
    text += (text.empty() ? "" : ", ") + entry.method + " " + padded_significant(entry.slowdown, 3);
  return text;
}

/// How the times of a run came about, where that matters.
std::string timing_note(const Provenance& provenance) {
  for (const Session& session : provenance.sessions) {
    if (session.timing != "parallel" || session.threads < 2) continue;
    std::string note = "timed with " + std::to_string(session.threads) + " threads at once";
    const std::string slowdown = slowdown_text(session.calibration);
    if (!slowdown.empty()) note += "; slowdown of single solves: " + slowdown;
    return note;
  }
  return "";
}

std::string unfinished_note(const ResultsFile& file) {
  const std::size_t done = file.cells().size();
  if (file.finished()) return "";
  return "unfinished, " + std::to_string(done) + " of " + counted(file.provenance.cell_count, "cell");
}

/// What tells one run from another.
std::string run_key(const Provenance& provenance) {
  std::string key = provenance.identity;
  for (const Session& session : provenance.sessions)
    key += "\n" + session.started_at + " " + session.machine.hostname;
  return key;
}

}  // namespace

MergedResults read_merged(const std::vector<std::string>& paths) {
  MergedResults merged;
  std::map<std::string, std::string> runs;
  std::set<std::string> machines;
  for (const std::string& path : paths) {
    ResultsFile file = read_results(path);
    const auto [place, first] = runs.emplace(run_key(file.provenance), path);
    if (!first) throw InvalidParameterError(path + " holds the same run as " + place->second);
    for (const std::string& note : {unfinished_note(file), timing_note(file.provenance)}) {
      if (!note.empty()) merged.notes.push_back(path + ": " + note);
    }
    for (const Session& session : file.provenance.sessions) machines.insert(session.machine.cpu_model);
    merged.records.insert(merged.records.end(), std::make_move_iterator(file.records.begin()),
                          std::make_move_iterator(file.records.end()));
    merged.files.push_back({path, std::move(file.provenance)});
  }
  if (machines.size() > 1) {
    std::string note = "times from different processors are mixed:";
    for (const std::string& machine : machines) note += " " + machine + ";";
    merged.notes.push_back(note.substr(0, note.size() - 1));
  }
  return merged;
}

}  // namespace raygauge
