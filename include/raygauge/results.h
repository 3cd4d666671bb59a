// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

// The public interface of the library raygauge::results, which needs HDF5: results files of sweeps.
#if __cplusplus < 201709L && (!defined(_MSVC_LANG) || _MSVC_LANG < 202002L)
#error "raygauge needs C++20: compile with -std=c++20"
#else
#include <cstdint>
#include <memory>
#include <set>
#include <string>

#include "raygauge/sweep.h"
#include "raygauge/sweep/experiment.h"
#include "raygauge/sweep/record.h"

namespace raygauge {

/// What may already be where a run is to be written.
enum class RunMode : std::uint8_t {
  create,  ///< nothing
  resume,  ///< the same experiment, unfinished or finished; or nothing
  force,   ///< any run; it is discarded when the first cell of the new one is stored
};

/// Writes the file of a sweep that `raygauge table`, `plot` and `report` and Python's `rg.open` read:
///
///     ResultsWriter results("sweep.h5", experiment);
///     const SweepSummary summary = run_sweep(experiment, generators, methods, results, results.done());
///     results.finish(summary.calibration);
///
/// Every stored cell survives a kill, in the folder sweep.h5.parts, and is not run again under
/// RunMode::resume.
class ResultsWriter final : public RecordSink {
 public:
  /// Opens the run; an experiment without a text gets one of its name and description. Throws Error, with one
  /// line that names the file, where `mode` does not allow what is there, it is being written by another
  /// process, or the folder takes no file; InvalidParameterError as grid_of() does.
  ResultsWriter(const std::string& path, const Experiment& experiment, RunMode mode = RunMode::create);
  ~ResultsWriter() override;
  ResultsWriter(ResultsWriter&&) noexcept;
  ResultsWriter& operator=(ResultsWriter&&) noexcept;

  /// Cells that earlier sessions have stored.
  const std::set<std::uint64_t>& done() const noexcept;

  /// Stores a finished cell durably; from any thread. Throws Error where the disk does not take it, and
  /// InvalidParameterError for a cell that is stored already or records of another experiment.
  void store(const CellResult& cell) override;

  /// Merges all cells into the file. A run with cells left to do can still be resumed. Throws Error.
  void finish(const Calibration& calibration = {});

 private:
  std::unique_ptr<class RunWriter> writer_;
};

}  // namespace raygauge
#endif
