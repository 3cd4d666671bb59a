// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <map>
#include <set>

#include "analysis/data/cell_ratio.h"
#include "analysis/render/report/blocks.h"
#include "analysis/statistics/statistics.h"
#include "analysis/studies/sections.h"
#include "results/text/number_words.h"

namespace raygauge::report {
namespace {

using RecordsByHost = std::map<std::string, std::vector<Record>>;

RecordsByHost by_host(const std::vector<Record>& records) {
  RecordsByHost groups;
  for (const Record& record : records) groups[record.host].push_back(record);
  return groups;
}

/// The processor of a host in any session.
std::string processor_of(const Input& input, const std::string& host) {
  for (const auto& [processor, hosts] : hosts_by_processor(input.merged.files)) {
    if (hosts.count(host) != 0) return processor;
  }
  return "unknown";
}

Table work_table(const Input& input, const RecordsByHost& groups) {
  Table table;
  table.title = "what each machine did";
  table.header = {{"host", "processor", "ranks", "records", "time in solves"}};
  for (const auto& [host, records] : groups) {
    std::set<std::pair<int, int>> ranks;
    double seconds = 0;
    for (const Record& record : records) {
      ranks.emplace(record.session, record.rank);
      seconds += record.seconds * record.inner_repetitions;
    }
    table.rows.push_back({{{host},
                           {processor_of(input, host)},
                           {std::to_string(ranks.size())},
                           {std::to_string(records.size())},
                           {time_words(seconds)}}});
  }
  return table;
}

/// The geometric mean over cells of a method's ratios; "" where it has none.
std::string mean_ratio(const std::vector<CellRatio>& ratios, const std::string& method) {
  std::vector<double> values;
  for (const CellRatio& ratio : ratios) {
    const double value = ratio.ratio.ratio;
    if (ratio.times.method == method && std::isfinite(value) && value > 0) values.push_back(value);
  }
  if (values.empty()) return "";
  return padded_significant(geometric_mean(values), 3) + " (" + std::to_string(values.size()) + ")";
}

/// Methods meet on one core of one machine, so that ratios of times compare where times do not.
Table ratio_table(const Input& input, const RecordsByHost& groups) {
  const RecordsByHost baselines =
      by_host(baseline_records(input.merged.records, input.filter, input.baselines));
  Table table;
  table.title = "time over that of the best baseline on the same machine: geometric mean (cells)";
  table.header = {{"host"}};
  for (const std::string& method : input.methods) table.header[0].push_back(method);
  for (const auto& [host, records] : groups) {
    const auto divisors = baselines.find(host);
    if (divisors == baselines.end()) continue;
    const std::vector<CellRatio> ratios = cell_ratios(records, divisors->second, input.baselines);
    TableRow row{{{host}}};
    for (const std::string& method : input.methods) row.cells.emplace_back(mean_ratio(ratios, method));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

std::optional<Section> machines_section(const Input& input) {
  std::set<std::string> hosts;
  for (const Record& record : input.records)
    if (hosts.empty() || *hosts.rbegin() != record.host) hosts.insert(record.host);
  if (hosts.size() < 2) return std::nullopt;
  const RecordsByHost groups = by_host(input.records);
  Section section{"machines", "Machines", {}};
  section.blocks.emplace_back(
      Text{{"The times come from " + std::to_string(groups.size()) +
            " machines. A filter such as host==" + groups.begin()->first + " takes those of one."}});
  section.blocks.emplace_back(work_table(input, groups));
  if (!input.baselines.empty()) section.blocks.emplace_back(ratio_table(input, groups));
  return section;
}

}  // namespace raygauge::report
