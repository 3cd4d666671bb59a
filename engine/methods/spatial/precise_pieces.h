// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/spatial/contact_program.h"
#include "engine/methods/spatial/precise_pair.h"
#include "engine/methods/spatial/spatial_distance.h"

namespace raygauge {

/// At most four support points of the difference of two cores with weights: vertices, or the pieces of curved
/// cores that are active near a normal.
struct PrecisePieces {
  int count = 0;
  PrecisePoint point[4];
  double weight[4] = {1, 0, 0, 0};

  /// The pieces of a combination, each once with all its weight, at most three; their points follow.
  void begin(const SpatialCombination& combination);

  /// Which of them is this piece; count: none.
  int find(const PrecisePoint& piece) const;

  /// Points on rims and curved surfaces follow u; the piece of its support point, if given, joins them.
  void follow(const PrecisePair& precise, const PreciseVector3& u, const PrecisePoint* highest);

  /// Of the pieces with their weights, in the world: H + λ + `damping` times the trace of H, across u.
  TangentMetric metric(const SpatialPair& pair, const PreciseVector3& u, double lambda, double damping) const;

  /// The active pieces with the weights of a step.
  void keep(const ContactStep<DoubleDouble>& found);
};

}  // namespace raygauge
