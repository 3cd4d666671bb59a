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
  /// Of which bodies; they must outlive the calls. `pair`: the same ones where they stand, or nullptr. `end`:
  /// the support points of the pair that a solve of it ended with, or nullptr.
  void begin(const Posed& A1, const Posed& A2, const SpatialPair* pair, const SpatialCombination* end,
             InstructionSet isa) noexcept {
    posed_[0] = &A1;
    posed_[1] = &A2;
    pair_ = pair;
    end_ = end;
    isa_ = isa;
    factor_ = 1;
    other_normals_.clear();
  }

  /// Unit vectors beside the normal of a depth that may be as near. To be filled before of_distance(), which
  /// looks at them again.
  std::vector<Vector3>& other_normals() noexcept { return other_normals_; }

  /// Of the signed distance. `by_ball`: in a metric whose ball has one normal at each point.
  void of_distance(const ObjectDistance& answer, bool by_ball, PoseGradient& gradient);

  /// Of a growth distance: A1 is scaled about its centre, or about the origin of the world. What the solve
  /// ended with are three support points that the ray between the centres leads through.
  void of_growth(const DistanceResult& answer, bool about_origin, PoseGradient& gradient);

 private:
  using Candidate = PoseGradient::Candidate;

  bool bind();
  bool is_half_space(int i) const;
  void add_lowest(const Vector3& by_translation, PoseGradient& gradient);
  bool is_tower(int i, const Vector3& n, double tilt) const;
  int top_of(const Vector3& n, double tilt) const;
  bool has_one_contact(const Vector3& normal) const;
  bool is_second_simpler() const;
  bool leads_through_portal() const;
  double tilt_of(const DistanceResult& growth) const;
  bool find_single_contact(const Vector3& normal, double sigma, double tilt, Vector3& x) const;
  void put(const Vector3& by_translation, const Vector3& x1, const Vector3& x2, Twist& body_1,
           Twist& body_2) const;
  void of_faces(const ObjectDistance& answer, const Vector3& by_translation, PoseGradient& gradient);
  Candidate candidate(const Vector3& by_translation, const Vector3& x1, const Vector3& x2) const;
  void add_candidates(const Vector3& by_translation, int number, PoseGradient& gradient);
  bool find_contact(const Vector3& n, double tilt);
  bool has_one_normal();

  const Posed* posed_[2] = {nullptr, nullptr};
  const SpatialPair* pair_ = nullptr;
  const SpatialCombination* end_ = nullptr;
  InstructionSet isa_ = InstructionSet::automatic;
  double factor_ = 1;  // of the velocities of A1
  std::vector<Vector3> other_normals_, lowest_;
  BodyFaces faces_;
};

}  // namespace raygauge
