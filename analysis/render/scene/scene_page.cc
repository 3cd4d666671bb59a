// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/scene/scene_page.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>
#include <vector>

#include "analysis/render/page_template.h"
#include "results/scene/event_text.h"

namespace raygauge::scene_page {
namespace {

using nlohmann::json;

json number(double x) { return std::isfinite(x) ? json(x) : json(nullptr); }

json point(const SmallVector& v) {
  json list = json::array();
  for (Eigen::Index k = 0; k < v.size(); ++k) list.push_back(v[k]);
  return list;
}

json record_json(const SceneRecord& record) {
  json entry = {{"query", record.query},
                {"a", record.body_a},
                {"b", record.body_b},
                {"kind", std::string(to_string(record.kind))},
                {"time", number(record.time)},
                {"status", std::string(to_string(record.status))},
                {"distance", number(record.distance)},
                {"lower", number(record.lower)},
                {"upper", number(record.upper)},
                {"growth", number(record.growth)},
                {"growth_lower", number(record.growth_lower)},
                {"growth_upper", number(record.growth_upper)}};
  if (record.point_a.size() > 0) {
    entry["pa"] = point(record.point_a);
    entry["pb"] = point(record.point_b);
  }
  return entry;
}

std::string short_text(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.5g", x);
  return text;
}

std::string pair_text(const SceneFile& file, const SceneRecord& record) {
  return file.queries[static_cast<std::size_t>(record.query)].name + ": " +
         file.bodies[static_cast<std::size_t>(record.body_a)].name + " – " +
         file.bodies[static_cast<std::size_t>(record.body_b)].name + ": ";
}

json event(const SceneRecord& record, const std::string& text) {
  return {{"time", number(record.time)}, {"text", text}};
}

json events_of(const SceneFile& file) {
  json events = json::array();
  std::map<std::tuple<int, int, int>, SceneStatus> before;
  for (const SceneRow& row : file.records) {
    const SceneRecord& record = row.record;
    if (record.kind != SceneRowKind::instant) {
      events.push_back(event(record, pair_text(file, record) + event_text(record)));
      continue;
    }
    const auto key = std::make_tuple(record.query, record.body_a, record.body_b);
    const auto known = before.find(key);
    const bool changed = known != before.end() && known->second != record.status;
    if (changed && record.status != SceneStatus::undecided) {
      const bool touches = record.status == SceneStatus::intersecting;
      events.push_back(event(record, pair_text(file, record) + (touches ? "contact" : "release") + " by " +
                                         short_text(record.time) + " s"));
    }
    before[key] = record.status;
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
  std::vector<SceneTally> tallies(file.queries.size());
  std::vector<double> seconds(file.queries.size());
  for (const SceneTallyRow& row : file.tallies) tallies[static_cast<std::size_t>(row.query)] += row.tally;
  for (const SceneRow& row : file.records)
    seconds[static_cast<std::size_t>(row.record.query)] += row.record.seconds;
  json queries = json::array();
  for (std::size_t q = 0; q < file.queries.size(); ++q) {
    const auto instants = static_cast<double>(instants_of(file, q));
    queries.push_back({{"name", file.queries[q].name},
                       {"effects", file.queries[q].effects},
                       {"asked", tallies[q].asked},
                       {"solved", tallies[q].solved},
                       {"shared", tallies[q].shared},
                       {"broad_phase", tallies[q].broad_phase},
                       {"coherence", tallies[q].coherence},
                       {"standing", tallies[q].standing},
                       {"tolerance", file.queries[q].tolerance},
                       {"gap", number(widest_gap(file, q))},
                       {"frame_seconds", number(instants > 0 ? seconds[q] / instants : SceneRecord::kNone)},
                       {"seconds", seconds[q]}});
  }
  return queries;
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
  data["finished"] = file.finished();
  data["drawing"] = file.drawing.empty() ? json(nullptr) : json::parse(file.drawing);
  data["bodies"] = json::array();
  for (const SceneBodyRow& body : file.bodies) data["bodies"].push_back(body.name);
  data["queries"] = queries_of(file);
  data["events"] = events_of(file);
  data["records"] = json::array();
  for (const SceneRow& row : file.records) data["records"].push_back(record_json(row.record));
  const bool space = data["drawing"].is_object() && data["drawing"]["dimension"] == 3;
  return filled(page_template(), {{"{{style}}", page_style()},
                                  {"{{three}}", space ? kThreeNotice + three_library() : ""},
                                  {"{{data}}", script_json(data)},
                                  {"{{script}}", page_script()}});
}

}  // namespace raygauge::scene_page
