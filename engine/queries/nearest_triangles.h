// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "engine/meshes/triangle_set.h"
#include "engine/numerics/stopwatch.h"
#include "engine/queries/mesh_pair.h"
#include "engine/queries/spatial_solve.h"
#include "raygauge/queries/mesh_distance.h"
#include "raygauge/sets/ball.h"

namespace raygauge {

/// The nearest two triangles of a pair of meshes, or the triangle that is nearest to a body, of those looked
/// at so far, with bounds on the distance of the surfaces.
class NearestTriangles {
 public:
  /// `watch` is of the search.
  NearestTriangles(const DistanceOptions& options, const Stopwatch& watch);
  NearestTriangles(const NearestTriangles&) = delete;
  NearestTriangles& operator=(const NearestTriangles&) = delete;

  /// Nothing is known of the pair. Distances of `enough` and more need not be told apart.
  void begin(const MeshPair& pair, double enough);

  /// Triangle `one`, and triangle `two` of the second mesh as it stands in the first frame.
  void look_at(std::int32_t one, std::int32_t two, const TriangleCorners& turned);

  /// The same; a direction from the first to the second, or nearly, is where the solve begins.
  void look_at(std::int32_t one, std::int32_t two, const TriangleCorners& turned, const Vector3& from);

  /// Triangle `one`, and the body.
  void look_at_body(std::int32_t one);

  /// Whether what is at least so far away need not be looked at.
  bool is_beyond(double lower) const noexcept { return lower - pair_->margin >= target_; }
  double target() const noexcept { return target_; }

  /// Notes what is_beyond() the target and was not looked at.
  void pass_over() noexcept { passed_over_ = true; }

  /// The time is over, with pairs at least so far apart left open.
  void leave_open(double lower) noexcept;

  /// All that was not looked at is beyond the target.
  void end_search() noexcept;

  /// How far above the plane of plane_below() the box is, at least; -infinity where no plane is known.
  double plane_distance(const BoxNode& one) const noexcept;

  /// The nearest triangles, of which the second one has moved: whether they meet.
  bool nearest_meet(const Pose& pose_2);

  /// Closest points in the world, three numbers each, where they are known; else false.
  bool closest_points(double (*points)[3]) const;

  /// What is known. A search for points of one object inside the other may change it.
  struct Found {
    double lower = 0, upper = 0;
    double inside_by = 0;  ///< where a point inside proves it: how far apart the surfaces are, at least
    bool meets = false, out_of_time = false;
    std::int32_t nearest_1 = -1, nearest_2 = -1;
    Vector3 normal;  ///< in the first frame, from 1 to 2; 0: unknown
  };
  Found found;
  MeshCounters counters;

 private:
  enum class Points : std::uint8_t { unknown, in_first, in_world };

  const ConvexSet& second_set(std::int32_t two);
  void solve_precisely(std::int32_t one, std::int32_t two);
  void solve_generally(std::int32_t one, std::int32_t two);
  void meet(std::int32_t one, std::int32_t two);
  void take(double lower, double upper, std::int32_t one, std::int32_t two);
  void take_normal(const double* from_2_to_1, bool nearer);

  DistanceOptions options_;
  const MeshPair* pair_ = nullptr;
  double enough_ = 0;
  double target_ = 0;  // pairs at least this far apart are not looked at
  bool passed_over_ = false;
  Points points_ = Points::unknown;  // where the closest points are: in the first frame ...
  Vector3 point_1_, point_2_;
  double world_point_[2][3] = {};  // ... or in the world
  Vector3 plane_;                  // a unit vector, in the first frame ...
  double plane_of_ = 0;            // ... and its least height over the body
  bool has_plane_ = false;
  TriangleSet triangle_[2];
  SpatialSolve solve_;
  Ball ball_;
  ObjectDistanceSolver general_;
};

}  // namespace raygauge
