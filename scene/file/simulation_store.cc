// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/file/simulation_store.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "results/disk/atomic_file.h"
#include "results/disk/run_directory.h"
#include "results/exceptions.h"
#include "results/hdf5/checksum.h"
#include "results/hdf5/hdf5_library.h"
#include "results/run/identity.h"
#include "results/schema/column_io.h"
#include "results/schema/table_reader.h"
#include "scene/file/number_archive.h"

namespace raygauge {
namespace fs = std::filesystem;
namespace {

constexpr PartKind kPart{"simulation-"};
constexpr const char* kFormat = "raygauge-simulation-part";

struct NumberRow {
  double number = 0;
};

const std::vector<Column<NumberRow>>& number_columns() {
  static const std::vector<Column<NumberRow>> kColumns = {
      column("number", "1", "all numbers of the part, one after the other", &NumberRow::number)};
  return kColumns;
}

template <class Archive, class Stored>
void pass_all(Archive& archive, Stored& stored) {
  archive.pass(stored.simulation);
  archive.pass(stored.seconds);
  archive.pass(stored.part);
}

}  // namespace

std::string encode_part(const StoredSimulationPart& stored, const std::string& identity) {
  NumberWriter writer;
  StoredSimulationPart copy = stored;  // one text for both directions
  pass_all(writer, copy);
  std::vector<NumberRow> rows;
  for (const double number : writer.numbers) rows.push_back({number});
  return hdf5::file_image([&](H5::Group& root) {
    hdf5::write_attribute(root, "format", std::string(kFormat));
    hdf5::write_attribute(root, hdf5::kChecksumAttribute, std::string(hdf5::kChecksumMeaning));
    hdf5::write_text(root, "identity", identity);
    hdf5::write_table(root, "numbers", number_columns(), rows, hdf5::Layout::packed);
  });
}

StoredSimulationPart decode_part(const fs::path& path, const std::string& identity) {
  NumberReader reader(path.string());
  std::string of;
  hdf5::read_own_file(path, [&](H5::Group& root) {
    if (!root.attrExists("format") || hdf5::read_text_attribute(root, "format", path.string()) != kFormat)
      throw ResultsError(path.string() + ": not a part of a simulation");
    of = hdf5::read_text(root, "identity", path.string());
    for (const NumberRow& row : hdf5::read_table(root, "numbers", number_columns(), path.string() + ": "))
      reader.numbers.push_back(row.number);
  });
  const std::string difference = identity_difference(of, identity);
  if (!difference.empty()) throw OtherExperimentError(path.string() + ": is of another scene: " + difference);
  StoredSimulationPart stored;
  pass_all(reader, stored);
  reader.require_end();
  return stored;
}

std::vector<fs::path> list_simulation_parts(const fs::path& target) {
  return parts_named(target, kPart.prefix);
}

SimulationStore::SimulationStore(fs::path target, std::string identity)
    : target_(std::move(target)), identity_(std::move(identity)) {
  for (const fs::path& path : list_simulation_parts(target_)) before_.push_back(decode_part(path, identity_));
  next_ = before_.size();
}

std::vector<SimulationPart> SimulationStore::parts_of(std::int32_t simulation) const {
  std::vector<SimulationPart> parts;
  for (const StoredSimulationPart& stored : before_) {
    if (stored.simulation == simulation) parts.push_back(stored.part);
  }
  return parts;
}

double SimulationStore::seconds_of(std::int32_t simulation) const {
  double seconds = 0;
  for (const StoredSimulationPart& stored : before_)
    seconds += stored.simulation == simulation ? stored.seconds : 0;
  return seconds;
}

void SimulationStore::store(std::int32_t simulation, const SimulationPart& part) {
  constexpr std::chrono::seconds kPause{1};
  constexpr int kShare = 4;  // storing takes a fifth of the time at most
  const Clock::time_point begun = Clock::now();
  const fs::path path = parts_folder(target_) / part_name(kPart, next_++);
  const double seconds = std::chrono::duration<double>(begun - last_).count();
  write_part(path, encode_part({simulation, seconds, part}, identity_));
  last_ = Clock::now();
  due_ = last_ + std::max<Clock::duration>(kPause, kShare * (last_ - begun));
}

void SimulationStore::clear() {
  for (const fs::path& path : list_simulation_parts(target_)) fs::remove(path);
  before_.clear();
}

}  // namespace raygauge
