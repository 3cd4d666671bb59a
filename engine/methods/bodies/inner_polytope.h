// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/methods/bodies/facet_lanes.h"
#include "engine/numerics/real.h"
#include "raygauge/methods/result.h"

namespace raygauge {

/// A point s of a difference D, and the points of the bodies that it is the difference of, which are only
/// combined; where these are vertices, which: below 0 elsewhere.
template <class Real>
struct DepthPoint {
  BasicVector3<Real> s;
  Vector3 a1, a2;
  Vector3 u;  ///< the direction it was looked for in
  std::int32_t index_1 = -1, index_2 = -1;
};

/// An edge of a facet, from its corner 0, 1 or 2 to the next one: one number.
constexpr std::int32_t edge_of(std::int32_t facet, int corner) { return 4 * facet + corner; }
constexpr std::int32_t facet_at(std::int32_t edge) { return edge >> 2; }
constexpr int corner_at(std::int32_t edge) { return edge & 3; }

/// A triangle of the surface, its corners counterclockwise seen from outside.
template <class Real>
struct DepthFacet {
  std::int32_t corner[3] = {};
  std::int32_t beyond[3] = {};  ///< the edge from corner i to corner i + 1 as that of the facet beyond it
  BasicVector3<Real> n;         ///< outward, of length 1 to a few rounding units
  Real reach{};                 ///< max n·s over the corners
  double offset = 0;            ///< n·x >= offset for every x in the triangle, proven for the n stored
  std::int64_t stamp = 0;       ///< 0: not a facet any more
};

/// The surface of a polytope P whose corners are points of D: begin() makes a tetrahedron, add() replaces the
/// facets that a new point sees by the cone from it over their rim.
///
/// What it proves needs no exact convexity. The facets form a closed oriented surface, whatever is rounded:
/// the cone over the rim of what is taken away has the same rim. Let every facet have offset > 0. Then each
/// triangle is seen from the origin counterclockwise, so the surface winds around the origin at least once,
/// and so it does around every point that is joined to the origin without meeting the surface. A point around
/// which it winds is in the hull of the corners. So a convex set K with the origin is inside that hull, if
/// for every facet h_K(n) < offset.
template <class Real>
class InnerPolytope {
 public:
  using Vector = BasicVector3<Real>;

  /// The tetrahedron of four points, in any order, of length at most `size`. False where it is flat.
  bool begin(const DepthPoint<Real>* corners, double size);

  /// The eight triangles of six points that are about in the directions x, -x, y, -y, z, -z, right-handed.
  /// They need not be convex.
  void begin_octahedron(const DepthPoint<Real>* corners, double size);

  /// The surface that `memory` has, over other corners: find(corner, point) finds each anew. It need not be
  /// convex.
  template <class Find>
  void begin(const DepthMemory& memory, double size, const Find& find) {
    points_.resize(memory.corners().size());
    for (std::size_t i = 0; i < points_.size(); ++i) find(memory.corners()[i], points_[i]);
    join(memory, size);
  }

  bool is_joined() const noexcept { return is_joined_; }

  /// What begin() takes; nothing of a large polytope, or one that has grown over many solves.
  template <class CornerOf>
  void record(const CornerOf& corner_of, DepthMemory& memory) {
    memory.corners_.resize(number(memory));
    if (memory.corners_.empty()) return;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (place_[i] >= 0) memory.corners_[static_cast<std::size_t>(place_[i])] = corner_of(points_[i]);
    }
    record_facets(memory);
  }

  /// Looks at which facets a point above `facet` sees: false where rounding hides it.
  bool look(std::int32_t facet, const DepthPoint<Real>& point);

  /// Of the last look.
  std::span<const std::int32_t> seen() const noexcept { return {seen_.data(), seen_count_}; }

  /// Adds the point of the last look, in place of what it sees.
  void add(const DepthPoint<Real>& point);

  /// How far x is above the plane of a facet.
  Real above(const DepthFacet<Real>& facet, const Vector& x) const { return dot(facet.n, x) - facet.reach; }

  /// For points of length at most `size`: what is above a plane by no more than this may be in it.
  static double noise_of(double size) noexcept;
  double noise() const noexcept { return noise_; }

  const DepthFacet<Real>& facet(std::int32_t i) const { return facets_[static_cast<std::size_t>(i)]; }
  const DepthPoint<Real>& point(std::int32_t i) const { return points_[static_cast<std::size_t>(i)]; }
  std::int32_t facet_count() const { return facet_count_; }

  /// The facets made by the last call of begin() or add().
  const std::vector<std::int32_t>& made() const noexcept { return made_; }

 private:
  struct Edge {
    std::int32_t from, to, beyond;
  };

  std::size_t number(DepthMemory& memory);
  void record_facets(DepthMemory& memory) const;
  void restart(double size);
  void join(const DepthMemory& memory, double size);
  std::int32_t make(std::int32_t a, std::int32_t b, std::int32_t c);
  void make_room(std::size_t facets);
  std::int32_t room_for_facet();
  void measure_made();
  void measure_fan(const Vector& apex);
  void find_rim(std::int32_t facet, const Vector& x);

  std::vector<DepthPoint<Real>> points_;
  std::vector<DepthFacet<Real>> facets_;  // the first facet_count_ of them; the others are room
  std::vector<std::int32_t> free_, made_, seen_;
  std::vector<std::int64_t> mark_;  // of facets: the search that has seen them
  std::vector<Edge> rim_;
  std::vector<std::int32_t> stack_;             // edges to be crossed
  std::size_t rim_count_ = 0, seen_count_ = 0;  // of what the last search has put there
  FacetLanes lanes_;
  std::vector<std::int32_t> place_;  // of what is recorded
  std::int32_t facet_count_ = 0;
  std::int64_t stamps_ = 0, searches_ = 0;
  bool is_joined_ = false;
  double size_ = 0, noise_ = 0;
};

extern template class InnerPolytope<double>;
extern template class InnerPolytope<DoubleDouble>;

}  // namespace raygauge
