// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/run/run_writer.h"

#include <algorithm>
#include <iterator>
#include <new>
#include <utility>

#include "results/exceptions.h"
#include "results/hdf5/hdf5_library.h"
#include "results/journal/csv.h"
#include "results/run/encoding.h"
#include "results/run/identity.h"
#include "results/run/output_place.h"

namespace raygauge {
namespace fs = std::filesystem;
namespace {

/// "3 cells", or "cells" where they cannot be read.
std::string cells_of(const PartList& parts) {
  ResultsFile stored;
  try {
    for (const auto& [session, path] : parts.journals) {
      const std::vector<Record> part = read_cell_journal(path);
      stored.records.insert(stored.records.end(), part.begin(), part.end());
    }
  } catch (const ResultsError&) {
    return "cells";
  }
  const std::size_t count = stored.cells().size();
  return std::to_string(count) + (count == 1 ? " cell" : " cells");
}

/// Adds what the other processes of a run have stored, whose sessions follow `session`.
void add_cells_after(int session, const PartList& parts, ResultsFile& results) {
  for (const auto& [number, path] : parts.journals) {
    if (number <= static_cast<std::uint64_t>(session)) continue;
    const std::vector<Record> part = read_cell_journal(path);
    results.records.insert(results.records.end(), part.begin(), part.end());
  }
}

}  // namespace

RunWriter::RunWriter(const std::string& path, const Experiment& experiment, RunMode mode, Session session)
    : RunWriter(path, experiment, mode, std::vector<Session>{std::move(session)}) {}

RunWriter::RunWriter(const std::string& path, const Experiment& experiment, RunMode mode,
                     std::vector<Session> sessions)
    : path_(behind_links(path)),
      mode_(mode),
      provenance_{experiment.text, experiment_identity(experiment), grid_of(experiment).size(),
                  std::move(sessions)},
      arranger_(experiment),
      directory_(path_),
      most_records_(provenance_.cell_count * static_cast<std::uint64_t>(experiment.repetitions) *
                    experiment.methods.size()) {
  if (mode == RunMode::create) refuse_existing();
  if (mode == RunMode::resume) resume_existing();
  if (mode == RunMode::force) refuse_foreign_file();
}

void RunWriter::refuse_existing() const {
  if (fs::exists(path_)) {
    throw ResultsExistError(path_.string() + ": exists already; --resume completes it, --force replaces it");
  }
  if (const PartList parts = directory_.parts(); !parts.empty()) {
    throw ResultsExistError(directory_.folder().string() + ": holds " + cells_of(parts) +
                            " of an unfinished run; --resume continues it, --force discards it");
  }
}

void RunWriter::resume_existing() {
  const PartList parts = directory_.parts();
  if (!fs::exists(path_) && parts.empty()) return;
  if (!fs::exists(path_) && parts.sessions.empty()) {
    throw ResultsError(directory_.folder().string() +
                       ": holds cells, but no session that tells their experiment");
  }
  results_ = read_results(path_.string());
  require_same_experiment(results_.provenance, path_.string());
  done_ = done_repetitions({&results_.records}, provenance_.identity);
  session_ = static_cast<int>(results_.provenance.sessions.size());
}

void RunWriter::refuse_foreign_file() const {
  if (!fs::exists(path_)) return;
  try {
    hdf5::require_hdf5(path_);
  } catch (const ResultsError& error) {
    throw ResultsExistError(std::string(error.what()) + "; not replaced even by --force");
  }
  if (is_foreign_hdf5(path_)) {
    throw ResultsExistError(
        path_.string() + ": an HDF5 file, but not one of raygauge's results; not replaced even by --force");
  }
}

void RunWriter::store_session() const {
  directory_.store_session(static_cast<std::uint64_t>(session_), encode_provenance(provenance_));
}

void RunWriter::require_same_experiment(const Provenance& other, const std::string& place) const {
  const std::string difference = identity_difference(other.identity, provenance_.identity);
  if (!difference.empty()) throw OtherExperimentError(place + ": holds another experiment: " + difference);
}

/// Takes the piece of a cell for this call, and has the session on the disk before its first one.
void RunWriter::claim(std::uint64_t cell, const std::vector<Record>& records) {
  const int first_repetition = records.front().repetition;
  const std::scoped_lock lock(mutex_);
  const auto partial = done_.partial().find(cell);
  const bool done = done_.whole().count(cell) != 0 ||
                    (partial != done_.partial().end() && partial->second.count(first_repetition) != 0);
  if (done || stored_.count({cell, first_repetition}) != 0) {
    throw InvalidParameterError("cell " + std::to_string(cell) + " is stored already");
  }
  if (!journal_) begin_session(records);
  stored_.emplace(cell, first_repetition);
}

void RunWriter::begin() {
  const std::scoped_lock lock(mutex_);
  if (!journal_) begin_session({});
}

/// Room for all records at once, if there is as much: while a vector grows, it holds them twice. Pages that
/// are not used cost nothing.
void RunWriter::reserve_records() {
  constexpr double kShare = 0.75;  // of the machine's memory
  const auto memory = static_cast<double>(provenance_.sessions.front().machine.memory_bytes);
  if (!(static_cast<double>(most_records_) * sizeof(Record) < kShare * memory)) return;
  try {
    results_.records.reserve(most_records_);
  } catch (const std::bad_alloc&) {  // a limit of the process: it grows as far as it may
  }
}

/// Under force the earlier run goes only once the disk has taken what is to stand in its place.
void RunWriter::begin_session(const std::vector<Record>& first) {
  directory_.require_held();
  if (mode_ == RunMode::force) {
    directory_.require_room(encode_provenance(provenance_) + csv_text(first));
    directory_.clear();
    fs::remove(path_);
  }
  store_session();
  journal_.emplace(directory_.journal_path(static_cast<std::uint64_t>(session_)));
  if (session_ == 0)
    results_.provenance = {provenance_.experiment_text, provenance_.identity, provenance_.cell_count, {}};
  reserve_records();
  std::vector<Session>& sessions = results_.provenance.sessions;
  sessions.insert(sessions.end(), provenance_.sessions.begin(), provenance_.sessions.end());
}

void RunWriter::store(const CellResult& cell) {
  const Session& session = provenance_.sessions.front();
  std::vector<Record> records = arranger_.arranged(cell, {session_, session.machine.hostname, session.rank});
  const int first_repetition = records.front().repetition;
  claim(cell.cell, records);
  try {
    journal_->append(cell.cell, records);
  } catch (...) {
    const std::scoped_lock lock(mutex_);
    stored_.erase({cell.cell, first_repetition});
    throw;
  }
  const std::scoped_lock lock(mutex_);
  std::copy(records.begin(), records.end(), std::back_inserter(results_.records));
}

/// Writes the one file. Only where that fails the session's part is told of its end and its calibration: two
/// more files brought to the disk would cost every run what they spare one that is killed right here.
void RunWriter::merge() const {
  try {
    directory_.store_target(encode_results(results_));
  } catch (const ResultsError&) {
    try {
      if (journal_) store_session();
    } catch (const ResultsError&) {  // the disk takes nothing at all: what it has stays as it is
    }
    throw;
  }
}

void RunWriter::finish(const Calibration& calibration) { finish(std::vector<Calibration>{calibration}); }

void RunWriter::finish(const std::vector<Calibration>& calibrations) {
  const std::scoped_lock lock(mutex_);
  if (mode_ == RunMode::force && !journal_) return;
  const bool anything_taken_in = !taken_in_.records.empty();
  if (directory_.parts().empty() && !anything_taken_in) return;
  directory_.require_held();
  if (journal_) {
    add_cells_after(session_, directory_.parts(), results_);
    for (std::size_t i = 0; i < provenance_.sessions.size(); ++i) {
      Session& session = provenance_.sessions[i];
      session.finished_at = utc_now();
      if (i < calibrations.size()) session.calibration = calibrations[i];
      results_.provenance.sessions[static_cast<std::size_t>(session_) + i] = session;
    }
  }
  if (anything_taken_in) append_results(results_, taken_in_);
  sort_by_cell(results_.records);
  merge();
  directory_.clear();
}

}  // namespace raygauge
