// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/queries/spatial_solve.h"
#include "raygauge/methods/options.h"
#include "raygauge/queries/object_distance.h"

namespace raygauge {

/// Queries about bodies of R^2 and R^3 by SpatialSolve, where the options leave the way to it open. Each
/// function returns false where it has no answer that is as certain and as precise as was asked for; nothing
/// is lost then but its time.
class SpatialQuery {
 public:
  /// The Euclidean distance, in units of the radius of the ball `metric`.
  bool distance(const Posed& A1, const Posed& A2, const ConvexSet& metric, const DistanceOptions& options,
                ObjectEffects effects, WarmStart* warm, ObjectDistance& result);

  /// The growth distance of A about its centre and Q about its own, or about the origin of the world.
  bool growth(const Posed& A, const Posed& Q, bool about_origin, const DistanceOptions& options,
              double threshold, WarmStart* warm, DistanceResult& result);

 private:
  bool bind(const Posed& first, const Posed& second, const DistanceOptions& options);
  void set_counters(DistanceResult& result) const;

  SpatialSolve solve_;
  SpatialShape metric_;
};

}  // namespace raygauge
