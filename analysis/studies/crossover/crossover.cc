// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/crossover/crossover.h"

#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "analysis/constants.h"
#include "analysis/data/pool.h"
#include "analysis/statistics/paired_ratio.h"

namespace raygauge {
namespace {

/// How many times as long `other` takes: on the same instances, or where there are none of them, of medians.
Ratio lead_over(const CellKey& cell, const MethodInstances& winner, const MethodInstances& other) {
  std::vector<double> ours;
  std::vector<double> theirs;
  for (const auto& [our_record, their_record] : shared_instances(winner, other)) {
    ours.push_back(answer_seconds(*our_record));
    theirs.push_back(answer_seconds(*their_record));
  }
  if (ours.empty()) return ratio_of_medians(other.seconds(), winner.seconds());
  return is_pool(cell) ? geometric_mean_ratio(log_ratios(theirs, ours)).ratio : paired_ratio(theirs, ours);
}

/// Methods by the center_of() their times.
std::multimap<double, const MethodInstances*> ranking(const CellKey& cell,
                                                      const std::vector<MethodInstances>& methods) {
  std::multimap<double, const MethodInstances*> ranks;
  for (const MethodInstances& each : methods) ranks.emplace(center_of(cell, each.seconds()).seconds, &each);
  return ranks;
}

}  // namespace

std::vector<CellWinner> cell_winners(const std::vector<Record>& records) {
  return cell_winners(instances_by_cell(records));
}

std::vector<CellWinner> cell_winners(const std::map<CellKey, std::vector<MethodInstances>>& cells) {
  std::vector<CellWinner> winners;
  for (const auto& [cell, methods] : cells) {
    const auto ranks = ranking(cell, methods);
    const auto& [seconds, first] = *ranks.begin();
    if (std::isinf(seconds)) continue;
    CellWinner winner{cell, first->method, "", seconds, {kNaN, {kNaN, kNaN, 0}}};
    if (const auto second = std::next(ranks.begin()); second != ranks.end() && std::isfinite(second->first)) {
      winner.runner_up = second->second->method;
      winner.lead = lead_over(cell, *first, *second->second);
      if (winner.lead.ratio < 1) {  // by medians alone the other way round
        winner = {cell, second->second->method, first->method, second->first,
                  lead_over(cell, *second->second, *first)};
      }
      winner.decided = winner.lead.interval.lower > 1;
    }
    winners.push_back(std::move(winner));
  }
  return winners;
}

}  // namespace raygauge
