// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/meshes/triangle_set.h"
#include "engine/queries/spatial_solve.h"
#include "raygauge/queries/mesh_distance.h"
#include "raygauge/sets/ball.h"
#include "scene/planning/edge_pair.h"

namespace raygauge {

/// Two shapes at the beginning, in the middle and at the end of an interval, seen from the frame in which
/// their points follow chords: x of the first one is at R_a x, of the second one at R_b x + way.
struct SweepMoments {
  Matrix3 R_a[3], R_b[3];
  Vector3 way[3];
};

/// Two shapes of which one is a mesh at least, tested for being farther apart than some margin over a time.
/// Across any unit vector u the gap of two pieces is a function of time of which least_between() is a lower
/// bound, pieces being boxes of the trees, triangles, balls of a cloud and convex sets. Pairs of boxes that
/// no u of a few sets apart are opened; of two leaves u is that of their distance in the middle. Surfaces
/// only: whether one shape is inside the other at some time is for the caller to find out.
class MeshSweep {
 public:
  MeshSweep();
  MeshSweep(const MeshSweep&) = delete;
  MeshSweep& operator=(const MeshSweep&) = delete;

  /// The shapes of what follows, which must outlive it.
  void bind(const EdgeShape& a, const EdgeShape& b);

  /// Proves that no gap is `enough` or less, `enough` being the margin and all that is lost by rounding.
  /// `nearest`: triangles in the middle, which are tested first.
  bool apart(const SweepMoments& moments, const Sagging& sagging, double enough,
             const MeshWarmStart& nearest);

 private:
  /// A mesh, or a convex set with a box around it.
  struct Side {
    const Mesh* mesh = nullptr;
    const ConvexSet* set = nullptr;
    BoxNode box{};

    const BoxNode& node(std::int32_t i) const noexcept {
      return mesh != nullptr ? mesh->tree().node(i) : box;
    }
    double radius() const noexcept { return mesh != nullptr ? mesh->radius() : 0; }
    std::int32_t pieces() const noexcept {
      return mesh != nullptr ? static_cast<std::int32_t>(mesh->size()) : 1;
    }
  };

  /// A unit vector from the first shape to the second one, in the frames of both, at the beginning and the
  /// end.
  struct Plane {
    Vector3 u, of_a[2], of_b[2];
    double along[2];       ///< the way, less the radii of clouds
    double top_of_set[2];  ///< of the convex set, if one of them is
  };

  struct NodePair {
    std::int32_t one, two;
  };

  static Side side_of(const EdgeShape& shape);
  Plane plane_across(const Vector3& u) const;
  void measure_set(Plane& plane) const;
  void keep(Plane plane);
  bool proves(double before, double after) const noexcept;
  bool sets_apart(const Plane& plane, const BoxNode& one, const BoxNode& two, bool with_set) const;
  bool boxes_apart(const BoxNode& one, const BoxNode& two);
  bool leaves_apart(const BoxNode& one, const BoxNode& two);
  bool pieces_apart(std::int32_t one, std::int32_t two);
  bool sets_pieces_apart(const Plane& plane, std::int32_t one, std::int32_t two) const;
  bool direction_of(std::int32_t one, std::int32_t two, Vector3& u);
  void open(const NodePair& pair);

  Side a_, b_;
  const SweepMoments* at_ = nullptr;
  Sagging sagging_;
  double enough_ = 0;
  std::vector<NodePair> open_;
  std::vector<Plane> kept_;  // those that proved something, from last_ backwards
  std::size_t last_ = 0;
  TriangleSet triangle_;
  SpatialSolve solve_;
  Pose pose_a_, pose_b_;
  Ball ball_;
  ObjectDistanceSolver general_;  ///< of sets that have no SpatialShape
};

}  // namespace raygauge
