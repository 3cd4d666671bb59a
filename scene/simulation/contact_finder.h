// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "raygauge/queries/object_distance.h"

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
  std::vector<GapPoint> points;  ///< of the contact patch; none: farther apart than the band
};

/// Finds contacts of convex parts. One a thread: it owns the workspace.
class ContactFinder {
 public:
  /// The nearest or deepest pair of points is among those found, but for `miss` along the normal.
  explicit ContactFinder(double miss = std::numeric_limits<double>::infinity()) : miss_(miss) {}

  /// Points with a gap above `band` are left out. `previous` is a normal to fall back on where the bodies
  /// touch and none is found.
  void find(const Posed& a, const Posed& b, double band, const Eigen::Vector3d& previous,
            PartContact& contact);

 private:
  void find_of_bounded(const Posed& a, const Posed& b, double band, const Eigen::Vector3d& previous,
                       PartContact& contact);

  void add_nearest(const Posed& a, const Posed& b, double band, PartContact& contact);

  double miss_;
  ContactPatchSolver solver_;
  ObjectDistanceSolver distances_;  ///< from half-spaces, which have no patch of their own
};

}  // namespace raygauge
