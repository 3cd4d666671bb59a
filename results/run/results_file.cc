// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/run/results_file.h"

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <utility>

#include "results/disk/atomic_file.h"
#include "results/disk/run_directory.h"
#include "results/exceptions.h"
#include "results/hdf5/hdf5_library.h"
#include "results/journal/cell_journal.h"
#include "results/run/encoding.h"
#include "results/run/output_place.h"
#include "results/run/stored_cells.h"

namespace raygauge {
namespace fs = std::filesystem;
namespace {

/// Adds the sessions of `parts` that `provenance` does not have yet.
void add_sessions(Provenance& provenance, const PartList& parts) {
  for (const auto& [number, path] : parts.sessions) {
    if (number < provenance.sessions.size()) continue;
    Provenance part = decode_provenance(path);
    if (number == 0) {
      provenance = std::move(part);
    } else if (number != provenance.sessions.size()) {
      throw ResultsError(path.string() + ": the session before it is missing");
    } else if (part.identity != provenance.identity) {
      throw ResultsError(path.string() + ": belongs to another experiment than the sessions before it");
    } else {
      provenance.has_checksum = provenance.has_checksum && part.has_checksum;
      provenance.sessions.insert(provenance.sessions.end(), part.sessions.begin(), part.sessions.end());
    }
  }
}

/// Adds the cells of `parts`; those that `results` has too are dropped when it is sorted.
void add_cells(ResultsFile& results, const PartList& parts) {
  for (const auto& [session, path] : parts.journals) {
    if (session >= results.provenance.sessions.size()) {
      throw ResultsError(path.string() + ": the session of these cells is missing");
    }
    std::vector<Record> part = read_cell_journal(path);
    results.records.insert(results.records.end(), part.begin(), part.end());
  }
}

/// Puts each record where it belongs, moving it once: a sort of the records themselves would move each many
/// times, or need room for all of them twice. `order[i]` tells which comes i-th.
void permute(std::vector<Record>& records, std::vector<std::size_t>& order) {
  for (std::size_t start = 0; start < order.size(); ++start) {
    if (order[start] == start) continue;
    const Record first = records[start];
    std::size_t place = start;
    while (order[place] != start) {
      const std::size_t from = std::exchange(order[place], place);
      records[place] = records[from];
      place = from;
    }
    records[place] = first;
    order[place] = place;
  }
}

bool same_repetition(const Record& a, const Record& b) {
  return a.cell == b.cell && a.repetition == b.repetition;
}

ResultsFile read_once(const fs::path& path) {
  const PartList parts = list_parts(path);
  ResultsFile results;
  if (fs::exists(path) || parts.sessions.empty()) results = decode_results(path);
  add_sessions(results.provenance, parts);
  add_cells(results, parts);
  sort_by_cell(results.records);
  return results;
}

}  // namespace

void sort_by_cell(std::vector<Record>& records) {
  const auto before = [](const Record& a, const Record& b) {
    return std::pair(a.cell, a.repetition) < std::pair(b.cell, b.repetition);
  };
  if (!std::is_sorted(records.begin(), records.end(), before)) {  // finished files are in order
    std::vector<std::size_t> order(records.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return before(records[i], records[j]); });
    permute(records, order);
  }
  auto group = records.begin();  // of what stays, the first record of its repetition
  auto end = records.begin();
  for (auto it = records.begin(); it != records.end(); ++it) {
    if (end == records.begin() || !same_repetition(*group, *it)) group = end;
    const bool repeated =
        std::any_of(group, end, [&it](const Record& kept) { return kept.method == it->method; });
    if (repeated) continue;
    if (end != it) *end = *it;
    ++end;
  }
  records.erase(end, records.end());
}

std::set<std::uint64_t> ResultsFile::cells() const {
  return done_repetitions({&records}, provenance.identity).whole();
}

ResultsFile read_results(const std::string& path) {
  const fs::path file = behind_links(path);
  // A run that begins a session or ends while it is read adds parts, or replaces them by the file: what a
  // list of the folder missed. The second time it is there.
  try {
    return read_once(file);
  } catch (const ResultsError&) {
    return read_once(file);
  }
}

void require_results(const std::string& path) {
  const fs::path file = behind_links(path);
  if (!fs::exists(file) && fs::exists(parts_folder(file))) return;
  hdf5::read_own_file(file, [](H5::Group& /*root*/) {});
}

void write_results(const std::string& path, const ResultsFile& results) {
  write_atomically(path, encode_results(results));
}

}  // namespace raygauge
