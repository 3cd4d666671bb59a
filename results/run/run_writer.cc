// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/run/run_writer.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>

#include "results/exceptions.h"
#include "results/hdf5/hdf5_library.h"
#include "results/journal/csv.h"
#include "results/run/identity.h"
#include "results/run/output_place.h"
#include "results/schema/encoding.h"
#include "results/schema/schema.h"

namespace raygauge {
namespace fs = std::filesystem;
namespace {

std::map<std::string, int> method_ranks(const Experiment& experiment) {
  std::map<std::string, int> ranks;
  for (const ComponentSpec& method : experiment.methods) {
    ranks.emplace(label_of(method), static_cast<int>(ranks.size()));
  }
  return ranks;
}

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

/// NaN has many bit patterns, but one spelling in a journal: so that a run that was resumed is, bit for bit,
/// one that was not.
void make_nan_plain(Record& record) {
  for (const Column<Record>& column : record_columns()) {
    if (column.type != ValueType::float64 || !std::isnan(std::get<double>(column.get(record)))) continue;
    column.set(record, std::numeric_limits<double>::quiet_NaN());
  }
}

}  // namespace

RunWriter::RunWriter(const std::string& path, const Experiment& experiment, RunMode mode, Session session)
    : path_(behind_links(path)),
      mode_(mode),
      provenance_{
          experiment.text, experiment_identity(experiment), grid_of(experiment).size(), {std::move(session)}},
      method_rank_(method_ranks(experiment)),
      directory_(path_) {
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
  const std::string difference = identity_difference(results_.provenance.identity, provenance_.identity);
  if (!difference.empty()) {
    throw OtherExperimentError(path_.string() + ": holds another experiment: " + difference);
  }
  done_ = results_.cells();
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

std::vector<Record> RunWriter::arranged(const CellResult& cell) const {
  const std::string place = "cell " + std::to_string(cell.cell);
  if (cell.records.empty()) throw InvalidParameterError(place + " has no records");
  std::vector<Record> records = cell.records;
  for (Record& record : records) {
    if (record.cell != cell.cell) {
      throw InvalidParameterError(place + " has a record of cell " + std::to_string(record.cell));
    }
    if (method_rank_.count(record.method) == 0) {
      throw InvalidParameterError(place + " has a record of method '" + record.method +
                                  "', which is not in the experiment");
    }
    record.session = session_;
    make_nan_plain(record);
  }
  const auto key = [this](const Record& record) {
    return std::make_tuple(record.repetition, method_rank_.at(record.method));
  };
  std::stable_sort(records.begin(), records.end(),
                   [&key](const Record& a, const Record& b) { return key(a) < key(b); });
  return records;
}

void RunWriter::store_session() const {
  directory_.store_session(static_cast<std::uint64_t>(session_), encode_provenance(provenance_));
}

/// Takes the cell for this call, and has the session on the disk before its first cell.
void RunWriter::claim(std::uint64_t cell, const std::vector<Record>& records) {
  const std::scoped_lock lock(mutex_);
  if (done_.count(cell) != 0 || stored_.count(cell) != 0) {
    throw InvalidParameterError("cell " + std::to_string(cell) + " is stored already");
  }
  if (!journal_) begin_session(records);
  stored_.insert(cell);
}

/// Under force the earlier run goes only once the disk has taken what is to stand in its place.
void RunWriter::begin_session(const std::vector<Record>& first) {
  if (mode_ == RunMode::force) {
    directory_.require_room(encode_provenance(provenance_) + csv_text(first));
    directory_.clear();
    fs::remove(path_);
  }
  store_session();
  journal_.emplace(directory_.journal_path(static_cast<std::uint64_t>(session_)));
  if (session_ == 0) {
    results_.provenance = provenance_;
  } else {
    results_.provenance.sessions.push_back(provenance_.sessions.front());
  }
}

void RunWriter::store(const CellResult& cell) {
  std::vector<Record> records = arranged(cell);
  claim(cell.cell, records);
  try {
    journal_->append(cell.cell, records);
  } catch (...) {
    const std::scoped_lock lock(mutex_);
    stored_.erase(cell.cell);
    throw;
  }
  const std::scoped_lock lock(mutex_);
  std::move(records.begin(), records.end(), std::back_inserter(results_.records));
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

void RunWriter::finish(const Calibration& calibration) {
  const std::scoped_lock lock(mutex_);
  if (journal_) {
    provenance_.sessions.front().finished_at = utc_now();
    provenance_.sessions.front().calibration = calibration;
    results_.provenance.sessions.back() = provenance_.sessions.front();
  }
  if (mode_ == RunMode::force && !journal_) return;
  if (directory_.parts().empty()) return;
  sort_by_cell(results_.records);
  merge();
  directory_.clear();
}

}  // namespace raygauge
