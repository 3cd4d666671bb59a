// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/output/run_summary.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <map>
#include <set>
#include <utility>

#include "cli/output/terminal.h"
#include "results/text/language.h"
#include "results/text/words.h"

namespace raygauge::cli {
namespace {

bool is_limit(DistanceStatus status) {
  return status == DistanceStatus::iteration_limit || status == DistanceStatus::time_limit ||
         status == DistanceStatus::precision_limit;
}

/// "newton 3, glpk_dual 1": the methods with a count other than 0; "" if there are none.
std::string counts_text(const RunSummary& summary, std::size_t RunSummary::Method::*count) {
  std::string text;
  for (const RunSummary::Method& method : summary.methods) {
    if (method.*count == 0) continue;
    text +=
        (text.empty() ? "" : ", ") + language::printable(method.label) + " " + std::to_string(method.*count);
  }
  return text;
}

RunSummary::Repetitions count_repetitions(const std::vector<Record>& records, int limit) {
  std::map<std::uint64_t, int> of_cell;
  for (const Record& record : records) {
    int& count = of_cell[record.cell];
    count = std::max(count, record.repetition + 1);
  }
  RunSummary::Repetitions result;
  for (const auto& [cell, count] : of_cell) {
    result.fewest = result.cells == 0 ? count : std::min(result.fewest, count);
    result.most = std::max(result.most, count);
    ++result.cells;
    if (count == limit) ++result.cells_at_limit;
  }
  return result;
}

std::string repeated_line(const RunSummary::Repetitions& repetitions) {
  std::string text = "  repeated   " + std::to_string(repetitions.fewest);
  if (repetitions.most > repetitions.fewest) text += " to " + std::to_string(repetitions.most);
  return text + " times a cell; " + std::to_string(repetitions.cells_at_limit) + " of " +
         counted(repetitions.cells, "cell") + " ran to the limit\n";
}

std::string slowdown_text(const Calibration& calibration) {
  std::string text;
  for (const Calibration::Entry& entry : calibration.entries) {
    if (entry.is_noise()) continue;
    constexpr int kLength = 32;
    char ratio[kLength];
    std::snprintf(ratio, kLength, " %.3f", entry.slowdown);
    text += (text.empty() ? "" : ", ") + language::printable(entry.method) + ratio;
  }
  return text.empty() ? "none that differs from noise" : text;
}

}  // namespace

RunSummary summarise(const Experiment& experiment, const std::vector<Record>& records) {
  RunSummary summary;
  summary.records = records.size();
  for (const ComponentSpec& method : experiment.methods)
    summary.methods.push_back({label_of(method), 0, 0, 0});
  std::set<std::pair<std::uint64_t, int>> disagreeing;
  for (const Record& record : records) {
    const auto method = std::find_if(summary.methods.begin(), summary.methods.end(),
                                     [&](const auto& entry) { return entry.label == record.method; });
    if (method == summary.methods.end()) continue;
    ++method->records;
    if (is_limit(record.status)) ++method->limits;
    if (record.agrees) continue;
    ++method->disagreements;
    disagreeing.emplace(record.cell, record.repetition);
  }
  summary.disagreeing_instances = disagreeing.size();
  if (experiment.stop_when_within > 0) {
    summary.repetitions = count_repetitions(records, experiment.repetitions);
  }
  return summary;
}

std::string summary_text(const RunSummary& summary, const Calibration& calibration) {
  std::string text;
  if (summary.disagreeing_instances == 0) {
    text += "  agreement  all methods agree on every instance\n";
  } else {
    text += "  agreement  " +
            alarming(std::to_string(summary.disagreeing_instances) +
                         (summary.disagreeing_instances == 1 ? " instance" : " instances") +
                         " with DISAGREEMENTS",
                     stdout) +
            " (records: " + counts_text(summary, &RunSummary::Method::disagreements) + ")\n";
  }
  const std::string limits = counts_text(summary, &RunSummary::Method::limits);
  text += "  unsolved   " + (limits.empty() ? "none" : limits) + "\n";
  if (summary.repetitions) text += repeated_line(*summary.repetitions);
  if (!calibration.entries.empty()) {
    text += "  slowdown   of single solves on " + std::to_string(calibration.threads) +
            " threads: " + slowdown_text(calibration) + "\n";
  }
  return text;
}

}  // namespace raygauge::cli
