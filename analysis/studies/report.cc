// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/report.h"

#include <algorithm>
#include <array>
#include <future>
#include <set>
#include <utility>

#include "analysis/data/cell_ratio.h"
#include "analysis/render/method_look.h"
#include "analysis/render/page_template.h"
#include "analysis/render/report/blocks_json.h"
#include "analysis/render/report/deflate.h"
#include "analysis/render/report/page_assets.h"
#include "raygauge/exceptions.h"
#include "results/provenance/provenance.h"
#include "results/text/language.h"
#include "results/text/words.h"

namespace raygauge::report {
namespace {

/// The methods with their looks, in Chart.js's words.
Json methods_json(const MethodList& list) {
  constexpr std::array<const char*, 5> kMarkers = {"circle", "rect", "triangle", "rectRot", "triangle down"};
  static const std::array<std::vector<int>, 4> kDashes = {{{}, {7, 4}, {2, 3}, {7, 3, 2, 3}}};
  Json methods = Json::array();
  for (const std::string& method : list) {
    const MethodLook look = look_of_method(method, list);
    methods.push_back({{"name", method},
                       {"what", what_method_is(list.find(method)->name)},
                       {"color", look.color},
                       {"dark", look.dark_color},
                       {"marker", kMarkers.at(static_cast<std::size_t>(look.marker))},
                       {"dash", kDashes.at(static_cast<std::size_t>(look.dash))},
                       {"filled", look.filled}});
  }
  return methods;
}

/// The experiment's description: the string after "description = " in its text.
std::string description_of(const std::string& experiment) {
  const std::string key = "description = ";
  const std::size_t line = experiment.find("\n" + key);
  if (line == std::string::npos) return "";
  const std::size_t begin = line + 1 + key.size();
  const std::size_t end = experiment.find(experiment[begin], begin + 1);
  return end == std::string::npos ? "" : experiment.substr(begin + 1, end - begin - 1);
}

/// What stands below the title: dates and descriptions of the runs.
std::string subtitle(const std::vector<MergedFile>& files) {
  constexpr std::size_t kDate = 10;  // of ISO 8601
  std::set<std::string> dates;
  std::set<std::string> descriptions;
  for (const MergedFile& file : files) {
    descriptions.insert(description_of("\n" + file.provenance.experiment_text));
    for (const Session& session : file.provenance.sessions) dates.insert(session.started_at.substr(0, kDate));
  }
  dates.erase("");
  descriptions.erase("");
  std::string text = joined(descriptions, "; ");
  if (dates.empty()) return text;
  const std::string when = *dates.begin() + (dates.size() > 1 ? " to " + *dates.rbegin() : "");
  return text + (text.empty() ? "Run on " : ". Run on ") + when;
}

std::string page_title(const std::vector<MergedFile>& files) {
  std::string title = "raygauge";
  for (const MergedFile& file : files) {
    const std::size_t slash = file.path.find_last_of('/');
    title += (&file == &files.front() ? ": " : ", ") +
             (slash == std::string::npos ? file.path : file.path.substr(slash + 1));
  }
  return title;
}

/// A section as JSON; null where there is none.
Json section_json(const SectionMaker& make, const Input& input) {
  const std::optional<Section> section = make(input);
  if (!section) return nullptr;
  Json blocks = Json::array();
  for (const Block& block : section->blocks) blocks.push_back(to_json(block));
  return {{"id", section->id}, {"title", section->title}, {"blocks", blocks}};
}

/// All sections in their order. They are made at the same time: of many records each takes a while.
Json sections_json(const Input& input) {
  std::vector<std::future<Json>> made;
  for (const SectionMaker& make : section_makers())
    made.push_back(std::async(std::launch::async, [&make, &input] { return section_json(make, input); }));
  Json sections = Json::array();
  for (std::future<Json>& each : made) {
    Json section = each.get();
    if (!section.is_null()) sections.push_back(std::move(section));
  }
  return sections;
}

/// The data of the page; where they are large, packed in base64.
std::string data_script(const Json& data) {
  constexpr std::size_t kMostPlain = 300'000;
  const std::string plain = script_json(data);
  if (plain.size() <= kMostPlain)
    return R"(<script type="application/json" id="data">)" + plain + "</script>";
  return R"(<script type="application/gzip" id="data">)" + base64(gzip(plain)) + "</script>";
}

}  // namespace

Input::Input(const MergedResults& all, const Filter& which, std::vector<std::string> named)
    : merged(all),
      filter(which),
      pool(all.records),
      kept(all_as_they_are() ? std::vector<Record>() : pool(filtered(all.records, which))),
      records(all_as_they_are() ? all.records : kept),
      groups(records),
      methods(groups.methods()),
      truth(pool.truth_of(all.records)),
      baselines(std::move(named)) {
  if (records.empty()) {
    throw EmptySetError(all.records.empty() ? "the files hold no record yet"
                                            : "no record passes the filter '" + filter.expression() + "'");
  }
  const MethodList all_methods = all_as_they_are() ? methods : methods_of(all.records);
  if (baselines.empty()) baselines = default_baselines(all_methods);
  if (!baselines.empty()) require_baselines(all_methods, baselines);
  auto by_instance = std::async(std::launch::async, [this] { return instances_by_cell(groups); });
  cells = cell_times(groups);
  if (!baselines.empty()) ratios = ratios_of_cells();
  stability = make_stability(groups, truth);
  instances = by_instance.get();
}

std::vector<CellRatio> Input::ratios_of_cells() const {
  const bool baseline_passes = std::ranges::any_of(methods, [&](const std::string& method) {
    return std::ranges::find(baselines, method) != baselines.end();
  });
  if (baseline_passes) return cell_ratios(cells, cells, baselines);
  return cell_ratios(cells, cell_times(pool(baseline_records(merged.records, filter, baselines))), baselines);
}

std::string make_page(const MergedResults& merged, const Filter& filter,
                      const std::vector<std::string>& baselines) {
  const Input input(merged, filter, baselines);
  const Json data = {{"title", page_title(merged.files)},
                     {"subtitle", subtitle(merged.files)},
                     {"version", build_info().raygauge_version},
                     {"methods", methods_json(input.methods)},
                     {"sections", sections_json(input)}};
  return filled(page_template(), {{"<!--TITLE-->", language::markup(page_title(merged.files))},
                                  {"/*STYLE*/", page_style()},
                                  {"<!--DATA-->", data_script(data)},
                                  {"/*CHARTJS*/", chart_library()},
                                  {"/*SCRIPT*/", page_script()}});
}

}  // namespace raygauge::report
