// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace raygauge {

/// A point s of a difference D of R^N, and the points of both sets that it is the difference of, which are
/// only combined.
template <int N>
struct HullPoint {
  std::array<double, N> s, a1, a2;
};

/// A simplex of the surface.
template <int N>
struct HullFacet {
  std::array<std::int32_t, N> corner{};
  std::array<std::int32_t, N> neighbour{};  ///< beyond the ridge that lacks corner i
  std::array<double, N> n{};                ///< outward, of length 1 to a few rounding units
  double reach = 0;                         ///< max n·s over the corners
  double offset = 0;       ///< n·x >= offset for every x in the simplex, proven for the n stored
  std::int64_t stamp = 0;  ///< 0: not a facet any more
};

/// The surface of a polytope in R^4 to R^6 whose corners are points of D, each within `error` of one of D:
/// begin() makes a simplex, add() replaces the facets that a new point sees by the cone from it over their
/// rim.
///
/// What it proves needs no exact convexity. Let c be the mean of the first simplex. The facets form a closed
/// surface, whatever is rounded: the cone over the rim of what is taken away has the same rim. It winds once
/// around c at first (modulo 2), for c is proven to be below every facet of the simplex. What a new point
/// changes is the sum of the simplices between it and the facets that it sees. c is not in these: it is
/// proven to be below the planes of all facets, the simplices are above them. So the surface always winds
/// around c. A point around which it winds is in the hull of the corners. So a convex set K with the origin
/// is inside that hull if for every facet h_K(n) < offset: the hull of K and c does not meet the surface.
template <int N>
class InnerHull {
 public:
  using Array = std::array<double, N>;
  using Facet = HullFacet<N>;
  using Point = HullPoint<N>;

  /// The simplex of N + 1 points of length at most `size`. False where it is flat.
  bool begin(const Point* corners, double size, double error);

  /// Adds a point above `facet`. False where rounding hides what it proves: the surface is then of no use.
  bool add(std::int32_t facet, const Point& point);

  /// How far x is above the plane of a facet.
  double above(const Facet& facet, const Array& x) const { return product(facet.n, x) - facet.reach; }

  /// For points of length at most `size`: what is above a plane by no more than this may be in it.
  static constexpr double noise_of(double size) noexcept { return 4 * kProduct * size; }
  double noise() const noexcept { return noise_; }

  const Facet& facet(std::int32_t i) const { return facets_[static_cast<std::size_t>(i)]; }
  const Point& point(std::int32_t i) const { return points_[static_cast<std::size_t>(i)]; }
  std::int32_t facet_count() const { return static_cast<std::int32_t>(facets_.size()); }

  /// The facets made by the last call of begin() or add().
  const std::vector<std::int32_t>& made() const noexcept { return made_; }

  static double product(const Array& a, const Array& b) noexcept {
    double sum = 0;
    for (std::size_t k = 0; k < N; ++k) sum += a[k] * b[k];
    return sum;
  }

 private:
  // What a scalar product of a unit vector may lose, relative to the other factor.
  static constexpr double kProduct = (2 * N + 4) * 0x1p-53;

  // A ridge between a facet that the new point sees and one that it does not.
  struct Ridge {
    std::int32_t seen, hidden;
    std::uint8_t lacks, lacks_of_hidden;  // the corners of either that are not in it
  };

  std::int32_t take_place();
  bool measure(Facet& facet);
  void solve_normal(Facet& facet) const;
  void put_extent(Facet& facet) const;
  bool is_seen(std::int32_t facet, const Array& x);
  bool find_rim(std::int32_t facet, const Array& x);
  bool make_facets(std::int32_t apex);
  bool link(const Ridge& ridge, std::int32_t made, std::int32_t apex);
  Facet& at(std::int32_t i) { return facets_[static_cast<std::size_t>(i)]; }

  std::vector<Point> points_;
  std::vector<Facet> facets_;
  std::vector<std::int64_t>
      mark_;                    // of facets: twice the search that looked at them, 1 more where it is seen
  std::vector<double> height_;  // ... how high the new point is above them
  std::vector<std::int32_t> free_, made_, seen_;
  std::vector<Ridge> rim_;
  std::int64_t stamps_ = 0, searches_ = 0;
  Array center_{};
  double size_ = 0, noise_ = 0, margin_ = 0;
};

extern template class InnerHull<4>;
extern template class InnerHull<5>;
extern template class InnerHull<6>;

}  // namespace raygauge
