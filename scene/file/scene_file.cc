// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/file/scene_file.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <set>

#include "engine/numerics/number_text.h"
#include "results/disk/run_directory.h"
#include "results/exceptions.h"
#include "results/hdf5/checksum.h"
#include "results/hdf5/hdf5_library.h"
#include "results/journal/csv.h"
#include "results/schema/column_io.h"
#include "results/schema/session_tables.h"
#include "results/schema/table_reader.h"
#include "scene/file/scene_writer.h"

namespace raygauge {
namespace fs = std::filesystem;
namespace {

using hdf5::Layout;

constexpr const char* kSceneFormat = "raygauge-scene";

void check_format(const H5::Group& root, const std::string& file) {
  if (!root.attrExists("format") || hdf5::read_text_attribute(root, "format", file) != kSceneFormat) {
    throw ResultsError(file + ": an HDF5 file, but not the results of a scene");
  }
  const std::int64_t version = hdf5::read_integer_attribute(root, "schema_version", file);
  require_schema_version(file + ": a scene", version, kReadSceneSchemas);
}

void require_row(std::int64_t row, std::size_t rows, const char* table, const std::string& path) {
  if (row >= 0 && static_cast<std::size_t>(row) < rows) return;
  throw ResultsError(path + ": row " + std::to_string(row) + " is not in /" + table);
}

/// Names that records and tallies refer to are there.
void require_known(const SceneFile& file, const std::string& path) {
  for (const SceneRow& row : file.records) {
    require_row(row.record.query, file.queries.size(), "queries", path);
    require_row(row.record.body_a, file.bodies.size(), "bodies", path);
    require_row(row.record.body_b, file.bodies.size(), "bodies", path);
  }
  for (const SceneTallyRow& row : file.tallies) require_row(row.query, file.queries.size(), "queries", path);
  if (!file.simulation) return;
  const std::size_t simulations = file.simulation->simulations.size();
  for (const StateRow& row : file.simulation->states) {
    require_row(row.body, file.bodies.size(), "bodies", path);
    require_row(row.simulation, simulations, "simulations", path);
  }
  for (const StepRow& row : file.simulation->steps)
    require_row(row.simulation, simulations, "simulations", path);
  for (const ContactRow& row : file.simulation->contacts) {
    require_row(row.simulation, simulations, "simulations", path);
    require_row(row.body_a, file.bodies.size(), "bodies", path);
    require_row(row.body_b, file.bodies.size(), "bodies", path);
  }
}

// Rows are long: each is moved once.
template <class Row>
void sort_by_cell(std::vector<Row>& rows) {
  const auto by_cell = [](const Row& x, const Row& y) { return x.cell < y.cell; };
  if (std::is_sorted(rows.begin(), rows.end(), by_cell)) return;
  std::vector<std::size_t> order(rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&rows](std::size_t x, std::size_t y) { return rows[x].cell < rows[y].cell; });
  std::vector<Row> sorted;
  sorted.reserve(rows.size());
  for (const std::size_t i : order) sorted.push_back(std::move(rows[i]));
  rows = std::move(sorted);
}

}  // namespace

void sort_scene(SceneFile& file) {
  sort_by_cell(file.records);
  sort_by_cell(file.tallies);
  sort_by_cell(file.cells);
}

std::string encode_scene(const SceneFile& file) {
  return hdf5::file_image([&](H5::Group& root) {
    hdf5::write_attribute(root, "format", std::string(kSceneFormat));
    hdf5::write_attribute(root, "schema_version", std::int64_t{kSceneSchemaVersion});
    hdf5::write_attribute(root, "raygauge_version", build_info().raygauge_version);
    hdf5::write_attribute(root, hdf5::kChecksumAttribute, std::string(hdf5::kChecksumMeaning));
    hdf5::write_attribute(root, "cell_count", static_cast<std::int64_t>(file.cell_count));
    hdf5::write_text(root, "name", file.name);
    hdf5::write_text(root, "scene", file.text);
    hdf5::write_text(root, "identity", file.identity);
    hdf5::write_text(root, "drawing", file.drawing);
    write_sessions(root, file.sessions);
    const Layout layout = file.records.size() > 64 ? Layout::packed : Layout::plain;
    hdf5::write_table(root, "records", scene_record_columns(), file.records, layout);
    hdf5::write_table(root, "tallies", scene_tally_columns(), file.tallies, Layout::plain);
    hdf5::write_table(root, "cells", scene_cell_columns(), file.cells, Layout::plain);
    hdf5::write_table(root, "bodies", scene_body_columns(), file.bodies, Layout::plain);
    hdf5::write_table(root, "queries", scene_query_columns(), file.queries, Layout::plain);
    if (!file.simulation) return;
    hdf5::write_table(root, "simulations", simulation_columns(), file.simulation->simulations, Layout::plain);
    hdf5::write_table(root, "states", state_columns(), file.simulation->states, Layout::packed);
    hdf5::write_table(root, "contacts", contact_columns(), file.simulation->contacts, Layout::packed);
    hdf5::write_table(root, "steps", step_columns(), file.simulation->steps, Layout::packed);
  });
}

