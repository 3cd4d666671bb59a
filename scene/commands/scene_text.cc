// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/commands/scene_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <tuple>
#include <vector>

#include "cli/output/terminal.h"
#include "results/text/language.h"
#include "results/text/words.h"
#include "scene/file/events.h"

namespace raygauge::cli {
namespace {

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

std::string printable_pair(const SceneFile& file, std::int32_t a, std::int32_t b) {
  return language::printable(pair_name(file, a, b));
}

std::string query_name(const SceneFile& file, int query) {
  return language::printable(file.queries[static_cast<std::size_t>(query)].name);
}

SceneCounters counters_of(const SceneFile& file) {
  SceneCounters sum;
  for (const SceneCellRow& row : file.cells) sum += row.counters;
  return sum;
}

std::string line_of(const SceneFile& file, const SceneEvent& event) {
  return "  " + query_name(file, event.query) + ": " + printable_pair(file, event.a, event.b) + ": " +
         event.text + "\n";
}

std::string simulated_lines(const SimulationTables& tables) {
  std::string text;
  for (const SimulationRow& row : tables.simulations) {
    text += "  simulated by " + language::printable(row.engine) + ": " + counted(row.steps, "step") +
            " of at most " + number(row.step) + " s, " + counted(row.impacts, "impact") + ", " +
            counted(row.cuts, "cut");
    if (row.least_distance < 0)
      text += "; proven: no pair closer than " + number(row.least_distance) +
              (row.unproven > 0 ? ", but for " + counted(row.unproven, "step") : "");
    text += '\n';
  }
  return text;
}

Json simulations_json(const SimulationTables& tables) {
  Json all = Json::array();
  for (const SimulationRow& row : tables.simulations) {
    Json one;
    for (const Column<SimulationRow>& column : simulation_columns())
      std::visit([&](const auto& value) { one[column.name] = value; }, column.get(row));
    all.push_back(one);
  }
  return all;
}

}  // namespace

std::string tally_text(const SceneFile& file) {
  const std::vector<SceneTally> tallies = tallies_of(file);
  std::string text;
  for (std::size_t q = 0; q < tallies.size(); ++q) {
    const SceneTally& tally = tallies[q];
    text += "  " + query_name(file, static_cast<int>(q)) + " (" +
            language::printable(file.queries[q].effects) + "): " + counted(tally.asked, "answer") + ": " +
            std::to_string(tally.solved) + " solved";
    if (tally.shared > 0) text += " (" + std::to_string(tally.shared) + " by another query)";
    text += ", " + std::to_string(tally.broad_phase) + " broad phase, " + std::to_string(tally.coherence) +
            " coherence, " + std::to_string(tally.standing) + " static\n";
  }
  const SceneCounters counters = counters_of(file);
  text += "  solves of convex parts: " + std::to_string(counters.distance_solves) + " distance, " +
          std::to_string(counters.separation_solves) + " separation, " +
          std::to_string(counters.growth_solves) + " growth; " + counted(counters.closest_points, "pair") +
          " of closest points, " + counted(counters.gradients, "gradient") + ", " +
          counted(counters.depths, "depth") + "\n";
  return text;
}

std::string event_text(const SceneFile& file) {
  std::string text;
  for (const SceneEvent& event : changes_of(file)) text += line_of(file, event);
  return text;
}

std::string scene_info_text(const std::string& path, const SceneFile& file) {
  std::string text = path + ": results of the scene '" + language::printable(file.name) + "'\n";
  text += "  " + counted(file.bodies.size(), "body", "bodies") + ", " +
          counted(file.queries.size(), "query", "queries");
  if (!file.queries.empty())
    text += ", " + std::to_string(file.cells.size()) + " of " + counted(file.cell_count, "cell") + ", " +
            counted(file.records.size(), "record");
  text += "\n" + (file.simulation ? simulated_lines(*file.simulation) : "");
  for (const Session& session : file.sessions) {
    text += "  session started " + language::printable(session.started_at) + ", " +
            counted(session.threads, "thread") + ", commit " + language::printable(session.build.git_commit) +
            ", " + language::printable(session.machine.cpu_model) + "\n";
  }
  if (!file.has_checksum) text += std::string("  ") + kNoChecksum + "\n";
  return file.queries.empty() ? text : text + tally_text(file);
}

Json scene_info_json(const std::string& path, const SceneFile& file) {
  Json json;
  json["file"] = path;
  json["scene"] = file.name;
  json["finished"] = file.finished();
  json["checksum"] = file.has_checksum;
  json["cells"] = file.cells.size();
  json["cell_count"] = file.cell_count;
  json["records"] = file.records.size();
  json["bodies"] = Json::array();
  for (const SceneBodyRow& body : file.bodies) json["bodies"].push_back(body.name);
  const std::vector<SceneTally> tallies = tallies_of(file);
  for (std::size_t q = 0; q < tallies.size(); ++q) {
    Json query;
    query["name"] = file.queries[q].name;
    query["effects"] = file.queries[q].effects;
    for (const Column<SceneTallyRow>& column : scene_tally_columns()) {
      if (column.name == "cell" || column.name == "query") continue;
      query[column.name] = std::get<std::int64_t>(column.get({0, 0, tallies[q]}));
    }
    json["queries"].push_back(query);
  }
  if (file.simulation) json["simulations"] = simulations_json(*file.simulation);
  const SceneCounters counters = counters_of(file);
  for (const Column<SceneCellRow>& column : scene_cell_columns()) {
    if (column.type == ValueType::int64)
      json["counters"][column.name] = std::get<std::int64_t>(column.get({0, counters, 0}));
  }
  return json;
}

namespace {

/// What the table says of one pair under one query.
struct PairLine {
  std::int64_t rows = 0, contacts = 0;
  double least = std::numeric_limits<double>::infinity();  ///< signed distance, or growth where there is none
  double lower = 0, time = 0, seconds = 0, widest_gap = 0;

