// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>
#include <limits>
#include <string>

#include "raygauge/methods/result.h"
#include "raygauge/sweep/instance.h"
#include "raygauge/sweep/registry.h"

namespace raygauge {

/// What a sweep asks of one solve.
struct SolveRequest {
  double tolerance = 1e-6;
  double time_limit = std::numeric_limits<double>::infinity();  ///< seconds
};

/// A way to compute the distance, ours or a competitor's. One object a thread; it may keep a workspace. A
/// sweep calls
///
///     load (timed as load_seconds)  →  solve, once or several times (timed as seconds)  →  result (not
///     timed)
///
/// No solve may use data of an earlier one.
class SolveMethod {
 public:
  virtual ~SolveMethod() = default;

  /// Whether the method computes this quantity. A sweep refuses instances that ask for another.
  virtual bool answers(Quantity quantity) const { return quantity == Quantity::distance; }

  /// Builds the model of `instance`, which outlives the solves that follow. Throws InvalidParameterError
  /// where the method cannot take such sets (the message says what it takes).
  virtual void load(const Instance& instance) = 0;

  /// Solves the loaded model from a cold start.
  virtual void solve(const SolveRequest& request) = 0;

  /// The outcome of the last solve. Bounds are certified by raygauge where the method itself offers none:
  /// `lower` from its dual by weak duality, `upper` from its primal; NaN where the method returned nothing to
  /// certify.
  virtual DistanceResult result() = 0;
};

using MethodRegistry = Registry<SolveMethod>;

/// Adds `column_generation`, `newton` and `zheng_yamane`.
void register_engine_methods(MethodRegistry& registry);

using SteadyClock = std::chrono::steady_clock;

/// Seconds from `start` until now.
inline double seconds_since(SteadyClock::time_point start) {
  return std::chrono::duration<double>(SteadyClock::now() - start).count();
}

/// One sample of a solve's time.
struct TimedSolve {
  double seconds = 0;         ///< of one solve: total / inner_repetitions
  int inner_repetitions = 1;  ///< solves in the sample
};

/// Times solves of the loaded model. A first solve that lasts `min_seconds` or longer is the sample.
/// After a shorter one, as many solves as fill `min_seconds` are timed together, without the first.
/// Allocates nothing.
TimedSolve time_solve(SolveMethod& method, const SolveRequest& request, double min_seconds);

/// What takes a sample: time_solve, or in a test something that needs no clock.
using SolveTimer = std::function<TimedSolve(SolveMethod&, const SolveRequest&, double min_seconds)>;

}  // namespace raygauge
