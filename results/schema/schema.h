// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "raygauge/sweep/record.h"
#include "results/provenance/provenance.h"
#include "results/schema/column.h"

namespace raygauge {

/// Version of the layout of a results file. It rises with every change of a column: added, removed, renamed,
/// or of another type, unit or meaning.
inline constexpr std::int32_t kSchemaVersion = 3;

/// The schema versions whose files are read: from that of the first release, 0.2, on. Columns that files of
/// an earlier release lack have defaults (Column::absent).
struct SchemaVersions {
  std::int64_t first;
  std::int64_t last;
};
inline constexpr SchemaVersions kReadSchemas = {3, kSchemaVersion};

/// The root attribute `format` of every results file, and how a journal of cells begins.
inline constexpr const char* kFormatName = "raygauge-results";

/// Throws SchemaVersionError for a version that is not among those `read`; `place` is the file, or "FILE: a
/// scene".
void require_schema_version(const std::string& place, std::int64_t version, SchemaVersions read);

/// A row of /provenance/versions.
struct VersionRow {
  std::int32_t session = 0;
  std::string name;
  std::string version;
};

/// A row of /provenance/calibration.
struct CalibrationRow {
  std::int32_t session = 0;
  std::int32_t threads = 1;
  std::string method;
  double serial_seconds = 0;
  double parallel_seconds = 0;
  double slowdown = 1;
  double slowdown_lower = std::numeric_limits<double>::quiet_NaN();
  double slowdown_upper = std::numeric_limits<double>::quiet_NaN();
};

/// The tables of a results file. Writer, reader, CSV export and the documentation's test all go by these: a
/// new column is one line in schema.cc.
const std::vector<Column<Record>>& record_columns();
const std::vector<Column<MachineInfo>>& machine_columns();
const std::vector<Column<Session>>&
session_columns();  ///< without machine, versions and calibration, which have tables of their own
const std::vector<Column<VersionRow>>& version_columns();
const std::vector<Column<CalibrationRow>>& calibration_columns();

}  // namespace raygauge
