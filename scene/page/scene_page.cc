// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/page/scene_page.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "analysis/render/page_template.h"
#include "scene/page/scene_answers.h"

namespace raygauge::scene_page {
namespace {

using nlohmann::json;

/// NaN, which JSON has no word for, is null; infinity is "inf".
json number(double x) {
  if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
  return std::isnan(x) ? json(nullptr) : json(x);
}

json point(const SmallVector& v) {
  json list = json::array();
  for (Eigen::Index k = 0; k < v.size(); ++k) list.push_back(v[k]);
  return list;
}

/// The answers at instants, a list for each column.
json records_json(const SceneFile& file) {
  static const std::vector<std::pair<const char*, double SceneRecord::*>> kNumbers = {
      {"time", &SceneRecord::time},
      {"distance", &SceneRecord::distance},
      {"lower", &SceneRecord::lower},
      {"upper", &SceneRecord::upper},
      {"growth", &SceneRecord::growth},
      {"growth_lower", &SceneRecord::growth_lower},
      {"growth_upper", &SceneRecord::growth_upper},
      {"depth", &SceneRecord::depth},
      {"depth_lower", &SceneRecord::depth_lower},
      {"depth_upper", &SceneRecord::depth_upper}};
  json columns;
  for (const char* name : {"query", "a", "b", "touches", "pa", "pb"}) columns[name] = json::array();
  for (const auto& [name, member] : kNumbers) columns[name] = json::array();
  for (const SceneRow& row : file.records) {
    const SceneRecord& record = row.record;
    if (!record.at_instant()) continue;
    columns["query"].push_back(record.query);
    columns["a"].push_back(record.body_a);
    columns["b"].push_back(record.body_b);
    columns["touches"].push_back(record.status == SceneStatus::intersecting ? 1 : 0);
    columns["pa"].push_back(record.point_a.size() > 0 ? point(record.point_a) : json(nullptr));
    columns["pb"].push_back(record.point_b.size() > 0 ? point(record.point_b) : json(nullptr));
    for (const auto& [name, member] : kNumbers) columns[name].push_back(number(record.*member));
  }
  return columns;
}

json events_json(const SceneFile& file) {
  json events = json::array();
  for (const SceneEvent& event : events_of(file)) {
    events.push_back({{"kind", std::string(to_string(event.kind))},
                      {"query", event.query},
                      {"a", event.a},
                      {"b", event.b},
                      {"time", number(event.time)},
                      {"text", pair_name(file, event.a, event.b) + ": " + event.text}});
  }
  return events;
}

/// The widest certified relative gap (upper - lower) / upper of a query's answers; NaN where none has a
/// bound.
double widest_gap(const SceneFile& file, std::size_t query) {
  double widest = SceneRecord::kNone;
  for (const SceneRow& row : file.records) {
    const SceneRecord& record = row.record;
    if (static_cast<std::size_t>(record.query) != query || !(record.upper > 0)) continue;
    const double gap = (record.upper - record.lower) / record.upper;
    if (std::isfinite(gap) && !(gap <= widest)) widest = gap;
  }
  return widest;
}

std::int64_t instants_of(const SceneFile& file, std::size_t query) {
  std::int64_t last = -1;
  for (const SceneRow& row : file.records) {
    if (static_cast<std::size_t>(row.record.query) == query) last = std::max(last, row.record.instant);
  }
  return last + 1;
}

json queries_of(const SceneFile& file) {
  const std::vector<SceneTally> tallies = tallies_of(file);
  std::vector<double> seconds(file.queries.size());
  for (const SceneRow& row : file.records)
    seconds[static_cast<std::size_t>(row.record.query)] += row.record.seconds;
  const std::vector<std::string> names = distinct_query_names(file);
  json queries = json::array();
  for (std::size_t q = 0; q < file.queries.size(); ++q) {
    const auto instants = static_cast<double>(instants_of(file, q));
    queries.push_back({{"name", names[q]},
                       {"effects", file.queries[q].effects},
                       {"asked", tallies[q].asked},
                       {"solved", tallies[q].solved},
                       {"shared", tallies[q].shared},
                       {"broad_phase", tallies[q].broad_phase},
                       {"coherence", tallies[q].coherence},
                       {"standing", tallies[q].standing},
                       {"unit", length_unit(file, static_cast<std::int32_t>(q))},
                       {"tolerance", number(file.queries[q].tolerance)},
                       {"gap", number(widest_gap(file, q))},
                       {"frame_seconds", number(instants > 0 ? seconds[q] / instants : SceneRecord::kNone)},
                       {"seconds", number(seconds[q])}});
  }
  return queries;
}

json simulations_of(const SceneFile& file) {
  json list = json::array();
  if (!file.simulation) return list;
  for (const SimulationRow& row : file.simulation->simulations) {
    list.push_back({{"engine", row.engine},
                    {"step", number(row.step)},
                    {"tolerance", number(row.tolerance)},
                    {"seconds", number(row.seconds)},
                    {"steps", row.steps},
                    {"cuts", row.cuts},
                    {"unproven", row.unproven},
                    {"residual", number(row.residual)},
                    {"overlap", number(-row.least_distance)},
                    {"energy_change", number(row.energy_change)},
                    {"energy_rise", number(row.energy_rise)},
                    {"error", number(row.error)}});
  }
  return list;
}

// Its licence asks for this in every copy, and Debian's minified file has lost it.
constexpr const char* kThreeNotice =
    R"(/* three.js, https://threejs.org
Copyright © 2010-2019 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated
documentation files (the "Software"), to deal in the Software without restriction, including without limitation the
rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to permit
persons to whom the Software is furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all copies or substantial portions of the
Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE
WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR
COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR
OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE. */
)";

}  // namespace

std::string make_page(const SceneFile& file) {
  json data;
  data["name"] = file.name;
  const Verdict verdict = verdict_of(file);
  data["verdict"] = {{"state", verdict.state}, {"text", verdict.text}};
  data["grasp"] = is_grasp(file);
  data["count"] = file.records.size();
  data["finished"] = file.finished();
  data["drawing"] = file.drawing.empty() ? json(nullptr) : json::parse(file.drawing);
  data["bodies"] = json::array();
  for (const SceneBodyRow& body : file.bodies) data["bodies"].push_back(body.name);
  data["queries"] = queries_of(file);
  data["simulations"] = simulations_of(file);
  data["events"] = events_json(file);
  data["records"] = records_json(file);
  const bool space = data["drawing"].is_object() && data["drawing"]["dimension"] == 3;
  return filled(page_template(), {{"{{style}}", page_style()},
                                  {"{{three}}", space ? kThreeNotice + three_library() : ""},
                                  {"{{data}}", script_json(data)},
                                  {"{{script}}", page_script()}});
}

}  // namespace raygauge::scene_page
