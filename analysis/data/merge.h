// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "raygauge/sweep/record.h"
#include "results/provenance/provenance.h"

namespace raygauge {

/// Where some of the records come from.
struct MergedFile {
  std::string path;
  Provenance provenance;
};

/// The records of one or several results files.
struct MergedResults {
  std::vector<Record> records;  ///< in the order of the files
  std::vector<MergedFile> files;
  std::vector<std::string> notes;  ///< what a reader of any table of them should know: unfinished runs,
                                   ///< parallel timing and how much it inflates, different machines
};

/// The machines of the files' sessions: their hosts by processor.
std::map<std::string, std::set<std::string>> hosts_by_processor(const std::vector<MergedFile>& files);

/// "a, b, c and 97 more".
std::string host_words(const std::set<std::string>& hosts);

/// Reads and joins results files, unfinished runs included. Throws as read_results(), and
/// InvalidParameterError where two paths lead to the same run: its records would count twice.
MergedResults read_merged(const std::vector<std::string>& paths);

}  // namespace raygauge
