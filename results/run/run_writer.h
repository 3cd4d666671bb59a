// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "raygauge/results.h"
#include "raygauge/sweep.h"
#include "raygauge/sweep/experiment.h"
#include "raygauge/sweep/record.h"
#include "results/disk/run_directory.h"
#include "results/journal/cell_journal.h"
#include "results/provenance/provenance.h"
#include "results/run/results_file.h"
#include "results/run/stored_cells.h"
#include "results/run/stored_records.h"

namespace raygauge {

/// A run being written: from the first cell, through any number of kills and resumes, to the one file.
///
///     RunWriter run(path, experiment, RunMode::resume, describe_session(experiment, threads, solvers));
///     const SweepSummary summary = run_sweep(experiment, generators, methods, run, run.done());
///     run.finish(summary.calibration);
///
/// Cells land in the journal of the session (CellJournal) in the run directory; finish() merges them into
/// `path`. A run that ends without finish(), by a kill or an exception, keeps every stored cell there for a
/// resume. The merged file does not depend on the order in which cells finish, nor on how often the run was
/// resumed, but for times, threads and sessions.
class RunWriter final : public RecordSink {
 public:
  /// Opens `path`, or what it is a link to, for writing. Changes nothing that is there, but for leftovers of
  /// a kill. Throws
  ///   ResultsExistError     create, and there are results or parts of a run already; force, and the file
  ///                         there is not one of HDF5, or of somebody else's data,
  ///   OtherExperimentError  resume, and what is there belongs to another experiment,
  ///   SchemaVersionError, ResultsError  resume, and what is there cannot be read (see read_results),
  ///   RunLockedError        another process is writing this run,
  ///   ResultsError          the folder cannot be written.
  RunWriter(const std::string& path, const Experiment& experiment, RunMode mode, Session session);

  /// The same for a run of several processes: this one's session, then one for each that stores its cells by
  /// a RankJournal.
  RunWriter(const std::string& path, const Experiment& experiment, RunMode mode,
            std::vector<Session> sessions);

  /// Throws OtherExperimentError, with `place` in its message, unless the provenance is of this experiment.
  void require_same_experiment(const Provenance& other, const std::string& place) const;

  /// Adds what another file of the same experiment has stored, such as a shard: finish() writes it too, each
  /// repetition of a cell once.
  void take_in(const ResultsFile& results) { append_results(taken_in_, results); }

  /// Cells that earlier sessions have stored whole.
  const std::set<std::uint64_t>& done() const noexcept { return done_.whole(); }

  /// The number of this process's session in the run; the others' follow it.
  int session() const noexcept { return session_; }

  /// Has the sessions on the disk before any cell is stored. Throws like store().
  void begin();

  /// Stores a cell, or some repetitions of it, durably; thread safe. Throws InvalidParameterError for what is
  /// stored already, is empty, or holds records of another cell or of an unknown method; RunLockedError if
  /// the lock of the run was lost; ResultsError where it cannot be written (cells stored before stay).
  void store(const CellResult& cell) override;

  /// Merges everything stored into `path` and removes the parts. Where nothing is to be merged, as on
  /// resuming a finished run, the file stays as it is. A run that was stopped with cells left to do may be
  /// finished as well; it can still be resumed. Throws ResultsError; the parts then stay.
  void finish(const Calibration& calibration = {});

  /// The same with what each process has measured; none of them stores any more.
  void finish(const std::vector<Calibration>& calibrations);

  /// What the run holds, earlier sessions included. Not while cells are being stored.
  const ResultsFile& results() const noexcept { return results_; }

 private:
  void refuse_existing() const;
  void resume_existing();
  void refuse_foreign_file() const;
  void claim(std::uint64_t cell, const std::vector<Record>& records);
  void begin_session(const std::vector<Record>& first);
  void store_session() const;
  void reserve_records();
  void merge() const;

  std::filesystem::path path_;
  RunMode mode_;
  Provenance provenance_;  ///< of this session, and those of other processes, alone
  RecordArranger arranger_;
  RunDirectory directory_;
  DoneCells done_;
  ResultsFile taken_in_;
  std::uint64_t most_records_;
  int session_ = 0;  ///< number of this session in the run

  std::mutex mutex_;                                ///< guards what follows
  std::set<std::pair<std::uint64_t, int>> stored_;  ///< by this session: cell and first repetition
  ResultsFile results_;                 ///< what the disk holds, so that finish() need not read it again
  std::optional<CellJournal> journal_;  ///< once the session has begun: with its first cell
};

}  // namespace raygauge
