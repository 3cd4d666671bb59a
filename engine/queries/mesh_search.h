// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/kernels/kernel.h"
#include "engine/meshes/box_tree.h"
#include "engine/meshes/triangle_set.h"
#include "engine/numerics/stopwatch.h"
#include "engine/queries/spatial_solve.h"
#include "raygauge/queries/mesh_distance.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/half_space.h"

namespace raygauge {

/// The search for the nearest two triangles of two meshes, or for the triangle of a mesh that is nearest to a
/// body or a half-space, in the frame of the first mesh. Pairs of boxes are taken depth first, the nearer one
/// first: of two meshes eight at once, in single precision, as are pairs of triangles; what is not beyond the
/// target then is looked at again.
class MeshSearch {
 public:
  explicit MeshSearch(const DistanceOptions& options);

  void set_stop(std::function<bool()> stop) { stop_ = std::move(stop); }

  const ObjectDistance& distance(const PosedMesh& A1, const PosedMesh& A2, ObjectEffects effects,
                                 MeshWarmStart* warm);
  const ObjectDistance& distance(const PosedMesh& A1, const Posed& A2, ObjectEffects effects,
                                 MeshWarmStart* warm);

  /// Ends with a lower bound above 0.
  Separation separation(const PosedMesh& A1, const PosedMesh& A2, MeshWarmStart* warm);
  Separation separation(const PosedMesh& A1, const Posed& A2, MeshWarmStart* warm);

  /// The last answer, about the second object and the first one.
  const ObjectDistance& turn_answer() noexcept;

  /// See MeshDistanceSolver.
  bool meets_if_moved(double way);

  const MeshCounters& counters() const noexcept { return counters_; }

 private:
  /// What the first mesh is compared with: a mesh, or a body with a box around it in its own frame.
  struct Other {
    const Mesh* mesh = nullptr;
    const ConvexSet* body = nullptr;
    const BoxTree* tree = nullptr;
    BoxNode box{};
    bool is_half_space = false;  // which has no box

    const BoxNode& node(std::int32_t i) const noexcept { return tree != nullptr ? tree->node(i) : box; }
  };

  struct OpenPair {
    std::int32_t one, two;
    double lower;
  };

  /// The same of boxes that are opened eight at once, as WideNode has them.
  struct WidePair {
    std::int32_t one, two, wide_one, wide_two;
    float lower;
  };

  /// A triangle of a block, and how far it is from the box of another, at least.
  struct BlockLane {
    int lane;
    float lower;
  };

  void measure(double size_of_second);
  void begin(const PosedMesh& A1, const Pose* pose_2);
  void set_other(const Mesh& mesh);
  void set_other(const ConvexSet& body);
  void set_half_space(const HalfSpace& half_space);
  void place();
  void search(double enough, MeshWarmStart* warm);
  void search_boxes();
  void search_wide();
  void note_out_of_time(double lower);
  void open(const WidePair& pair);
  void push_near(const WidePair& pair, const WideNode& node, unsigned lanes, const float* lower,
                 bool of_first);
  const PlacedBox& place_first(std::int32_t one);
  const PlacedBox& place_second(std::int32_t two);
  void look_at_blocks(const WidePair& pair);
  int near_of_block(const WidePair& pair, bool of_first, BlockLane* near);
  void add_lane(const TriangleBlock& one, int i, const TriangleBlock& two, int k);
  void look_at_lanes();
  void look_around(MeshWarmStart* warm);
  void expand(const OpenPair& pair);
  void push(std::int32_t one, std::int32_t two);
  double box_distance(const BoxNode& one, const BoxNode& two) const noexcept;
  double plane_distance(const BoxNode& one) const noexcept;
  void look_at_leaves(const BoxNode& one, const BoxNode& two);
  void turn_second(std::int32_t two);
  void look_at(std::int32_t one, std::int32_t two);
  bool is_beyond(double lower) const noexcept { return lower - margin_ >= target_; }
  void look_at_triangles(std::int32_t one, std::int32_t two, const Vector3& from);
  void look_at_body(std::int32_t one);
  void solve_precisely(std::int32_t one, std::int32_t two, const ConvexSet& second);
  void solve_generally(std::int32_t one, std::int32_t two, const ConvexSet& second);
  void meet(std::int32_t one, std::int32_t two);
  void take(double lower, double upper, std::int32_t one, std::int32_t two);
  void take_normal(const double* from_2_to_1, bool nearer);
  void locate();
  void ask_points_of_second();
  void ask_points_of_first();
  void ask(const Mesh& solid, const Vector3& point);
  void keep_nearest(MeshWarmStart* warm) const;
  Separation separation_found(MeshWarmStart* warm) const;
  const ObjectDistance& finish(ObjectEffects effects, MeshWarmStart* warm);
  void write_points(ObjectEffects effects);

  Vector3 to_first(const Vector3& x) const noexcept { return R_ * x + t_; }
  static Posed posed(const ConvexSet& set, const Pose* pose) {
    return pose == nullptr ? Posed(set) : Posed(set, *pose);
  }

  // Farther than this from a surface, in margins, a computed point is on the same side as the point itself.
  static constexpr double kClearMargins = 4;

  DistanceOptions options_;
  std::function<bool()> stop_;
  Stopwatch watch_;
  std::int64_t looks_ = 0;
  bool out_of_time_ = false;

  const Mesh* first_ = nullptr;
  Other other_;
  const Pose* pose_1_ = nullptr;
  const Pose* pose_2_ = nullptr;
  double radius_1_ = 0, radii_ = 0;  // of the balls of a first cloud, of both objects together
  Matrix3 W_, R_;                    // first frame to world, second frame to first
  Vector3 w_, t_;
  double margin_ = 0;  // what is computed of lengths is within this of the truth
  bool in_range_ = false, in_single_range_ = false;

  std::vector<OpenPair> open_;
  std::vector<WidePair> wide_open_;
  const Kernels& kernels_;
  Matrix3 back_R_;  // first frame to second
  Vector3 back_t_;
  double single_slack_ = 0;  // what is computed of boxes in single precision is less this
  struct Placed {
    std::int32_t node = -1;
    PlacedBox box{};
  };
  Placed placed_[2];       // the last boxes of both meshes that others were compared with
  TriangleLanes lanes_{};  // pairs of triangles that are to be looked at ...
  std::int32_t lane_one_[TriangleLanes::kCount], lane_two_[TriangleLanes::kCount];  // ... their numbers
  int lane_count_ = 0;
  double enough_ = 0;
  double target_ = 0;  // pairs at least this far apart are not looked at
  double lower_ = 0, upper_ = 0;
  bool meets_ = false, passed_over_ = false;
  double inside_by_ = 0;  // where a point inside proves it: how far apart the surfaces are, at least
  std::int32_t nearest_1_ = -1, nearest_2_ = -1;
  enum class Points : std::uint8_t { unknown, in_first, in_world };
  Points points_ = Points::unknown;  // where the closest points are: in the first frame ...
  Vector3 point_1_, point_2_;
  double world_point_[2][3] = {};  // ... or in the world
  Vector3 normal_;                 // in the first frame, from 1 to 2
  Vector3 plane_;                  // a unit vector, in the first frame ...
  double plane_of_ = 0;            // ... and its least height over the body
  bool has_plane_ = false;

  TriangleCorners turned_;  // of the second mesh, in the first frame
  TriangleSet triangle_[2];
  SpatialSolve solve_;
  Ball ball_;
  ObjectDistanceSolver general_;
  ObjectDistance result_;
  MeshCounters counters_;
};

}  // namespace raygauge
