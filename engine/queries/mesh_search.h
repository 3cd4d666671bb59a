// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <utility>

#include "engine/numerics/stopwatch.h"
#include "engine/queries/box_search.h"
#include "engine/queries/mesh_pair.h"
#include "engine/queries/nearest_triangles.h"
#include "engine/queries/wide_search.h"
#include "raygauge/queries/mesh_distance.h"

namespace raygauge {

/// The distance of two meshes, or of a mesh and a body or a half-space: the nearest triangles, found by a
/// search over both trees of boxes, and whether one object is inside the other.
class MeshSearch {
 public:
  explicit MeshSearch(const DistanceOptions& options);

  void set_stop(std::function<bool()> stop) { stop_ = std::move(stop); }

  const ObjectDistance& distance(const MeshPair& pair, ObjectEffects effects, MeshWarmStart* warm);

  /// Ends with a lower bound above 0.
  Separation separation(const MeshPair& pair, MeshWarmStart* warm);

  /// The last answer, about the second object and the first one.
  const ObjectDistance& turn_answer() noexcept;

  /// See MeshDistanceSolver.
  bool meets_if_moved(double way);

  const MeshCounters& counters() const noexcept { return nearest_.counters; }

 private:
  void search(const MeshPair& pair, double enough, MeshWarmStart* warm);
  void look_around(const MeshWarmStart* warm);
  void locate();
  void ask_points_of_second();
  void ask_points_of_first();
  void ask(const Mesh& solid, const Vector3& point);
  void keep_nearest(MeshWarmStart* warm) const;
  void write_bounds();
  void write_points(ObjectEffects effects);

  DistanceOptions options_;
  std::function<bool()> stop_;
  Stopwatch watch_;
  MeshPair pair_;
  NearestTriangles nearest_;
  BoxSearch boxes_;
  WideSearch wide_;
  ObjectDistance result_;
};

}  // namespace raygauge
