// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "analysis/data/columns.h"
#include "analysis/data/outliers.h"
#include "analysis/render/method_look.h"
#include "analysis/render/report/blocks.h"
#include "analysis/studies/overview/fastest_picture.h"
#include "analysis/studies/sections.h"
#include "analysis/studies/stability/stability.h"
#include "engine/numerics/number_text.h"
#include "results/text/number_words.h"
#include "results/text/words.h"

namespace raygauge::report {
namespace {

/// "3 … 10 (8 values)".
template <class Number>
std::string range_words(const std::set<Number>& values) {
  std::string first = rounded_text(static_cast<double>(*values.begin()), 3);
  if (values.size() == 1) return first;
  return first + " … " + rounded_text(static_cast<double>(*values.rbegin()), 6) + " (" +
         std::to_string(values.size()) + " values)";
}

std::string run_line(const Input& input) {
  std::set<int> n;
  std::set<int> N;
  std::set<double> tolerances;
  std::set<std::string> generators;
  std::set<CellKey> cells;
  for (const RecordGroup& group : input.groups) {
    n.insert(group.cell.n);
    N.insert(group.cell.N);
    tolerances.insert(group.cell.tolerance);
    generators.insert(group.cell.generator);
    cells.insert(group.cell);
  }
  return counted(input.records.size(), "record") + " in " + counted(cells.size(), "cell") + " of " +
         joined(generators) + ": n = " + range_words(n) + ", N = " + range_words(N) +
         ", ε = " + range_words(tolerances) + ".";
}

std::string machine_line(const Input& input) {
  std::set<std::string> builds;
  for (const MergedFile& file : input.merged.files) {
    for (const Session& session : file.provenance.sessions) {
      builds.insert("raygauge " + session.build.raygauge_version + ", commit " +
                    session.build.git_commit.substr(0, 12) + (session.build.git_dirty ? " modified" : ""));
    }
  }
  std::string text;
  for (const auto& [processor, hosts] : hosts_by_processor(input.merged.files)) {
    text += (text.empty() ? "On " : " and ") + processor + " (" + host_words(hosts) + ")";
  }
  for (const std::string& build : builds) text += "; " + build;
  return text.empty() ? "Nothing is known of machine and build." : text + ".";
}

/// "640 of nlopt_slsqp, 13 of exact": whose they are.
std::string by_method(const Input& input, const std::map<std::string, std::size_t>& counts) {
  std::vector<std::string> words;
  for (const std::string& method : input.methods) {
    const auto found = counts.find(method);
    if (found != counts.end()) words.push_back(std::to_string(found->second) + " of " + method);
  }
  return joined(words, ", ");
}

/// Second line of the verdict: are the answers to be believed?
std::string answers_line(const Input& input) {
  std::map<std::string, std::size_t> unsolved;
  std::map<std::string, std::size_t> disagreeing;
  for (const Record& record : input.records) {
    if (!is_solved(record)) ++unsolved[record.method];
    if (!record.agrees) ++disagreeing[record.method];
  }
  std::string agreement;
  if (!disagreeing.empty()) {
    agreement =
        "disagree with other methods\' proofs or the known distance: " + by_method(input, disagreeing) + "; ";
  } else if (input.methods.size() > 1) {
    agreement = "all methods agree on every instance; ";
  }
  return "Answers: " + agreement +
         (unsolved.empty() ? std::string("everything was solved")
                           : "stopped at a limit: " + by_method(input, unsolved)) +
         ".";
}

/// "160 times faster", "1.4 times slower", "as fast": a ratio of times as one says it.
std::string times_words(double ratio) {
  const double times = std::stod(rounded_text(ratio < 1 ? 1 / ratio : ratio, 2));
  if (times == 1) return "as fast";
  constexpr int kNoExponent = 12;
  return rounded_text(times, kNoExponent) + (ratio < 1 ? " times faster" : " times slower");
}

/// The same with what it is compared to: "as fast as the best baseline".
std::string compared_words(double ratio, const std::string& other) {
  const std::string words = times_words(ratio);
  return words + (words == "as fast" ? " as " : " than ") + other;
}

/// How fast one method is against the baselines; "" where no cell tells.
std::string speed_words(const Input& input, const std::string& method) {
  std::vector<double> finite;
  std::size_t faster = 0;
  std::size_t unsolved = 0;
  for (const CellRatio& ratio : input.ratios) {
    if (ratio.times.method != method || std::isnan(ratio.ratio.ratio)) continue;
    faster += ratio.ratio.interval.upper < 1 ? 1 : 0;
    if (std::isfinite(ratio.ratio.ratio)) {
      finite.push_back(ratio.ratio.ratio);
    } else {
      ++unsolved;
    }
  }
  const std::string never = unsolved == 0 ? "" : ", unsolved in " + counted(unsolved, "cell");
  if (finite.empty()) return unsolved == 0 ? "" : method + " is" + never.substr(1);
  return method + " is " + compared_words(geometric_mean(finite), "the best baseline") +
         " (geometric mean of " + counted(finite.size(), "cell") + "; at worst " +
         times_words(quantile(finite, 1)) + "), significantly faster in " + std::to_string(faster) + never;
}

/// First line: how fast against the baselines.
std::string speed_line(const Input& input) {
  if (input.baselines.empty()) return "Speed: no baseline among the methods, so no ratio.";
  std::vector<std::string> words;
  for (const std::string& method : input.methods) {
    const std::string speed = input.methods.is_competitor(method) ? "" : speed_words(input, method);
    if (!speed.empty()) words.push_back(speed);
  }
  return words.empty() ? "Speed: no cell has both a method and a solved baseline."
                       : "Speed: " + joined(words, "; ") + ".";
}

/// Third line: how good the bounds are, over all tolerances.
std::string precision_line(const Input& input) {
  std::map<std::string, StabilityRow> sums;
  for (const StabilityTolerance& part : input.stability) {
    for (const StabilityRow& row : part.totals) {
      StabilityRow& sum = sums[row.method];
      sum.solves += row.solves;
      sum.certified += row.certified;
      sum.worst_width = std::max(sum.worst_width, row.worst_width);
    }
  }
  std::vector<std::string> words;
  for (const std::string& method : input.methods) {
    if (input.methods.is_competitor(method)) continue;
    const StabilityRow& sum = sums[method];
    words.push_back(method + " certified " + std::to_string(sum.certified) + " of " +
                    std::to_string(sum.solves) + " distances to the tolerance asked for (" +
                    (std::isinf(sum.worst_width)
                         ? "some without a bound"
                         : "widest relative gap " + rounded_text(sum.worst_width, 2)) +
                    ")");
  }
  return words.empty() ? "Precision: only competitors were run." : "Precision: " + joined(words, "; ") + ".";
}

Table methods_table(const Input& input) {
  Table table;
  table.title = "methods";
  table.header = {{"method", "what it is", "records", "unsolved", "disagreeing", "outlying times"}};
  for (const std::string& method : input.methods) {
    std::size_t records = 0;
    std::size_t unsolved = 0;
    std::size_t disagreeing = 0;
    std::size_t outliers = 0;
    for (const CellTimes& times : input.cells) {
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
                           {what_method_is(input.methods.find(method)->name)},
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
  if (const std::optional<HeatMap> picture = fastest_picture(input)) section.blocks.emplace_back(*picture);
  section.blocks.emplace_back(Text{{speed_line(input), answers_line(input), precision_line(input)}, true});
  section.blocks.emplace_back(Text{{run_line(input), machine_line(input)}});
  if (!input.filter.expression().empty())
    section.blocks.emplace_back(Text{{"Only records for which " + input.filter.expression() + "."}});
  if (!input.merged.notes.empty()) section.blocks.emplace_back(Text{input.merged.notes});
  section.blocks.emplace_back(methods_table(input));
  return section;
}

}  // namespace raygauge::report
