// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/queries/spatial_solve.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/mesh_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/scene/continuous.h"
#include "raygauge/scene/scene_run.h"
#include "scene/queries/placed_pair.h"

namespace raygauge {

/// Data of two parts kept between queries. Used only as hints: a plane is tested again before it proves
/// anything.
struct PartMemory {
  SmallVector normal;       ///< of a plane that lay between them; empty: none
  bool overlapped = false;  ///< whether they shared a point when last solved
  WarmStart distance, growth;
  MeshWarmStart mesh;
};

/// Solves about two convex parts where they stand. One a thread: it owns the workspace. What was computed is
/// added to `counters`.
class PartSolver {
 public:
  PartSolver();

  /// Of distances and growth distances from now on.
  void set_tolerance(double tolerance);

  /// Fixed-size code keeps what it made of two parts while these move: until this is called.
  void forget() noexcept { first_ = nullptr; }

  /// The distance, into an answer that is as begun.
  void distance(PlacedPair& pair, PartNumbers parts, bool closest_points, PartMemory& memory,
                PairAnswer& answer, SceneCounters& counters);

  /// The same with closest points, gradient, and the depth of parts that are not proven to be apart.
  void signed_distance(PlacedPair& pair, PartNumbers parts, PartMemory& memory, PairAnswer& answer,
                       SceneCounters& counters);

  /// Whether the parts of the last distance share a point however both move by at most `way` in all; false
  /// where that is not proven, and where neither was a mesh.
  bool meets_if_moved(double way) { return last_is_mesh_ && meshes_.meets_if_moved(way); }

  /// Whether they are apart.
  Separation separation(PlacedPair& pair, PartNumbers parts, PartMemory& memory, SceneCounters& counters);

  /// The growth distance about the centres, into an answer that is as begun.
  void growth(PlacedPair& pair, PartNumbers parts, PartMemory& memory, PairAnswer& answer,
              SceneCounters& counters);

 private:
  SpatialSolve* fixed_solve(const PlacedPair& pair, PartNumbers parts);
  bool distance_by_fixed_code(const PlacedPair& pair, PartNumbers parts, bool closest_points,
                              PartMemory& memory, PairAnswer& answer, SceneCounters& counters);
  const ObjectDistance& solve(PlacedPair& pair, PartNumbers parts, ObjectEffects effects, PartMemory& memory,
                              PairAnswer& answer, SceneCounters& counters);
  void mesh_distance(PlacedPair& pair, PartNumbers parts, bool closest_points, PartMemory& memory,
                     PairAnswer& answer, SceneCounters& counters);
  bool still_overlap(PlacedPair& pair, PartNumbers parts, PartMemory& memory, SceneCounters& counters);

  double tolerance_;
  ObjectDistanceSolver distance_;
  GrowthDistanceSolver separation_, growth_;
  MeshDistanceSolver meshes_;
  bool last_is_mesh_ = false;
  SpatialSolve fixed_;
  const ConvexSet* first_ = nullptr;  ///< what fixed_ is about
  const ConvexSet* second_ = nullptr;
  bool bound_ = false;
};

}  // namespace raygauge
