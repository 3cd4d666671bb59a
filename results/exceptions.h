// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/exceptions.h"

namespace raygauge {

/// A file of results, a dataset or a folder that cannot be read or written. The message is one line: which
/// file, which place in it, why.
class ResultsError : public Error {
 public:
  using Error::Error;
};

/// Something is already where a new run was to be written. Nothing was touched.
class ResultsExistError : public ResultsError {
 public:
  using ResultsError::ResultsError;
};

/// A run to be resumed belongs to another experiment; the message names the first key that differs.
class OtherExperimentError : public ResultsError {
 public:
  using ResultsError::ResultsError;
};

/// The file was written under a schema version that this program does not read.
class SchemaVersionError : public ResultsError {
 public:
  using ResultsError::ResultsError;
};

/// Another process is writing the same run.
class RunLockedError : public ResultsError {
 public:
  using ResultsError::ResultsError;
};

}  // namespace raygauge