  void add(const SceneRecord& record) {
    ++rows;
    seconds += record.seconds;
    if (record.status == SceneStatus::intersecting) ++contacts;
    const bool distance = !std::isnan(record.distance);
    const double value = distance ? record.signed_distance() : record.growth;
    if (distance && record.upper > 0)
      widest_gap = std::max(widest_gap, (record.upper - record.lower) / record.upper);
    if (record.depth_upper > 0)
      widest_gap = std::max(widest_gap, (record.depth_upper - record.depth_lower) / record.depth_upper);
    if (!(value < least)) return;
    least = value;
    lower = distance ? record.signed_lower() : record.growth_lower;
    time = record.time;
  }

  std::string text() const {
    const bool valued = std::isfinite(least);
    return std::to_string(rows) + ", " + std::to_string(contacts) +
           (valued ? ", " + number(least) + ", " + number(lower) + ", " + number(time) : ", , , ") + ", " +
           number(widest_gap) + ", " + number(seconds);
  }
};

}  // namespace

namespace {

std::string short_text(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

std::string table_of(const SimulationTables& tables) {
  std::string text;
  for (const Column<SimulationRow>& column : simulation_columns())
    text += (text.empty() ? "" : ", ") + column.name + (column.unit == "s" ? " [s]" : "");
  text += '\n';
  for (const SimulationRow& row : tables.simulations) {
    for (const Column<SimulationRow>& column : simulation_columns()) {
      if (&column != &simulation_columns().front()) text += ", ";
      const Value value = column.get(row);
      if (const double* number = std::get_if<double>(&value))
        text += short_text(*number);
      else if (const auto* count = std::get_if<std::int64_t>(&value))
        text += std::to_string(*count);
      else if (const auto* name = std::get_if<std::string>(&value))
        text += language::csv(language::printable(*name));
      else
        text += std::to_string(std::get<std::int32_t>(value));
    }
    text += '\n';
  }
  return text;
}

}  // namespace

std::string simulations_text(const SimulationTables& tables, bool contact) {
  if (tables.simulations.size() != 1)
    return counted(tables.simulations.size(), "simulation") + "\n" + table_of(tables);
  const SimulationRow& row = tables.simulations.front();
  std::string text = counted(row.steps, "step") + " in " + duration_text(row.seconds) + "; " +
                     counted(row.impacts, "impact") + ", " + counted(row.cuts, "cut") + ", " +
                     counted(row.contacts, "contact") + "\n";
  if (!contact) text += "  contact    not asked for: bodies pass through each other\n";
  if (contact) text += "  proven     no pair closer than " + short_text(row.least_distance) + " at any time";
  if (contact && row.unproven > 0) text += ", but for " + counted(row.unproven, "step");
  if (contact) text += "\n";
  if (std::isnan(row.residual))
    return text + "  residual   not known of " + language::printable(row.engine) + "\n";
  constexpr double kAim = 1e-8;
  char residual[32];
  std::snprintf(residual, sizeof residual, "%.2g", row.residual);
  text = text + "  residual   " + residual + " at most";
  return text + (row.residual > kAim ? ", above 1e-8: contact and friction are no more exact\n" : "\n");
}

std::string scene_table_text(const SceneFile& file) {
  std::map<std::tuple<int, int, int>, PairLine> lines;
  std::string events;
  for (const SceneRow& row : file.records) {
    const SceneRecord& record = row.record;
    if (record.at_instant())
      lines[{record.query, record.body_a, record.body_b}].add(record);
    else
      events += line_of(file, event_of(file, record));
  }
  std::string text = file.simulation ? table_of(*file.simulation) : "";
  if (!lines.empty()) {
    text +=
        "query, pair, rows, in contact, least value, its lower bound, at time [s], widest relative gap, "
        "seconds\n";
  }
  for (const auto& [key, line] : lines) {
    const auto& [query, a, b] = key;
    text += language::csv(query_name(file, query)) + ", " + language::csv(printable_pair(file, a, b)) + ", " +
            line.text() + "\n";
  }
  return text + events;
}

}  // namespace raygauge::cli
