// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <array>

#include "results/exceptions.h"
#include "scene/file/scene_file.h"

namespace raygauge {
namespace {

// A column of a member of the record in a row.
template <class T>
Column<SceneRow> of_record(std::string name, std::string unit, std::string description,
                           T SceneRecord::*member) {
  return column(std::move(name), std::move(unit), std::move(description), &SceneRow::record, member);
}

template <class Enum, std::size_t count>
Column<SceneRow> word(const char* name, const char* description, Enum SceneRecord::*member,
                      const std::array<Enum, count>& values) {
  return {{name, "", description, ValueType::text},
          [member](const SceneRow& row) { return Value(std::string(to_string(row.record.*member))); },
          [member, values, name](SceneRow& row, const Value& value) {
            for (const Enum known : values) {
              if (to_string(known) != std::get<std::string>(value)) continue;
              row.record.*member = known;
              return;
            }
            throw ResultsError("'" + std::get<std::string>(value) + "' is no " + name);
          }};
}

Column<SceneRow> coordinate(const std::string& name, const char* description,
                            SmallVector SceneRecord::*member, int k) {
  return {{name + "_" + std::to_string(k + 1), "1", description, ValueType::float64},
          [member, k](const SceneRow& row) {
            const SmallVector& v = row.record.*member;
            return Value(k < v.size() ? v[k] : SceneRecord::kNone);
          },
          [member, k](SceneRow& row, const Value& value) {
            SmallVector& v = row.record.*member;
            const double x = std::get<double>(value);
            if (x != x) return;
            if (v.size() <= k) v.conservativeResize(k + 1);
            v[k] = x;
          }};
}

// clang-format off
std::vector<Column<SceneRow>> make_record_columns() {
  using Kind = SceneRowKind;
  using Status = SceneStatus;
  using Decision = SceneDecision;
  std::vector<Column<SceneRow>> columns = {
    column("cell", "1", "piece of work that the row belongs to", &SceneRow::cell),
    column("session", "1", "row of /sessions in which the row was made", &SceneRow::session),
    of_record("query", "1", "row of /queries", &SceneRecord::query),
    of_record("body_a", "1", "row of /bodies; the first of the pair", &SceneRecord::body_a),
    of_record("body_b", "1", "row of /bodies; the second of the pair", &SceneRecord::body_b),
    of_record("part_a", "1", "nearest convex part of body_a; -1: not looked for", &SceneRecord::part_a),
    of_record("part_b", "1", "nearest convex part of body_b; -1: not looked for", &SceneRecord::part_b),
    word("kind", "instant, time_of_impact or clearance", &SceneRecord::kind, std::array{Kind::instant, Kind::time_of_impact, Kind::clearance}),
    of_record("instant", "1", "number of the instant, from 0; -1: of the whole time", &SceneRecord::instant),
    of_record("time", "s", "time of the instant; of the contact; at which the clearance is attained", &SceneRecord::time),
    of_record("time_lower", "s", "proven that there is no contact before it: of a time of impact, and of the clearance of bodies that meet", &SceneRecord::time_lower),
    of_record("time_upper", "s", "proven that there is a contact at it, of the same; nan: there is none", &SceneRecord::time_upper),
    word("status", "separated, intersecting, undecided; of a time of impact contact, free, undecided", &SceneRecord::status, std::array{Status::separated, Status::intersecting, Status::undecided, Status::contact, Status::free}),
    word("decided", "by what: solved, broad_phase, coherence, static", &SceneRecord::decided, std::array{Decision::solved, Decision::broad_phase, Decision::coherence, Decision::standing}),
    of_record("distance", "1", "distance in the metric of the query; nan: not asked for", &SceneRecord::distance),
    of_record("lower", "1", "certified lower bound of the distance", &SceneRecord::lower),
    of_record("upper", "1", "certified upper bound of the distance", &SceneRecord::upper),
    of_record("growth", "1", "growth distance about the centres; below 1: the bodies overlap; nan: not asked for", &SceneRecord::growth),
    of_record("growth_lower", "1", "certified lower bound of the growth distance", &SceneRecord::growth_lower),
    of_record("growth_upper", "1", "certified upper bound of the growth distance", &SceneRecord::growth_upper),
    of_record("solves", "1", "pairs of convex parts solved for the row", &SceneRecord::solves),
    of_record("seconds", "s", "wall time of those solves", &SceneRecord::seconds),
  };
  for (int k = 0; k < kMostSceneDimensions; ++k) columns.push_back(coordinate("point_a", "closest point of body_a, one coordinate; nan: not asked for", &SceneRecord::point_a, k));
  for (int k = 0; k < kMostSceneDimensions; ++k) columns.push_back(coordinate("point_b", "closest point of body_b, one coordinate; nan: not asked for", &SceneRecord::point_b, k));
  for (int k = 0; k < kMostSceneDimensions; ++k) columns.push_back(coordinate("gradient", "gradient of the distance as body_a is translated, one coordinate; nan: not asked for", &SceneRecord::gradient, k));
  return columns;
}

}  // namespace

const std::vector<Column<SceneRow>>& scene_record_columns() {
  static const std::vector<Column<SceneRow>> kColumns = make_record_columns();
  return kColumns;
}

const std::vector<Column<SceneTallyRow>>& scene_tally_columns() {
  using Row = SceneTallyRow;
  static const std::vector<Column<Row>> kColumns = {
    column("cell", "1", "piece of work", &Row::cell),
    column("query", "1", "row of /queries", &Row::query),
    column("asked", "1", "answers asked for: pairs times instants; pairs for time_of_impact and clearance", &Row::tally, &SceneTally::asked),
    column("solved", "1", "answers by a solve", &Row::tally, &SceneTally::solved),
    column("broad_phase", "1", "answers by bounding balls", &Row::tally, &SceneTally::broad_phase),
    column("coherence", "1", "answers by bounds carried over from an earlier instant", &Row::tally, &SceneTally::coherence),
    column("static", "1", "answers repeated because neither body had moved", &Row::tally, &SceneTally::standing),
    column("shared", "1", "of the solved ones: taken from a solve of another query", &Row::tally, &SceneTally::shared),
  };
  return kColumns;
}

const std::vector<Column<SceneCellRow>>& scene_cell_columns() {
  using Row = SceneCellRow;
  static const std::vector<Column<Row>> kColumns = {
    column("cell", "1", "piece of work", &Row::cell),
    column("distance_solves", "1", "distances of two convex parts", &Row::counters, &SceneCounters::distance_solves),
    column("separation_solves", "1", "separation tests of two convex parts", &Row::counters, &SceneCounters::separation_solves),
    column("growth_solves", "1", "growth distances of two convex parts", &Row::counters, &SceneCounters::growth_solves),
    column("closest_points", "1", "pairs of closest points", &Row::counters, &SceneCounters::closest_points),
    column("gradients", "1", "gradients", &Row::counters, &SceneCounters::gradients),
    column("plane_tests", "1", "tests whether an earlier separating plane still separates two parts", &Row::counters, &SceneCounters::plane_tests),
    column("ball_tests", "1", "bounds from bounding balls", &Row::counters, &SceneCounters::ball_tests),
    column("support_queries", "1", "evaluations of a support function by solves", &Row::counters, &SceneCounters::support_queries),
    column("seconds", "s", "wall time of the cell", &Row::seconds),
  };
  return kColumns;
}

const std::vector<Column<SceneBodyRow>>& scene_body_columns() {
  static const std::vector<Column<SceneBodyRow>> kColumns = {
    column("name", "", "name of the body", &SceneBodyRow::name),
    column("parts", "1", "convex parts of the body", &SceneBodyRow::parts),
  };
  return kColumns;
}

const std::vector<Column<SceneQueryRow>>& scene_query_columns() {
  using Row = SceneQueryRow;
  static const std::vector<Column<Row>> kColumns = {
    column("name", "", "name of the query", &Row::name),
    column("effects", "", "what is asked for, separated by blanks", &Row::effects),
    column("metric", "", "euclidean, or the shape of the metric's unit ball", &Row::metric),
    column("within", "1", "only pairs of at most this distance are recorded; inf: all", &Row::within),
    column("nearest", "1", "only so many nearest pairs are recorded; 0: all", &Row::nearest),
    column("tolerance", "1", "requested relative gap (upper - lower) / upper", &Row::tolerance),
    column("contact", "1", "time of impact: a distance of at most this is a contact", &Row::contact),
  };
  return kColumns;
}
// clang-format on

}  // namespace raygauge
