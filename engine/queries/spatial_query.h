// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/proof/bounds.h"
#include "engine/queries/spatial_solve.h"
#include "raygauge/methods/options.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"

namespace raygauge {

/// What fixed-size code has proven of a distance in R^2 or R^3 where it has no answer.
struct ProvenBounds {
  Bounds bounds;
  double normal[3] = {0, 0, 0};  ///< that proves the lower one, as DistanceResult::normal
};

/// Whether the options leave the way to fixed-size code open.
inline bool is_open_to_bodies(const DistanceOptions& options) noexcept {
  return options.method != DistanceMethod::zheng_yamane && options.max_iterations == 0;
}

/// Queries about bodies of R^2 and R^3 by SpatialSolve, where is_open_to_bodies(). Each
/// function returns false where it has no answer that is as precise as was asked for; what it has proven
/// nevertheless is in proven().
class SpatialQuery {
 public:
  /// The Euclidean distance, in units of the radius of the ball `metric`. `likely_overlap`: as in
  /// SpatialSolve.
  bool distance(const Posed& A1, const Posed& A2, const ConvexSet& metric, const DistanceOptions& options,
                ObjectEffects effects, WarmStart* warm, ObjectDistance& result,
                bool* likely_overlap = nullptr);

  /// The growth distance of A about its centre and Q about its own, or about the origin of the world.
  bool growth(const Posed& A, const Posed& Q, bool about_origin, const DistanceOptions& options,
              double threshold, WarmStart* warm, DistanceResult& result, bool fine_normal = false);

  /// As SpatialSolve::set_enough().
  void set_enough(double gap) noexcept { solve_.set_enough(gap); }

  /// Nothing is known of bodies before a query.
  void begin() noexcept { asked_ = false; }

  /// Of the last query: the support points that its answer ended with.
  const SpatialCombination& combination() const noexcept { return solve_.answer().combination; }

  /// The bodies of the last query, where they are; nullptr if there was no fixed-size code for it.
  const SpatialPair* pair() const noexcept { return asked_ ? &solve_.pair() : nullptr; }

  /// Of the last query, in its units, where that returned false; whether there was fixed-size code for it.
  const ProvenBounds& proven() const noexcept { return proven_; }
  bool was_asked() const noexcept { return asked_; }
  std::int64_t support_queries() const noexcept { return solve_.pair().queries(); }

  /// Whether two bodies have a point in common: the Euclidean distance, to whatever precision. normal() is
  /// then that of a plane between them, as SeparationResult has it.
  Separation separation(const Posed& A1, const Posed& A2, const DistanceOptions& options);
  Vector normal() const;

 private:
  bool bind(const Posed& first, const Posed& second, const DistanceOptions& options);
  bool place(const Posed& first, const Posed& second);
  void set_counters(DistanceResult& result) const;

  SpatialSolve solve_;
  ProvenBounds proven_;
  bool asked_ = false;
};

}  // namespace raygauge
