// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/crossover.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "analysis/columns.h"
#include "analysis/constants.h"
#include "analysis/paired_ratio.h"

namespace raygauge {
namespace {

using TimesByInstance = std::map<std::pair<std::uint64_t, int>, double>;

struct Contestant {
  std::string method;
  TimesByInstance times;
  double median_seconds = 0;
};

std::map<CellKey, std::vector<Contestant>> contestants_of(const std::vector<Record>& records) {
  std::map<CellKey, std::vector<Contestant>> cells;
  for (const Record& record : records) {
    if (!record.agrees) continue;
    std::vector<Contestant>& all = cells[cell_key(record)];
    auto place = std::find_if(all.begin(), all.end(),
                              [&](const Contestant& each) { return each.method == record.method; });
    if (place == all.end()) place = all.insert(all.end(), Contestant{record.method, {}, 0});
    place->times[{record.seed, record.repetition}] = time_or_infinity(record);
  }
  return cells;
}

double median_of(const Contestant& contestant) {
  std::vector<double> seconds;
  for (const auto& [instance, time] : contestant.times) seconds.push_back(time);
  return median(seconds);
}

Ratio lead_over(const Contestant& winner, const Contestant& other) {
  std::vector<double> ours;
  std::vector<double> theirs;
  for (const auto& [instance, time] : winner.times) {
    const auto found = other.times.find(instance);
    if (found == other.times.end()) continue;
    ours.push_back(time);
    theirs.push_back(found->second);
  }
  return paired_ratio(theirs, ours);
}

}  // namespace

std::vector<CellWinner> cell_winners(const std::vector<Record>& records) {
  std::vector<CellWinner> winners;
  for (auto& [cell, contestants] : contestants_of(records)) {
    for (Contestant& each : contestants) each.median_seconds = median_of(each);
    std::stable_sort(contestants.begin(), contestants.end(), [](const Contestant& a, const Contestant& b) {
      return a.median_seconds < b.median_seconds;
    });
    if (std::isinf(contestants.front().median_seconds)) continue;
    CellWinner winner;
    winner.cell = cell;
    winner.method = contestants.front().method;
    winner.seconds = contestants.front().median_seconds;
    winner.lead = {kNaN, {kNaN, kNaN, 0}};
    if (contestants.size() > 1 && std::isfinite(contestants[1].median_seconds)) {
      winner.runner_up = contestants[1].method;
      winner.lead = lead_over(contestants[0], contestants[1]);
      winner.decided = winner.lead.interval.lower > 1;
    }
    winners.push_back(std::move(winner));
  }
  return winners;
}

}  // namespace raygauge
