// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/columns.h"
#include "analysis/number_text.h"
#include "analysis/outliers.h"
#include "analysis/report/blocks.h"
#include "analysis/report/sections/sections.h"

namespace raygauge::report {
namespace {

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

/// "3 … 10 (8 values)".
template <class Number>
std::string range_words(const std::set<Number>& values) {
  const std::string first = significant(static_cast<double>(*values.begin()), 3);
  if (values.size() == 1) return first;
  return first + " … " + significant(static_cast<double>(*values.rbegin()), 6) + " (" +
         std::to_string(values.size()) + " values)";
}

std::string run_line(const Input& input) {
  std::set<int> n;
  std::set<int> N;
  std::set<double> tolerances;
  std::set<std::string> generators;
  std::set<CellKey> cells;
  for (const Record& record : input.records) {
    n.insert(record.n);
    N.insert(record.N);
    tolerances.insert(record.tolerance);
    generators.insert(record.generator);
    cells.insert(cell_key(record));
  }
  std::string names;
  for (const std::string& generator : generators) names += (names.empty() ? "" : ", ") + generator;
  return counted(input.records.size(), "record") + " in " + counted(cells.size(), "cell") + " of " + names +
         ": n = " + range_words(n) + ", N = " + range_words(N) + ", ε = " + range_words(tolerances) + ".";
}

std::string machine_line(const Input& input) {
  std::set<std::string> machines;
  std::set<std::string> builds;
  for (const MergedFile& file : input.files) {
    for (const Session& session : file.provenance.sessions) {
      machines.insert(session.machine.cpu_model + " (" + session.machine.hostname + ")");
      builds.insert("raygauge " + session.build.raygauge_version + ", commit " +
                    session.build.git_commit.substr(0, 12) + (session.build.git_dirty ? " modified" : ""));
    }
  }
  std::string text;
  for (const std::string& machine : machines) text += (text.empty() ? "On " : " and ") + machine;
  for (const std::string& build : builds) text += "; " + build;
  return text.empty() ? "Nothing is known of machine and build." : text + ".";
}

/// First line of the verdict: are the answers to be believed?
std::string answers_line(const Input& input) {
  std::size_t unsolved = 0;
  std::size_t disagreeing = 0;
  for (const Record& record : input.records) {
    unsolved += is_solved(record) ? 0 : 1;
    disagreeing += record.agrees ? 0 : 1;
  }
  return "Answers: " +
         (disagreeing == 0 ? std::string("all methods agree on every instance")
                           : counted(disagreeing, "record") + " disagree with other methods") +
         "; " +
         (unsolved == 0 ? std::string("everything was solved")
                        : counted(unsolved, "solve") + " stopped at a limit") +
         ".";
}

/// Second line: how fast against the baselines.
std::string speed_line(const Input& input) {
  if (input.baselines.empty()) return "Speed: no baseline among the methods, so no ratio.";
  const std::vector<CellRatio> ratios = cell_ratios(
      input.records, baseline_records(input.all_records, input.filter, input.baselines), input.baselines);
  std::string text;
  for (const std::string& method : methods_of(input.records)) {
    std::vector<double> finite;
    std::size_t faster = 0;
    for (const CellRatio& ratio : ratios) {
      if (ratio.times.method != method || !std::isfinite(ratio.ratio.ratio)) continue;
      finite.push_back(ratio.ratio.ratio);
      faster += ratio.ratio.interval.upper < 1 ? 1 : 0;
    }
    if (finite.empty() || is_competitor(method)) continue;
    text += (text.empty() ? "" : "; ") + method + " takes " + padded_significant(geometric_mean(finite), 2) +
            " of the best baseline's time (geometric mean of " + counted(finite.size(), "cell") + ", worst " +
            padded_significant(quantile(finite, 1), 2) + "), significantly faster in " +
            std::to_string(faster);
  }
  return text.empty() ? "Speed: no cell has both a method and a solved baseline." : "Speed: " + text + ".";
}

/// Third line: how good the bounds are.
std::string precision_line(const Input& input) {
  std::string text;
  for (const std::string& method : methods_of(input.records)) {
    if (is_competitor(method)) continue;
    std::size_t certified = 0;
    std::size_t count = 0;
    double widest = 0;
    for (const Record& record : input.records) {
      if (record.method != method) continue;
      ++count;
      const double gap = relative_gap(record);
      certified += gap <= record.tolerance ? 1 : 0;
      if (!std::isnan(gap)) widest = std::max(widest, gap);
    }
    text += (text.empty() ? "" : "; ") + method + " certified " + std::to_string(certified) + " of " +
            std::to_string(count) + " distances to the tolerance asked for (widest relative gap " +
            significant(widest, 2) + ")";
  }
  return text.empty() ? "Precision: only competitors were run." : "Precision: " + text + ".";
}

Table methods_table(const Input& input) {
  Table table;
  table.title = "methods";
  table.header = {{"method", "records", "unsolved", "disagreeing", "outlying times"}};
  const std::vector<CellTimes> all = cell_times(input.records);
  for (const std::string& method : methods_of(input.records)) {
    std::size_t records = 0;
    std::size_t unsolved = 0;
    std::size_t disagreeing = 0;
    std::size_t outliers = 0;
    for (const CellTimes& times : all) {
      if (times.method != method) continue;
      records += times.seconds.size() + times.disagreeing;
      unsolved += times.unsolved;
      disagreeing += times.disagreeing;
      if (!times.seconds.empty()) outliers += outlier_count(times.seconds);
    }
    const auto alarm = [](std::size_t count) {
      return TableCell(std::to_string(count), count > 0 ? Emphasis::alarm : Emphasis::none);
    };
    table.rows.push_back({{{method},
                           {std::to_string(records)},
                           alarm(unsolved),
                           alarm(disagreeing),
                           {std::to_string(outliers)}}});
  }
  table.notes = {
      "outlying: outside Tukey's fences, 1.5 interquartile ranges beyond the quartiles of its cell; flagged, "
      "never dropped"};
  return table;
}

}  // namespace

std::optional<Section> summary_section(const Input& input) {
  Section section{"summary", "Summary", {}};
  section.blocks.push_back(text_block({answers_line(input), speed_line(input), precision_line(input)}, true));
  section.blocks.push_back(text_block({run_line(input), machine_line(input)}));
  if (!input.filter.expression().empty())
    section.blocks.push_back(text_block({"Only records for which " + input.filter.expression() + "."}));
  if (!input.notes.empty()) section.blocks.push_back(text_block(input.notes));
  section.blocks.push_back(table_block(methods_table(input)));
  return section;
}

}  // namespace raygauge::report
