// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "raygauge/numerics/instruction_set.h"
#include "raygauge/numerics/vector3.h"

namespace raygauge {

/// The surface of the hull of points of R^3, of triangles whose corners are among them. It proves how deep a
/// point y is in the hull without exact convexity, as InnerPolytope does: where the surface is closed and
/// every triangle is seen counterclockwise from y, it winds around y and around every point nearer to y than
/// all of their planes.
class HullSurface {
 public:
  /// A plane that is the nearest to a point.
  struct Nearest {
    double room = 0;  ///< a ball about the point that is inside the hull, rounding errors covered; 0: none is
    Vector3 normal;   ///< outward, of length 1
  };

  /// None.
  HullSurface() = default;

  /// Of points within `extent` of the origin; `triangles` has three indices each, counterclockwise from
  /// outside. None where they are no closed surface, too many, or so thin that rounding hides their planes.
  HullSurface(const Eigen::Ref<const Eigen::Matrix3Xd>& points, const std::vector<int>& triangles,
              double extent);

  bool empty() const noexcept { return blocks_.empty(); }
  std::size_t memory() const noexcept { return blocks_.size() * sizeof(Block); }

  /// No room where y is outside, or so near the surface that rounding hides the side.
  Nearest nearest(const Vector3& y, InstructionSet isa) const noexcept;

  /// Calls use(normal) for every plane that is at most `most` from y.
  template <class Use>
  void for_near(const Vector3& y, double most, const Use& use) const {
    for (const Block& block : blocks_) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const Vector3 n = block.normal(lane);
        if (block.low[lane] - dot(n, y) <= most) use(n);
      }
    }
  }

 private:
  static constexpr std::size_t kLanes = 8;

  /// Planes n·x = low, at most as high as the corners, in PointSet's layout: as points (n, low) of R^4. Lanes
  /// behind the last triangle repeat it.
  struct alignas(64) Block {
    double x[kLanes], y[kLanes], z[kLanes], low[kLanes];

    Vector3 normal(std::size_t lane) const noexcept { return {x[lane], y[lane], z[lane]}; }
  };

  std::vector<Block> blocks_;
  double extent_ = 0;
  double turned_ = 0;  // how far a normal may be from that of its triangle
};

}  // namespace raygauge