SceneFile decode_scene(const fs::path& path) {
  SceneFile file;
  const std::string place = path.string() + ": ";
  file.has_checksum = hdf5::read_own_file(path, [&](H5::Group& root) {
    check_format(root, path.string());
    file.cell_count = static_cast<std::uint64_t>(hdf5::read_integer_attribute(root, "cell_count", place));
    file.name = hdf5::read_text(root, "name", place);
    file.text = hdf5::read_text(root, "scene", place);
    file.identity = hdf5::read_text(root, "identity", place);
    file.drawing = hdf5::read_text(root, "drawing", place);
    file.sessions = read_sessions(root, place);
    file.records = hdf5::read_table(root, "records", scene_record_columns(), place);
    file.tallies = hdf5::read_table(root, "tallies", scene_tally_columns(), place);
    file.cells = hdf5::read_table(root, "cells", scene_cell_columns(), place);
    file.bodies = hdf5::read_table(root, "bodies", scene_body_columns(), place);
    file.queries = hdf5::read_table(root, "queries", scene_query_columns(), place);
    if (!root.nameExists("states")) return;
    file.simulation = SimulationTables{hdf5::read_table(root, "simulations", simulation_columns(), place),
                                       hdf5::read_table(root, "states", state_columns(), place),
                                       hdf5::read_table(root, "contacts", contact_columns(), place),
                                       hdf5::read_table(root, "steps", step_columns(), place)};
  });
  require_known(file, path.string());
  return file;
}

bool is_scene_file(const fs::path& path) {
  if (!fs::exists(path)) return !list_scene_parts(path).empty();
  bool scene = false;
  try {
    hdf5::read_file(path, [&](H5::Group& root) {
      scene = root.attrExists("format") &&
              hdf5::read_text_attribute(root, "format", path.string()) == kSceneFormat;
    });
  } catch (const ResultsError&) {
    return false;  // whoever reads it says why it cannot be read
  }
  return scene;
}

namespace {

// Cells of `part` that are not `known` yet.
void add_cells(const SceneFile& part, std::set<std::uint64_t>& known, SceneFile& all) {
  const auto add = [&known](const auto& rows, auto& to) {
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(to),
                 [&known](const auto& row) { return known.count(row.cell) == 0; });
  };
  add(part.records, all.records);
  add(part.tallies, all.tallies);
  add(part.cells, all.cells);
  for (const SceneCellRow& row : part.cells) known.insert(row.cell);
}

}  // namespace

SceneFile read_scene_file(const fs::path& path) {
  const std::vector<fs::path> parts = list_scene_parts(path);
  if (parts.empty()) return decode_scene(path);
  SceneFile all;
  bool first = true;
  std::set<std::uint64_t> known;
  if (fs::exists(path)) {
    all = decode_scene(path);
    first = false;
    for (const SceneCellRow& row : all.cells) known.insert(row.cell);
  }
  for (const fs::path& part_path : parts) {
    SceneFile part = decode_scene(part_path);
    if (first) {
      all = std::move(part);
      first = false;
      for (const SceneCellRow& row : all.cells) known.insert(row.cell);
      continue;
    }
    if (part.identity != all.identity) {
      throw ResultsError(part_path.string() + ": belongs to another scene than the parts before it");
    }
    all.has_checksum = all.has_checksum && part.has_checksum;
    if (all.drawing.empty()) all.drawing = part.drawing;
    if (part.sessions.size() > all.sessions.size()) all.sessions = part.sessions;
    add_cells(part, known, all);
  }
  sort_scene(all);
  return all;
}

namespace {

/// Rows of another table are exported by their names.
std::string exported(const SceneFile& file, const std::vector<std::string>& queries,
                     const Column<SceneRow>& column, const SceneRow& row) {
  const SceneRecord& record = row.record;
  const auto body = [&](std::int32_t number) {
    return csv_field(file.bodies.at(static_cast<std::size_t>(number)).name);
  };
  if (column.name == "query") return csv_field(queries.at(static_cast<std::size_t>(record.query)));
  if (column.name == "body_a") return body(record.body_a);
  if (column.name == "body_b") return body(record.body_b);
  return csv_field(column.get(row));
}

}  // namespace

std::vector<SceneTally> tallies_of(const SceneFile& file) {
  std::vector<SceneTally> tallies(file.queries.size());
  for (const SceneTallyRow& row : file.tallies) tallies[static_cast<std::size_t>(row.query)] += row.tally;
  return tallies;
}

std::vector<std::string> distinct_query_names(const SceneFile& file) {
  std::map<std::string, std::size_t> count;
  for (const SceneQueryRow& query : file.queries) ++count[query.name];
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const SceneQueryRow& query : file.queries) {
    std::string name = query.name;
    if (count[name] > 1) name += " (tolerance " + rounded_text(query.tolerance, 6) + ")";
    for (int k = 2; !taken.insert(name).second; ++k) name = query.name + " (" + std::to_string(k) + ")";
    names.push_back(std::move(name));
  }
  return names;
}

std::string scene_csv(const SceneFile& file) {
  const std::vector<std::string> queries = distinct_query_names(file);
  return csv_table(scene_record_columns(), file.records,
                   [&](const Column<SceneRow>& column, const SceneRow& row) {
                     return exported(file, queries, column, row);
                   });
}

}  // namespace raygauge
