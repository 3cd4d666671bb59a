// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/run/encoding.h"

#include <new>
#include <stdexcept>

#include "results/hdf5/checksum.h"
#include "results/hdf5/hdf5_library.h"
#include "results/schema/column_io.h"
#include "results/schema/schema.h"
#include "results/schema/session_tables.h"
#include "results/schema/table_reader.h"

namespace raygauge {
namespace {

using hdf5::Layout;

void write_head(H5::Group& root) {
  hdf5::write_attribute(root, "format", std::string(kFormatName));
  hdf5::write_attribute(root, "schema_version", std::int64_t{kSchemaVersion});
  hdf5::write_attribute(root, "raygauge_version", build_info().raygauge_version);
  hdf5::write_attribute(root, hdf5::kChecksumAttribute, std::string(hdf5::kChecksumMeaning));
}

bool has_own_format(const H5::Group& root, const std::string& file) {
  return root.attrExists("format") && hdf5::read_text_attribute(root, "format", file) == kFormatName;
}

/// The schema version of the file, which is among those that are read.
std::int64_t check_head(const H5::Group& root, const std::string& file) {
  if (!has_own_format(root, file)) {
    throw ResultsError(file + ": an HDF5 file, but not one of raygauge's results");
  }
  const std::int64_t version = hdf5::read_integer_attribute(root, "schema_version", file);
  require_schema_version(file, version, kReadSchemas);
  return version;
}

void write_provenance(H5::Group& root, const Provenance& provenance) {
  H5::Group group = root.createGroup("provenance");
  hdf5::write_text(group, "experiment", provenance.experiment_text);
  hdf5::write_text(group, "identity", provenance.identity);
  hdf5::write_attribute(group, "cell_count", static_cast<std::int64_t>(provenance.cell_count));
  std::vector<CalibrationRow> calibrations;
  for (std::size_t i = 0; i < provenance.sessions.size(); ++i) {
    const auto number = static_cast<std::int32_t>(i);
    const Session& session = provenance.sessions[i];
    for (const Calibration::Entry& entry : session.calibration.entries) {
      calibrations.push_back({number, session.calibration.threads, entry.method, entry.serial_seconds,
                              entry.parallel_seconds, entry.slowdown, entry.slowdown_lower,
                              entry.slowdown_upper});
    }
  }
  write_sessions(group, provenance.sessions);
  hdf5::write_table(group, "calibration", calibration_columns(), calibrations, Layout::plain);
}

/// The session that a row of the calibration belongs to.
Session& session_of(Provenance& provenance, std::int32_t number, const std::string& place) {
  if (number < 0 || static_cast<std::size_t>(number) >= provenance.sessions.size()) {
    throw ResultsError(place + ": session " + std::to_string(number) + " is not in /provenance/sessions");
  }
  return provenance.sessions[static_cast<std::size_t>(number)];
}

Provenance read_provenance(const H5::Group& root, const std::string& file) {
  const H5::Group group = hdf5::open_group(root, "provenance", file + ": ");
  const std::string place = file + ": /provenance";
  Provenance provenance;
  provenance.experiment_text = hdf5::read_text(group, "experiment", place);
  provenance.identity = hdf5::read_text(group, "identity", place);
  provenance.cell_count =
      static_cast<std::uint64_t>(hdf5::read_integer_attribute(group, "cell_count", place));
  provenance.sessions = read_sessions(group, place);
  for (const CalibrationRow& row : hdf5::read_table(group, "calibration", calibration_columns(), place)) {
    Calibration& calibration = session_of(provenance, row.session, place + "/calibration").calibration;
    calibration.threads = row.threads;
    calibration.entries.push_back({row.method, row.serial_seconds, row.parallel_seconds, row.slowdown,
                                   row.slowdown_lower, row.slowdown_upper});
  }
  return provenance;
}

std::vector<Record> in_memory(const hdf5::StoredTable<Record>& records, const std::string& file) {
  try {
    return records.rows_by_threads();
  } catch (const std::bad_alloc&) {
    throw ResultsError(file + ": does not fit into memory");
  } catch (const std::length_error&) {
    throw ResultsError(file + ": does not fit into memory");
  }
}

}  // namespace

void write_description(H5::Group& root, const Provenance& provenance) {
  write_head(root);
  write_provenance(root, provenance);
}

std::string encode_results(const ResultsFile& results) {
  return hdf5::file_image([&](H5::Group& root) {
    write_head(root);
    hdf5::write_table(root, "records", record_columns(), results.records, Layout::packed);
    write_provenance(root, results.provenance);
  });
}

std::string encode_provenance(const Provenance& provenance) {
  return hdf5::file_image([&](H5::Group& root) {
    write_head(root);
    write_provenance(root, provenance);
  });
}

ResultsFile decode_results(const std::filesystem::path& path) {
  ResultsFile results;
  hdf5::StoredTable<Record> records;
  const bool has_checksum = hdf5::read_own_file(path, [&](H5::Group& root) {
    check_head(root, path.string());
    records = hdf5::StoredTable<Record>(root, "records", record_columns(), path.string() + ": ");
    results.provenance = read_provenance(root, path.string());
  });
  results.records = in_memory(records, path.string());
  results.provenance.has_checksum = has_checksum;
  return results;
}

Provenance decode_provenance(const std::filesystem::path& path) {
  Provenance provenance;
  const bool has_checksum = hdf5::read_own_file(path, [&](H5::Group& root) {
    check_head(root, path.string());
    provenance = read_provenance(root, path.string());
  });
  provenance.has_checksum = has_checksum;
  return provenance;
}

bool is_checked_of_this_version(const std::filesystem::path& path) {
  std::int64_t version = 0;
  const bool has_checksum =
      hdf5::read_own_file(path, [&](H5::Group& root) { version = check_head(root, path.string()); });
  return has_checksum && version == kSchemaVersion;
}

bool is_foreign_hdf5(const std::filesystem::path& path) {
  bool foreign = false;
  try {
    hdf5::read_file(path, [&](H5::Group& root) { foreign = !has_own_format(root, path.string()); });
  } catch (const ResultsError&) {
    return false;
  }
  return foreign;
}

}  // namespace raygauge
