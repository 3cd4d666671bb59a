// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "raygauge/sweep/experiment.h"
#include "raygauge/sweep/record.h"

namespace raygauge {

/// The process that stores records.
struct RecordSource {
  int session = 0;
  std::string host;
  int rank = 0;  ///< of MPI
};

/// Brings the records of an experiment's cells into the form in which they are stored.
class RecordArranger {
 public:
  explicit RecordArranger(const Experiment& experiment);

  /// The records by (repetition, method of the experiment), with what is known of their source, NaN in one
  /// pattern. Throws InvalidParameterError for a cell that is empty, or holds records of another cell or of
  /// an unknown method.
  std::vector<Record> arranged(const CellResult& cell, const RecordSource& source) const;

 private:
  std::map<std::string, int> method_rank_;  ///< label → position in the experiment
};

}  // namespace raygauge
