// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "raygauge/sweep/record.h"
#include "results/provenance/provenance.h"
#include "results/run/results_file.h"

namespace H5 {
class Group;
}

namespace raygauge {

/// Writes all of a results file but /records into its root.
void write_description(H5::Group& root, const Provenance& provenance);

/// The bytes of the HDF5 files of a run: the merged file, and the parts that describe its sessions. All carry
/// the root attributes `format` and `schema_version`.
std::string encode_results(const ResultsFile& results);       ///< /records and /provenance
std::string encode_provenance(const Provenance& provenance);  ///< /provenance

/// The inverses. Throw ResultsError or SchemaVersionError, naming file and place.
ResultsFile decode_results(const std::filesystem::path& path);
Provenance decode_provenance(const std::filesystem::path& path);

/// Whether such a file is of this schema version and has its checksum. Throws like decode_provenance.
bool is_checked_of_this_version(const std::filesystem::path& path);

/// Whether `path` is an HDF5 file that can be read and is not one of ours.
bool is_foreign_hdf5(const std::filesystem::path& path);

}  // namespace raygauge
