// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "raygauge/exceptions.h"
#include "raygauge/sweep/method.h"

namespace raygauge {

/// What a SolveMethod is too whose load() takes much longer than a pass over the points.
class LimitedLoad {
 public:
  virtual ~LimitedLoad() = default;

  /// Bounds the loads that follow: one that would take longer than `seconds` ends, and so does the solve,
  /// with time_limit. The time limit of a solve is for its load too.
  virtual void limit_load(double seconds) = 0;
};

/// Bounds the loads of a method that can be bounded.
inline void limit_load(SolveMethod& method, double seconds) {
  if (auto* limited = dynamic_cast<LimitedLoad*>(&method)) limited->limit_load(seconds);
}

/// Loads an instance within the limit. Throws InvalidParameterError where the method, of this label, does not
/// compute what the instance asks for.
inline void load_within(SolveMethod& method, const std::string& label, const Instance& instance,
                        double seconds) {
  if (!method.answers(instance.quantity))
    throw InvalidParameterError("method '" + label + "' does not compute the quantity '" +
                                std::string(to_string(instance.quantity)) + "'");
  limit_load(method, seconds);
  method.load(instance);
}

}  // namespace raygauge
