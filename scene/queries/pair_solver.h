// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <unordered_map>
#include <vector>

#include "scene/queries/part_order.h"
#include "scene/queries/part_solver.h"

namespace raygauge {

/// What a pair of bodies keeps of the pairs of its parts, by part_a * (parts of b) + part_b: of all where
/// they are few, else of those that were solved.
class PairMemory {
 public:
  /// For so many pairs from now on; those that are known are kept if there were as many.
  void resize(std::size_t pairs);

  PartMemory& of(std::size_t pair) { return is_dense() ? all_[pair] : solved_[pair]; }

  /// nullptr: nothing is known.
  const PartMemory* find(std::size_t pair) const;
  std::size_t size() const noexcept { return pairs_; }
  bool empty() const noexcept { return pairs_ == 0; }

 private:
  bool is_dense() const noexcept { return pairs_ <= kDense; }

  static constexpr std::size_t kDense = 1024;
  std::size_t pairs_ = 0;
  std::vector<PartMemory> all_;
  std::unordered_map<std::size_t, PartMemory> solved_;
};

/// Answers questions about two placed bodies: the least over all pairs of their parts. One a thread: it owns
/// the workspace.
class PairSolver {
 public:
  explicit PairSolver(int dimension) : placed_(dimension) {}

  /// The tolerance of distances from now on.
  void set_tolerance(double tolerance) { solver_.set_tolerance(tolerance); }

  /// The pair and the metric of what follows; all must outlive their use.
  void bind(const Body& a, const Body& b, const SceneMetric& metric);

  /// Where they stand from now on. `metric_at` is the placement of the body that the metric follows, if any.
  void place(const Placement& a, const Placement& b, const Placement* metric_at = nullptr) {
    placed_.place(a, b, metric_at);
  }

  const Placement& placement_a() const noexcept { return placed_.a().at(); }
  const Placement& placement_b() const noexcept { return placed_.b().at(); }

  /// As of PlacedPair.
  double ball_bound(const double* center_a, const double* center_b);
  double ball_rate() const noexcept { return placed_.ball_rate(); }
  double apart_along(const SmallVector& u, SmallVector& arm_a, SmallVector& arm_b);

  /// A certified lower bound on the distance from the planes in memory; 0 where they prove nothing. `rate` as
  /// in PairAnswer. Useless under a metric that follows a body.
  double plane_bound(const PairMemory& memory, double& rate);

  /// The distance. A lower bound above `enough` ends it early; upper is then +infinity where it was not
  /// needed. The answer belongs to the solver and lives until the next distance.
  const PairAnswer& distance(PairMemory& memory, double enough, bool closest_points, bool gradient);

  /// As of PartSolver, of the parts that the last distance was solved of.
  bool meets_if_moved(double way) { return solver_.meets_if_moved(way); }

  /// The same with closest points and gradient, and of bodies that are not proven to be apart the depth: the
  /// greatest over all pairs of parts, with the points in contact and the gradient of the deepest. No shorter
  /// translation separates the bodies; of bodies of one part each it does.
  const PairAnswer& signed_distance(PairMemory& memory, double enough);

  /// Whether they are apart.
  Separation separation(PairMemory& memory);

  /// The growth distance about the centres of the parts, the least over all pairs of parts. Lives until the
  /// next one.
  const PairAnswer& growth(PairMemory& memory);

  const SceneCounters& counters() const noexcept { return counters_; }

 private:
  /// The answer about the nearest parts so far, and room for the next one.
  class Nearest {
   public:
    void clear() noexcept { best_->part_a = -1; }  // of no parts: the rest is not read
    PairAnswer& best() noexcept { return *best_; }
    PairAnswer& next(PartNumbers parts) noexcept;
    void take_next(bool is_signed);

   private:
    PairAnswer answers_[2];
    PairAnswer* best_ = &answers_[0];
    PairAnswer* next_ = &answers_[1];
  };

  std::size_t memory_index(PartNumbers parts) const;
  std::size_t pairs() const noexcept {
    return placed_.a().body().parts.size() * placed_.b().body().parts.size();
  }
  void take_order(PairMemory& memory);
  double plane_bound_of(const PairMemory& memory, const PartCandidate& candidate, double& rate);
  template <class Solve>
  PairAnswer& find_nearest(PairMemory& memory, double enough, bool is_signed, const Solve& solve);
  void conclude(double beyond, double beyond_rate);

  PlacedPair placed_;
  PartSolver solver_;
  PartOrder order_;
  Nearest nearest_, least_growth_;
  SceneCounters counters_;
};

}  // namespace raygauge
