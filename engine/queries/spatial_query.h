// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/spatial/spatial_distance.h"
#include "raygauge/methods/options.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/queries/warm_start.h"

namespace raygauge {

/// Queries about bodies of R^2 and R^3 by fixed-size code, where it has what it needs: both sets have a
/// SpatialShape and the options leave the way to it open. Each function returns false where it has no answer
/// that is as certain and as precise as was asked for; nothing is lost then but its time.
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
  void begin(const WarmStart* warm);
  bool no_growth(WarmStart* warm, DistanceResult& result);
  bool find_distance(const Posed& A1, const Posed& A2, const DistanceOptions& options);
  void record(const SpatialAnswer& answer, const Vector& normal, WarmStart* warm) const;
  void closest_points(const SpatialAnswer& answer, ObjectDistance& result) const;

  SpatialPair pair_;
  SpatialStart start_;
  SpatialAnswer answer_;
  SpatialShape metric_;
};

}  // namespace raygauge
