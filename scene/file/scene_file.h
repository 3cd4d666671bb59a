// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "raygauge/scene/scene_run.h"
#include "results/provenance/provenance.h"
#include "results/schema/column.h"
#include "results/schema/schema.h"
#include "scene/file/simulation_tables.h"

namespace raygauge {

/// Version of the layout of a scene's results; rises with every change of a column.
inline constexpr std::int32_t kSceneSchemaVersion = 2;
inline constexpr SchemaVersions kReadSceneSchemas = {2, kSceneSchemaVersion};  ///< from release 0.2 on

/// A row of /records.
struct SceneRow {
  std::uint64_t cell = 0;
  std::int32_t session = 0;
  SceneRecord record;
};

/// A row of /tallies: how the answers of one cell to one query came about.
struct SceneTallyRow {
  std::uint64_t cell = 0;
  std::int32_t query = 0;
  SceneTally tally;
};

/// A row of /cells.
struct SceneCellRow {
  std::uint64_t cell = 0;
  SceneCounters counters;
  double seconds = 0;
};

/// A row of /bodies.
struct SceneBodyRow {
  std::string name;
  std::int32_t parts = 1;
};

/// A row of /queries.
struct SceneQueryRow {
  std::string name;
  std::string effects;  ///< separated by blanks
  std::string metric;
  double within = 0;
  std::int64_t nearest = 0;
  double tolerance = 0;
  double contact = 0;
};

/// What describes a scene.
struct SceneHead {
  std::string name;
  std::string text;      ///< the TOML source
  std::string identity;  ///< what makes two scenes the same: names of bodies, queries, instants, all numbers
  std::string drawing;   ///< JSON: shapes as triangles and where bodies are, for pages
  std::uint64_t cell_count = 0;
  std::vector<Session> sessions;
  std::vector<SceneBodyRow> bodies;
  std::vector<SceneQueryRow> queries;
};

/// What a results file of a scene holds.
struct SceneFile : SceneHead {
  std::vector<SceneRow> records;
  std::vector<SceneTallyRow> tallies;
  std::vector<SceneCellRow> cells;
  std::optional<SimulationTables> simulation;  ///< of bodies that reacted
  bool has_checksum = true;  ///< of the file that it was read from (results/hdf5/checksum.h)

  bool finished() const noexcept { return cells.size() == cell_count; }
};

/// The tables, by which writer, reader, CSV and documentation go.
const std::vector<Column<SceneRow>>& scene_record_columns();
const std::vector<Column<SceneTallyRow>>& scene_tally_columns();
const std::vector<Column<SceneCellRow>>& scene_cell_columns();
const std::vector<Column<SceneBodyRow>>& scene_body_columns();
const std::vector<Column<SceneQueryRow>>& scene_query_columns();

/// How the answers to each query came about, over all cells.
std::vector<SceneTally> tallies_of(const SceneFile& file);

/// The names of the queries; where several have one name, as those of a list of tolerances, with what tells
/// them apart.
std::vector<std::string> distinct_query_names(const SceneFile& file);

/// Puts tables into the order of cells.
void sort_scene(SceneFile& file);

/// Whether `path`, or the parts of an unfinished run of that name, holds a scene's results.
bool is_scene_file(const std::filesystem::path& path);

/// The scene's results at `path`: the file, or the parts of a run that is unfinished. Throws ResultsError or
/// SchemaVersionError.
SceneFile read_scene_file(const std::filesystem::path& path);

/// The bytes of the file, and their inverse.
std::string encode_scene(const SceneFile& file);
SceneFile decode_scene(const std::filesystem::path& path);

/// The records as CSV, queries and bodies by their names.
std::string scene_csv(const SceneFile& file);

}  // namespace raygauge
