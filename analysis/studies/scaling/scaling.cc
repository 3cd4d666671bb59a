// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/scaling/scaling.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "analysis/constants.h"
#include "analysis/data/outliers.h"

namespace raygauge {

std::vector<ScalingCurve> scaling_curves(const std::vector<Record>& records, SizeAxis axis,
                                         std::size_t fewest) {
  return scaling_curves(cell_times(records), methods_of(records), axis, fewest);
}

std::vector<ScalingCurve> scaling_curves(const std::vector<CellTimes>& cells,
                                         const std::vector<std::string>& methods, SizeAxis axis,
                                         std::size_t fewest) {
  std::map<std::tuple<CellKey, std::size_t, std::string>, ScalingCurve> curves;
  for (const CellTimes& times : cells) {
    if (times.seconds.empty()) continue;
    const Center center = center_of(times);
    if (!std::isfinite(center.seconds) || center.seconds <= 0) continue;
    CellKey common = times.cell;
    (axis == SizeAxis::n ? common.n : common.N) = 0;
    const auto rank = std::find(methods.begin(), methods.end(), times.method) - methods.begin();
    ScalingCurve& curve = curves[{common, static_cast<std::size_t>(rank), times.method_parameters}];
    if (curve.sizes.empty()) {
      curve.cell = times.cell;
      curve.method = times.method;
      curve.method_parameters = times.method_parameters;
    }
    curve.sizes.push_back(axis == SizeAxis::n ? times.cell.n : times.cell.N);
    curve.medians.push_back(center.seconds);
    curve.intervals.push_back(center.interval);
    curve.outliers.push_back(outlier_count(times.seconds));
    curve.counts.push_back(times.seconds.size());
    curve.unsolved.push_back(times.unsolved);
    curve.disagreeing.push_back(times.disagreeing);
  }
  std::vector<ScalingCurve> result;
  for (auto& [key, curve] : curves) {
    if (curve.sizes.size() >= fewest) result.push_back(std::move(curve));
  }
  return result;
}

PowerLaw fit_scaling(const ScalingCurve& curve) { return fit_power_law(curve.sizes, curve.medians); }

std::string center_words(const std::vector<ScalingCurve>& curves) {
  std::vector<CellKey> cells;
  for (const ScalingCurve& curve : curves) cells.push_back(curve.cell);
  return center_words(cells);
}

TimeUnit unit_of(const std::vector<ScalingCurve>& curves) {
  double low = kInfinity;
  double high = 0;
  for (const ScalingCurve& curve : curves) {
    for (const double seconds : curve.medians) {
      low = std::min(low, seconds);
      high = std::max(high, seconds);
    }
  }
  return time_unit_for(low, high);
}

}  // namespace raygauge
