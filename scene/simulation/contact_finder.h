// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "raygauge/queries/object_distance.h"
#include "raygauge/scene/placement.h"

namespace raygauge {

/// A point where two bodies may touch, and how far they are apart there along the normal.
struct GapPoint {
  Eigen::Vector3d at;
  double gap = 0;
};

/// What two convex parts look like from where they are nearest, or deepest in each other.
struct PartContact {
  double lower = 0;              ///< certified: their signed distance is at least this ...
  double overlap = 0;            ///< ... and at most -overlap, where that is above 0
  Eigen::Vector3d normal;        ///< of length 1, from part b to part a
  std::vector<GapPoint> points;  ///< corners of the common face, eight at most, none deeper than `lower`
};

/// Finds contacts of convex parts. One a thread: it owns the workspace.
class ContactFinder {
 public:
  /// In R^2 or R^3.
  explicit ContactFinder(int dimension);

  /// Points with a gap above lower + band are left out. `previous` is a normal to fall back on where the
  /// bodies touch and none is found.
  void find(const Posed& a, const Posed& b, double band, const Eigen::Vector3d& previous, WarmStart& warm,
            PartContact& contact);

 private:
  using Corners = std::vector<Eigen::Vector3d>;  ///< in the frame: along two tangents, and the normal

  void measure(const Posed& a, const Posed& b, const Eigen::Vector3d& previous, WarmStart& warm,
               PartContact& contact);
  Corners face_of(const Posed& S, double sign) const;
  void add_common_face(const Corners& face_a, const Corners& face_b, double band, PartContact& contact) const;

  int n_;
  std::shared_ptr<const ConvexSet> ball_;
  ObjectDistanceSolver solver_;
  Eigen::Matrix3d frame_;    // rows: tangents, normal
  Eigen::Vector3d witness_;  // in space
};

}  // namespace raygauge
