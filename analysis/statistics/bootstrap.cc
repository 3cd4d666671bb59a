// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/bootstrap.h"

#include <random>

#include "raygauge/exceptions.h"

namespace raygauge {

Interval bootstrap_interval(const std::vector<double>& values,
                            const std::function<double(const std::vector<double>&)>& statistic,
                            const BootstrapOptions& options) {
  if (values.empty()) throw EmptySetError("bootstrap of no values");
  if (!(options.confidence > 0 && options.confidence < 1))
    throw InvalidParameterError("confidence of a bootstrap must lie in (0, 1)");
  if (options.resamples < 1) throw InvalidParameterError("a bootstrap needs at least one resample");

  std::mt19937_64 bits(options.seed);
  std::vector<double> resample(values.size());
  std::vector<double> statistics;
  statistics.reserve(static_cast<std::size_t>(options.resamples));
  for (int i = 0; i < options.resamples; ++i) {
    // Not std::uniform_int_distribution, whose numbers differ between standard libraries. The bias of the
    // remainder is below values.size() / 2^64.
    for (double& x : resample) x = values[bits() % values.size()];
    statistics.push_back(statistic(resample));
  }
  const double tail = (1 - options.confidence) / 2;
  return {quantile(statistics, tail), quantile(statistics, 1 - tail), options.confidence};
}

}  // namespace raygauge
