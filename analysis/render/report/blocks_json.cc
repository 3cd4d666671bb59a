// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/report/blocks_json.h"

#include <cmath>

#include "engine/numerics/number_text.h"

namespace raygauge::report {
namespace {

constexpr int kDigits = 6;

/// 6 digits are more than any picture shows, and keep the page small.
Json short_number(double value) {
  if (!std::isfinite(value)) return nullptr;
  return std::stod(rounded_text(value, kDigits));
}

const char* emphasis_word(Emphasis emphasis) {
  switch (emphasis) {
    case Emphasis::strong:
      return "strong";
    case Emphasis::muted:
      return "muted";
    case Emphasis::alarm:
      return "alarm";
    case Emphasis::none:
      break;
  }
  return "";
}

Json facets_json(const Facets& facets) {
  Json object = Json::object();
  for (const auto& [name, value] : facets) object[name] = value;
  return object;
}

Json point_json(const ChartPoint& point) {
  Json list = {short_number(point.x), short_number(point.y)};
  const bool interval = std::isfinite(point.low) && std::isfinite(point.high);
  if (!interval && point.remark.empty() && !point.flawed) return list;
  list.push_back(interval ? short_number(point.low) : Json(nullptr));
  list.push_back(interval ? short_number(point.high) : Json(nullptr));
  if (!point.remark.empty() || point.flawed) list.push_back(point.remark);
  if (point.flawed) list.push_back(1);
  return list;
}

Json block_json(const Text& text) {
  return {{"type", "text"}, {"lead", text.lead}, {"paragraphs", text.paragraphs}};
}

Json block_json(const Verbatim& verbatim) {
  return {{"type", "verbatim"}, {"title", verbatim.title}, {"text", verbatim.text}};
}

Json block_json(const Table& table) {
  Json rows = Json::array();
  for (const TableRow& row : table.rows) {
    Json cells = Json::array();
    for (const TableCell& cell : row.cells) {
      if (cell.emphasis == Emphasis::none) {
        cells.push_back(cell.text);
      } else {
        cells.push_back(Json::array({cell.text, emphasis_word(cell.emphasis)}));
      }
    }
    rows.push_back({{"cells", cells}, {"group", row.starts_group}});
  }
  return {{"type", "table"},           {"title", table.title}, {"header", table.header},
          {"keys", table.key_columns}, {"rows", rows},         {"notes", table.notes}};
}

Json block_json(const Chart& chart) {
  Json series = Json::array();
  for (const Series& each : chart.series) {
    Json points = Json::array();
    for (const ChartPoint& point : each.points) points.push_back(point_json(point));
    series.push_back({{"method", each.method},
                      {"name", each.name.empty() ? each.method : each.name},
                      {"facets", facets_json(each.facets)},
                      {"points", points}});
  }
  const auto axis = [](const Axis& a) {
    return Json{{"label", a.label}, {"log", a.logarithmic}, {"unit", a.unit}};
  };
  return {{"type", "chart"},    {"caption", chart.caption}, {"x", axis(chart.x)},
          {"y", axis(chart.y)}, {"stepped", chart.stepped}, {"series", series}};
}

Json block_json(const HeatMap& map) {
  Json cells = Json::array();
  for (const HeatCell& cell : map.cells) {
    cells.push_back({{"facets", facets_json(cell.facets)},
                     {"row", short_number(cell.row)},
                     {"column", short_number(cell.column)},
                     {"value", short_number(cell.value)},
                     {"group", cell.group},
                     {"text", cell.text},
                     {"remark", cell.remark}});
  }
  return {{"type", "heatmap"},          {"caption", map.caption},   {"row", map.row_label},
          {"column", map.column_label}, {"value", map.value_label}, {"rows", map.rows},
          {"columns", map.columns},     {"log", map.logarithmic},   {"cells", cells}};
}

Json block_json(const RecordsDownload& records) {
  return {{"type", "records"},
          {"count", records.count},
          {"name", records.name},
          {"time_digits", records.time_digits},
          {"gzip", records.gzip}};
}

}  // namespace

Json to_json(const Block& block) {
  return std::visit([](const auto& each) { return block_json(each); }, block);
}

}  // namespace raygauge::report
