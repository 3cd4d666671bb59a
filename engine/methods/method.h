// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/lp/weighted_points.h"
#include "engine/methods/problem.h"

namespace raygauge {

/// What every method for d_Q(A) is to those who ask it.
class Method {
 public:
  virtual ~Method() = default;

  /// True if the solve was concluded here: `result` is the answer, or has the bounds at a limit. Otherwise
  /// the result stays as it was, and the caller asks another method.
  virtual bool solve(const Problem& problem, DistanceResult& result) = 0;

  /// What the last solve did, whether or not it was concluded.
  virtual DistanceCounters counters() const { return {}; }

  /// What the last solve has proven, though it was not concluded; write() is what belongs to it.
  virtual Bounds bounds() const { return {}; }
  virtual void write(DistanceStatus /*status*/, Effects /*effects*/, DistanceResult& /*result*/) {}

  /// Where Problem::pairs were asked for: adds the points of A and their weights in the combination that
  /// proves the upper bound.
  virtual void contact_combination(WeightedPoints& /*combination*/) const {}

 protected:
  Method() = default;
  Method(const Method&) = default;
  Method& operator=(const Method&) = default;
};

}  // namespace raygauge
