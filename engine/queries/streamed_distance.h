// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>

#include "engine/numerics/stopwatch.h"
#include "engine/queries/streamed_set.h"
#include "raygauge/queries/solver.h"

namespace raygauge {

/// d_Q(A) where A, or Q, or both are points that memory does not hold. Working sets of some of them are
/// solved again and again while the points pass by: those that price out join. A pass in which the normal u
/// stays the same proves
///
///     -h_A(u) / h_Q(-u)  <=  d_Q(A)  <=  d of the working sets,
///
/// for the hull of some points of A lies in A, and the gauge of some points of Q is not below that of Q. Some
/// two to four passes.
class StreamedDistance {
 public:
  /// A StreamedHull is read by passes, every other set is the caller's and stays where it is; both have the
  /// same dimension. `stop` as of Stopwatch::start. Throws NonFiniteError, and what the streams throw.
  StreamedDistance(const ConvexSet& A, const ConvexSet& Q, const DistanceOptions& options,
                   const std::function<bool()>* stop = nullptr);

  const DistanceResult& solve(Effects effects = Effects::none);

  int passes() const noexcept { return passes_; }

 private:
  struct Side {
    const ConvexSet* set = nullptr;
    std::shared_ptr<const PointSet> working_set;
    std::unique_ptr<StreamedSet> streamed;  // nullptr: all of it is in `set`
    double sign = 1;                        // of the normal
    Vector direction;
    SupportValue h;    // of the last pass
    double level = 0;  // max over `set`
    double slack = 0;  // above the level, without need of another normal
  };

  void resolve();
  static void take_working_set(Side& side);
  void aim(Side& side) const;
  bool pass(Side& side);
  void measure_known(Side& side) const;
  void prove();

  DistanceOptions options_;
  const std::function<bool()>* stop_;
  Effects effects_ = Effects::none;
  Stopwatch stopwatch_;
  Side side_[2];
  DistanceResult result_;
  int passes_ = 0;
  std::int64_t points_priced_ = 0;
};

}  // namespace raygauge
