// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/accuracy/accuracy.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/constants.h"
#include "analysis/data/columns.h"
#include "analysis/statistics/statistics.h"
#include "analysis/studies/stability/stability.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

/// Mean and maximum of a quantity; NaN of none.
class RunningMean {
 public:
  void add(double value) {
    sum_ += value;
    ++count_;
    largest_ = std::max(largest_, value);
  }
  double count() const { return count_; }
  double mean() const { return sum_ / static_cast<double>(count_); }
  double largest() const { return count_ > 0 ? largest_ : mean(); }

 private:
  double sum_ = 0;
  double count_ = 0;
  double largest_ = -kInfinity;
};

/// Gathers the solves of one method at one tolerance.
class AccuracyTally {
 public:
  void add(const Record& record, double truth) {
    ++point_.solves;
    point_.failures += !is_solved(record);
    point_.wrong += is_wrong(record, truth);
    add_error(record, truth);
    add_gap(record);
    seconds_.push_back(record.seconds);
    K_.add(static_cast<double>(record.counters.outer_iterations));
    N_rs_.add(static_cast<double>(record.counters.ray_iterations));
    supports_.add(static_cast<double>(record.counters.support_queries) / 2);
  }

  AccuracyPoint point(double tolerance) const {
    AccuracyPoint point = point_;
    point.tolerance = tolerance;
    const bool answered = answers_.error.count() > 0;
    point.mean_error = (answered ? answers_ : left_).error.mean();
    point.mean_relative_error = (answered ? answers_ : left_).relative_error.mean();
    point.largest_relative_error = worst_error_.largest();
    point.mean_relative_gap = relative_gap_.mean();
    point.largest_relative_gap = relative_gap_.largest();
    point.mean_seconds = mean(seconds_);
    point.median_seconds = median(seconds_);
    point.K = K_.mean();
    point.N_rs = N_rs_.mean();
    point.supports = supports_.mean();
    return point;
  }

 private:
  void add_error(const Record& record, double truth) {
    if (std::isnan(truth)) return;
    const double error = std::abs(record.distance - truth);
    if (!std::isfinite(error)) {
      if (record.distance != truth) worst_error_.add(kInfinity);
      return;
    }
    point_.beyond_gap += error > record.upper - record.lower + truth_rounding(record) * truth;
    Errors& errors = is_solved(record) ? answers_ : left_;
    errors.error.add(error);
    if (truth <= 0) return;
    errors.relative_error.add(error / truth);
    worst_error_.add(error / truth);
  }

  void add_gap(const Record& record) {
    const double gap = relative_gap(record);
    point_.bounded += std::isfinite(record.upper - record.lower);
    relative_gap_.add(std::isnan(gap) ? kInfinity : gap);
  }

  struct Errors {
    RunningMean error, relative_error;
  };

  AccuracyPoint point_;
  Errors answers_;  ///< of solves with an answer
  Errors left_;     ///< of those that stopped at a limit
  RunningMean worst_error_, relative_gap_, K_, N_rs_, supports_;
  std::vector<double> seconds_;
};

}  // namespace

std::vector<AccuracyCurve> accuracy_curves(const std::vector<const Record*>& records, const Truth& truth) {
  std::vector<AccuracyCurve> curves;
  std::map<std::string, std::map<double, AccuracyTally, std::greater<>>> tallies;
  const Record* before = nullptr;  // most often of the same method and tolerance
  AccuracyTally* tally = nullptr;
  for (const Record* record : records) {
    if (!before || record->tolerance != before->tolerance || record->method != before->method) {
      const auto [found, is_new] = tallies.try_emplace(record->method);
      if (is_new) curves.push_back({facts_of(*record), record->method, {}});
      tally = &found->second[record->tolerance];
    }
    tally->add(*record, truth(*record));
    before = record;
  }
  for (AccuracyCurve& curve : curves) {
    for (const auto& [tolerance, each] : tallies[curve.method]) curve.points.push_back(each.point(tolerance));
  }
  return curves;
}

AccuracyFloor accuracy_floor(const AccuracyCurve& curve) {
  if (curve.points.empty()) throw EmptySetError("accuracy of method '" + curve.method + "': no solves");
  AccuracyFloor floor;
  floor.certified = kNaN;
  for (const AccuracyPoint& point : curve.points) {
    if (point.largest_relative_gap <= point.tolerance) floor.certified = point.tolerance;
  }
  double best = kInfinity;
  for (const AccuracyPoint& point : curve.points) best = std::min(best, point.mean_relative_error);
  const auto reached =
      std::find_if(curve.points.begin(), std::prev(curve.points.end()),
                   [&](const AccuracyPoint& point) { return point.mean_relative_error <= 2 * best; });
  floor.reached = *reached;
  floor.still_improving = std::next(reached) == curve.points.end();
  const AccuracyPoint& loosest = curve.points.front();
  const double decades = std::log10(loosest.tolerance / reached->tolerance);
  floor.seconds_a_digit = decades > 0 ? (reached->median_seconds - loosest.median_seconds) / decades : kNaN;
  return floor;
}

}  // namespace raygauge
