// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "generators/random.h"
#include "raygauge/queries/mesh_distance.h"
#include "raygauge/scene/continuous.h"

namespace raygauge::soak {

struct DrawnMesh;

/// What became of the meshes.
struct MeshSoakTally {
  std::int64_t pairs = 0, poses = 0;
  std::int64_t meeting = 0, inside = 0, touching = 0;  ///< of the poses, by the loop over all triangles
  std::int64_t certified = 0;                          ///< to the tolerance, or common points proven
  std::int64_t motions = 0, contacts = 0, free = 0, undecided = 0;
  std::int64_t moments = 0;  ///< of motions that were looked at
};

/// Pairs of meshes that are not convex (hollow boxes, plates and needles down to 1e-9, tori, rough spheres,
/// stairs with coplanar faces, loose triangles), as surfaces and as solids, in poses that are random or make
/// faces coplanar: distances and separations, cold and warm, against a loop over all pairs of triangles in
/// quadruple precision. Every pair also moves: times of impact and clearances against that loop at single
/// moments.
class RandomMeshes {
 public:
  explicit RandomMeshes(std::uint64_t seed) : seed_(seed) {}

  static constexpr int kPoses = 50, kMotions = 5, kMoments = 32;

  /// Pair number `number` of this seed: what is false of an answer, or nothing.
  std::optional<std::string> check(std::int64_t number);

  const MeshSoakTally& tally() const noexcept { return tally_; }

 private:
  std::string pose_error(RandomStream& stream, const DrawnMesh& one, const DrawnMesh& two,
                         MeshWarmStart& warm);
  std::string motion_error(RandomStream& stream, const DrawnMesh& one, const DrawnMesh& two);

  std::uint64_t seed_;
  MeshDistanceSolver solver_;
  ContinuousSolver continuous_{3};
  MeshSoakTally tally_;
};

std::string to_string(const MeshSoakTally& tally);

}  // namespace raygauge::soak
