// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "raygauge/meshes/mesh.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"

namespace raygauge {

class MeshSearch;

/// The nearest triangles of the last solve of a pair, from which the next one starts.
struct MeshWarmStart {
  std::int32_t triangle_1 = -1, triangle_2 = -1;  ///< in the order of the trees; -1: none is known

  void clear() noexcept { triangle_1 = triangle_2 = -1; }
};

/// Work of one solve.
struct MeshCounters {
  std::int64_t box_pairs = 0;       ///< pairs of boxes whose distance was bounded
  std::int64_t triangle_pairs = 0;  ///< pairs of triangles, or of a triangle and a body, that were examined
  std::int64_t precise_pairs = 0;   ///< of these: solved by SpatialSolve or a general method
  std::int64_t points_located = 0;  ///< tests whether a solid contains a point
};

/// The Euclidean distance of a mesh and a convex set, or of two meshes, each in its pose:
///
///     d = min{|a2 - a1| : a1 in A1, a2 in A2},
///
/// with certified bounds: the upper one is that of two points, the lower one the least over all pairs of
/// triangles, of which most are excluded by the distance of boxes around them. Common points are proven by
/// two triangles that share one, or by a point of the one in the solid that the other is. Where surfaces only
/// touch, the bounds are 0 and a number near it, and the status is `precision_limit`. A HalfSpace is excluded
/// by the height of boxes above its plane; near triangles have a closed form.
///
/// Depth and growth distance are defined for convex sets: an object of several convex parts has them.
///
/// One solver per thread; repeated solves allocate nothing once the workspace has grown.
class MeshDistanceSolver {
 public:
  /// `tolerance` and `time_limit` are those of DistanceOptions; the method must be `automatic`. Throws
  /// InvalidParameterError for an option outside its range.
  explicit MeshDistanceSolver(const DistanceOptions& options = {});
  ~MeshDistanceSolver();
  MeshDistanceSolver(MeshDistanceSolver&&) noexcept;
  MeshDistanceSolver& operator=(MeshDistanceSolver&&) noexcept;

  /// See DistanceSolver::set_stop.
  void set_stop(std::function<bool()> stop);

  /// As of ObjectDistanceSolver, in the Euclidean metric. `distance.normal` is the unit vector that proves
  /// the distance of the nearest two triangles, from A2 to A1; the rest of a mesh may be on either side of
  /// it. Throws DimensionMismatchError (a set that is not of R^3) and InvalidParameterError for the effects
  /// `depth` and `pose_gradient`.
  const ObjectDistance& solve(const PosedMesh& A1, const PosedMesh& A2,
                              ObjectEffects effects = ObjectEffects::none, MeshWarmStart* warm = nullptr);
  const ObjectDistance& solve(const PosedMesh& A1, const Posed& A2,
                              ObjectEffects effects = ObjectEffects::none, MeshWarmStart* warm = nullptr);

  /// The same for sets of which at least one is a MeshObject. `warm` is of A1, A2 in this order. Throws
  /// InvalidParameterError if neither is.
  const ObjectDistance& solve(const Posed& A1, const Posed& A2, ObjectEffects effects = ObjectEffects::none,
                              MeshWarmStart* warm = nullptr);

  /// Whether they have no point in common, proven either way. This is faster than a distance: it ends at the
  /// first common point, and boxes that are apart are not opened.
  Separation separation(const PosedMesh& A1, const PosedMesh& A2, MeshWarmStart* warm = nullptr);
  Separation separation(const PosedMesh& A1, const Posed& A2, MeshWarmStart* warm = nullptr);
  Separation separation(const Posed& A1, const Posed& A2, MeshWarmStart* warm = nullptr);

  /// Whether the objects of the last solve have a common point however their points move by at most `way` in
  /// all; false where that is not proven. They must still be where they were. The two triangles that met, or
  /// the triangle and the convex set, meet in six places around, and so in all between. A point inside a
  /// solid stays there while the surfaces are farther apart than `way`.
  bool meets_if_moved(double way);

  /// The work of the last solve.
  const MeshCounters& counters() const noexcept;

 private:
  std::unique_ptr<MeshSearch> search_;
};

}  // namespace raygauge
