// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/scene/scene.h"
#include "raygauge/sets/pose.h"

namespace raygauge {

/// Counts of what was computed; tests use them to check that nothing else was.
struct SceneCounters {
  std::int64_t distance_solves = 0;    ///< distances of two convex parts
  std::int64_t separation_solves = 0;  ///< separation tests of two convex parts
  std::int64_t growth_solves = 0;      ///< growth distances of two convex parts
  std::int64_t closest_points = 0;     ///< pairs of closest points
  std::int64_t gradients = 0;
  std::int64_t plane_tests = 0;      ///< tests whether an earlier separating plane still separates two parts
  std::int64_t ball_tests = 0;       ///< bounds on a distance from bounding balls
  std::int64_t support_queries = 0;  ///< by solves; the two of a plane test are not among them

  SceneCounters& operator+=(const SceneCounters& other);
  std::int64_t solves() const noexcept { return distance_solves + separation_solves + growth_solves; }
  friend bool operator==(const SceneCounters&, const SceneCounters&) = default;
};

/// What is known of the distance of two bodies. Bounds are certified.
struct PairAnswer {
  double lower = 0;
  double upper = std::numeric_limits<double>::infinity();
  double value = 0;  ///< within [lower, upper]
  DistanceStatus status = DistanceStatus::optimal;
  int part_a = -1, part_b = -1;  ///< the nearest parts; -1: not looked for
  SmallVector normal;            ///< empty: none
  SmallVector point_a, point_b;  ///< closest points; empty: none, or not asked for
  SmallVector gradient;          ///< of the distance, when body a is translated
  double rate = 0;  ///< the lower bound falls by at most rate × (distance that points of both bodies move)

  /// Common points are proven.
  bool intersecting() const noexcept { return status == DistanceStatus::contains_origin; }

  /// As a new one, of parts a and b.
  void begin(int a, int b) noexcept;
};

enum class PairSeparation : std::uint8_t { separated, intersecting, undecided };

/// Data of two parts kept between queries. Used only as hints: a plane is tested again before it proves
/// anything.
struct PartMemory {
  SmallVector normal;       ///< of a plane that lay between them; empty: none
  bool overlapped = false;  ///< whether they shared a point when last solved
  WarmStart distance, growth;
};

/// What a pair of bodies keeps, by part_a * (parts of b) + part_b.
using PairMemory = std::vector<PartMemory>;

/// Answers questions about two placed bodies. One a thread: it owns the workspace.
class PairSolver {
 public:
  explicit PairSolver(int dimension);
  ~PairSolver();

  /// The tolerance of distances from now on.
  void set_tolerance(double tolerance);

  /// The pair and the metric of what follows; all must outlive their use.
  void bind(const Body& a, const Body& b, const SceneMetric& metric);

  /// Where they stand from now on. `metric_at` is the placement of the body that the metric follows, if any.
  void place(const Placement& a, const Placement& b, const Placement* metric_at = nullptr);

  const Placement& placement_a() const noexcept { return at_a_; }
  const Placement& placement_b() const noexcept { return at_b_; }

  /// A certified lower bound on the distance from the bounding balls of the whole bodies; it falls by at most
  /// ball_rate() times the way of their middles.
  double ball_bound(const double* center_a, const double* center_b);
  double ball_rate() const noexcept { return 1 / outer_radius_; }

  /// A certified lower bound on the distance from the planes in memory; 0 where they prove nothing. `rate` as
  /// in PairAnswer. Useless under a metric that follows a body.
  double plane_bound(const PairMemory& memory, double& rate);

  /// The Euclidean distance between two planes across the unit vector u that touch the bodies, with body b on
  /// the side away from u. It is a lower bound on their distance, and at most 0 where they may overlap.
  /// `arm_a` and `arm_b`: where the planes touch, from the origins of the bodies. For bodies of one part
  /// each.
  double apart_along(const SmallVector& u, SmallVector& arm_a, SmallVector& arm_b);

  /// The distance. A lower bound above `enough` ends it early; upper is then +infinity where it was not
  /// needed. The answer belongs to the solver and lives until the next distance.
  const PairAnswer& distance(PairMemory& memory, double enough, bool closest_points, bool gradient);

  /// Whether they are apart.
  PairSeparation separation(PairMemory& memory);

  /// The growth distance about the centres of the parts, the least over all pairs of parts. Lives until the
  /// next one.
  const PairAnswer& growth(PairMemory& memory);

  const SceneCounters& counters() const noexcept { return counters_; }

 private:
  struct PartPair {
    int a = 0, b = 0;
    double ball_bound = 0;
  };

  const SceneMetric& metric() const noexcept { return *metric_; }
  std::size_t memory_index(const PartPair& pair) const;
  void sort_part_pairs();
  double part_ball_bound(int i, int j) const;
  double depth_along(int i, int j, const SmallVector& u, SmallVector& point_a, SmallVector& point_b) const;
  double part_plane_bound(int i, int j, const SmallVector& u) const;
  void solve_parts(const PartPair& pair, bool closest_points, PartMemory& memory, PairAnswer& answer);
  bool solve_fixed(const PartPair& pair, bool closest_points, PartMemory& memory, PairAnswer& answer);
  bool still_overlap(const PartPair& pair, PartMemory& memory);
  void growth_of_parts(const PartPair& pair, WarmStart& warm, PairAnswer& answer);
  void check_placements();
  void pose_bodies();
  const ConvexSet& set_of_a(const PartPair& pair) const;
  const ConvexSet& set_of_b(const PartPair& pair) const;
  Posed part_of_a(const PartPair& pair);
  Posed part_of_b(const PartPair& pair);

  int dimension_;
  ObjectDistanceSolver distance_;
  GrowthDistanceSolver separation_, growth_;
  PlacedSet set_Q_;
  std::shared_ptr<const ConvexSet> ball_;
  const Body* a_ = nullptr;
  const Body* b_ = nullptr;
  const SceneMetric* metric_ = nullptr;
  class FixedSolve;
  std::unique_ptr<FixedSolve> fixed_;
  Placement at_a_, at_b_;
  Pose pose_a_, pose_b_;  ///< the same, where posed_
  bool posed_ = false;
  double tolerance_ = 0;
  double outer_radius_ = 1;  ///< of Q about the origin
  SmallVector magnitude_Q_;
  std::vector<PartPair> part_pairs_;

  /// The answer about the nearest parts so far, and room for the next one.
  class Nearest {
   public:
    void clear() noexcept { best_->part_a = -1; }  // of no parts: the rest is not read
    PairAnswer& best() noexcept { return *best_; }
    PairAnswer& next(const PartPair& pair) noexcept;
    void take_next();

   private:
    PairAnswer answers_[2];
    PairAnswer* best_ = &answers_[0];
    PairAnswer* next_ = &answers_[1];
  };
  Nearest nearest_, least_growth_;
  SceneCounters counters_;
};

}  // namespace raygauge
