// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/repetitions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "engine/sweep/agreement.h"
#include "engine/sweep/order_statistics.h"

namespace raygauge {
namespace {

bool median_known(std::vector<double> seconds, double within) {
  const std::optional<OrderStatisticInterval> interval = order_statistic_interval(seconds);
  if (!interval) return false;
  if (interval->lower == interval->upper) return true;  // also where both are +∞
  if (std::isinf(interval->upper)) return false;        // ∞ <= within * ∞ says nothing
  return interval->upper - interval->lower <= within * sample_median(std::move(seconds));
}

}  // namespace

int next_look(const Experiment& experiment, int done) {
  if (experiment.stop_when_within == 0) return experiment.repetitions;
  const std::int64_t sum = done == 0 ? experiment.min_repetitions : done + (std::int64_t{done} + 3) / 4;
  return static_cast<int>(std::min<std::int64_t>(sum, experiment.repetitions));
}

bool medians_known(std::span<const Record> records, std::size_t methods, double within) {
  for (std::size_t method = 0; method < methods; ++method) {
    std::vector<double> seconds;
    for (std::size_t i = method; i < records.size(); i += methods) {
      if (records[i].agrees) seconds.push_back(time_or_infinity(records[i]));
    }
    if (!median_known(std::move(seconds), within)) return false;
  }
  return true;
}

}  // namespace raygauge
