// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <type_traits>
#include <variant>

#include "raygauge/exceptions.h"
#include "results/exceptions.h"
#include "scene/file/scene_file.h"

namespace raygauge {
namespace {

Column<SceneRow> coordinate(const SceneField& field, SmallVector SceneRecord::*member, int k) {
  return {{std::string(field.name) + "_" + std::to_string(k + 1), std::string(field.unit),
           std::string(field.text), ValueType::float64},
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

std::string text_of(SceneEffects kind) { return kind_text(kind); }
std::string text_of(SceneStatus status) { return std::string(to_string(status)); }
std::string text_of(SceneDecision decision) { return std::string(to_string(decision)); }
void read(const std::string& text, SceneEffects& kind) { kind = kind_from(text); }
void read(const std::string& text, SceneStatus& status) { status = status_from(text); }
void read(const std::string& text, SceneDecision& decision) { decision = decision_from(text); }

template <class Word>
Column<SceneRow> word(const SceneField& field, Word SceneRecord::*member) {
  return {{std::string(field.name), "", std::string(field.text), ValueType::text},
          [member](const SceneRow& row) { return Value(text_of(row.record.*member)); },
          [member](SceneRow& row, const Value& value) {
            try {
              read(std::get<std::string>(value), row.record.*member);
            } catch (const UnknownNameError& error) {
              throw ResultsError(error.what());
            }
          }};
}

void add_columns(const SceneField& field, std::vector<Column<SceneRow>>& columns) {
  std::visit(
      [&]<class T>(T SceneRecord::*member) {
        if constexpr (std::is_same_v<T, SmallVector>) {
          for (int k = 0; k < kMostSceneDimensions; ++k) columns.push_back(coordinate(field, member, k));
        } else if constexpr (std::is_enum_v<T>) {
          columns.push_back(word(field, member));
        } else {
          columns.push_back(column(std::string(field.name), std::string(field.unit), std::string(field.text),
                                   &SceneRow::record, member));
          if (field.later) columns.back().absent = columns.back().get(SceneRow());
        }
      },
      field.member);
}

std::vector<Column<SceneRow>> make_record_columns() {
  std::vector<Column<SceneRow>> columns = {
      column("cell", "1", "piece of work that the row belongs to", &SceneRow::cell),
      column("session", "1", "row of /sessions in which the row was made", &SceneRow::session)};
  for (const SceneField& field : scene_fields()) add_columns(field, columns);
  return columns;
}

}  // namespace

const std::vector<Column<SceneRow>>& scene_record_columns() {
  static const std::vector<Column<SceneRow>> kColumns = make_record_columns();
  return kColumns;
}

// clang-format off
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
    later(column("depths", "1", "depths of two convex parts that are not proven to be apart", &Row::counters, &SceneCounters::depths), std::int64_t{0}),
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
