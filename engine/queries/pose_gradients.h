// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/methods/spatial/spatial_distance.h"
#include "engine/queries/body_faces.h"
#include "raygauge/queries/gradient.h"
#include "raygauge/queries/object_distance.h"

namespace raygauge {

/// Gradients by pose, of the answers of other queries. It keeps its memory.
class PoseGradients {
 public:
  /// Of which bodies; they must outlive the calls. `pair`: the same ones where they stand, or nullptr.
  void begin(const Posed& A1, const Posed& A2, const SpatialPair* pair, InstructionSet isa);

  /// Unit vectors beside the normal of a depth that may be as near. To be filled before of_distance(), which
  /// looks at them again.
  std::vector<Vector3>& other_normals() noexcept { return other_normals_; }

  /// Of the signed distance. `by_ball`: in a metric whose ball has one normal at each point.
  void of_distance(const ObjectDistance& answer, bool by_ball, PoseGradient& gradient);

  /// Of a growth distance: A1 is scaled about its centre, or about the origin of the world. `portal`: three
  /// support points of the pair that the ray between the centres leads through at the end, or nullptr.
  void of_growth(const DistanceResult& answer, bool about_origin, const SpatialCombination* portal,
                 PoseGradient& gradient);

 private:
  using Candidate = PoseGradient::Candidate;

  bool bind();
  bool is_rounded() const;
  bool is_half_space(int i) const;
  void add_lowest(const Vector3& by_translation, PoseGradient& gradient);
  int top_of(const Vector3& n) const;
  bool has_one_top(const Vector3& normal) const;
  bool leads_through(const SpatialCombination* portal) const;
  bool find_single_contact(const Vector3& normal, double sigma, const SpatialCombination* portal,
                           Vector3& x) const;
  Candidate candidate(const Vector3& by_translation, const Vector3& x1, const Vector3& x2) const;
  void add_candidates(const Vector3& by_translation, const Vector3& n, int number, PoseGradient& gradient);
  bool find_contact(const Vector3& n);
  bool has_one_normal();

  const Posed* posed_[2] = {nullptr, nullptr};
  const SpatialPair* pair_ = nullptr;
  InstructionSet isa_ = InstructionSet::automatic;
  Vector3 origin_[2];
  double factor_ = 1;  // of the velocities of A1
  std::vector<Vector3> other_normals_, lowest_;
  BodyFaces faces_;
};

}  // namespace raygauge
