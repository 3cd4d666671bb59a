// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/bodies/inner_polytope.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/methods/bodies/facet_rounding.h"
#include "engine/methods/spatial/triangle_normal.h"
#include "engine/numerics/fused.h"

namespace raygauge {
namespace {

constexpr int kNext[3] = {1, 2, 0};

}  // namespace

template <class Real>
double InnerPolytope<Real>::noise_of(double size) noexcept {
  return 4 * kFacetProduct<Real> * size;
}

template <class Real>
void InnerPolytope<Real>::restart(double size) {
  facets_.clear();
  free_.clear();
  made_.clear();
  mark_.clear();
  stamps_ = searches_ = 0;
  size_ = size;
  noise_ = noise_of(size);
  is_joined_ = false;
}

// Facet i is on the side of -x, -y, -z if bit 2, 1, 0 of i is set.
template <class Real>
void InnerPolytope<Real>::begin_octahedron(const DepthPoint<Real>* corners, double size) {
  points_.assign(corners, corners + 6);
  restart(size);
  for (std::int32_t i = 0; i < 8; ++i) {
    const std::int32_t x = i >> 2, y = 2 + (i >> 1 & 1), z = 4 + (i & 1);
    const bool is_even = (x + y + z) % 2 == 0;
    DepthFacet<Real>& facet = facets_[static_cast<std::size_t>(make(x, is_even ? y : z, is_even ? z : y))];
    facet.neighbour[0] = i ^ (is_even ? 1 : 2);
    facet.neighbour[1] = i ^ 4;
    facet.neighbour[2] = i ^ (is_even ? 2 : 1);
  }
  measure_made();
}

template <class Real>
void InnerPolytope<Real>::join(const DepthMemory& memory, double size) {
  restart(size);
  is_joined_ = true;
  const std::size_t count = memory.facets().size();
  facets_.resize(count);
  made_.resize(count);
  mark_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::copy_n(memory.facets()[i].corner.begin(), 3, facets_[i].corner);
    std::copy_n(memory.facets()[i].neighbour.begin(), 3, facets_[i].neighbour);
    facets_[i].stamp = ++stamps_;
    made_[i] = static_cast<std::int32_t>(i);
  }
  measure_made();
}

// What is recorded gets its place. The number of corners; 0 where nothing is.
template <class Real>
std::size_t InnerPolytope<Real>::number(DepthMemory& memory) {
  constexpr std::int32_t kMostCorners = 127;  // of which a closed surface makes 250 facets
  memory.facets_.clear();
  place_.assign(points_.size(), -1);
  std::int64_t facets = 0;
  for (std::size_t i = 0; i < facets_.size(); ++i) mark_[i] = facets_[i].stamp > 0 ? facets++ : -1;
  std::int32_t corners = 0;
  for (const DepthFacet<Real>& facet : facets_) {
    for (int k = 0; facet.stamp > 0 && k < 3; ++k) {
      std::int32_t& place = place_[static_cast<std::size_t>(facet.corner[k])];
      if (place < 0) place = corners++;
    }
  }
  const auto count = static_cast<std::size_t>(corners);
  if (!is_joined_) memory.least_corners_ = count;
  return corners <= kMostCorners && 4 * count <= 5 * memory.least_corners_ ? count : 0;
}

template <class Real>
void InnerPolytope<Real>::record_facets(DepthMemory& memory) const {
  const auto byte = [](auto number) { return static_cast<std::uint8_t>(number); };
  memory.facets_.reserve(facets_.size());  // all or none, should memory end
  for (const DepthFacet<Real>& from : facets_) {
    if (from.stamp == 0) continue;
    DepthMemory::Facet& facet = memory.facets_.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      facet.corner[k] = byte(place_[static_cast<std::size_t>(from.corner[k])]);
      facet.neighbour[k] = byte(mark_[static_cast<std::size_t>(from.neighbour[k])]);
    }
  }
}

template <class Real>
bool InnerPolytope<Real>::begin(const DepthPoint<Real>* corners, double size) {
  points_.assign(corners, corners + 4);
  restart(size);
  const Vector& a = points_[0].s;
  const Vector n = triangle_normal<Real>(a, points_[1].s, points_[2].s);
  const Real height = dot(n, points_[3].s - a);
  if (!(std::fabs(high(height)) > noise_ * length_of(n))) return false;
  if (high(height) > 0) std::swap(points_[1], points_[2]);
  // The fourth corner is below the facet 0 1 2.
  make(0, 1, 2);
  make(1, 0, 3);
  make(2, 1, 3);
  make(0, 2, 3);
  measure_made();
  constexpr std::int32_t kNeighbours[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  for (std::size_t i = 0; i < 4; ++i) std::copy_n(kNeighbours[i], 3, facets_[i].neighbour);
  return true;
}

// n is right to 16 rounding units of the product of the triangle's shorter edges. By how much n·s is above 0
// decides whether the triangle is seen counterclockwise; where that is lost in rounding, no offset above 0 is
// proven.
template <class Real>
void InnerPolytope<Real>::measure(DepthFacet<Real>& facet) const {
  const Vector &a = point(facet.corner[0]).s, &b = point(facet.corner[1]).s, &c = point(facet.corner[2]).s;
  const Vector3 ab = rounded(b - a), bc = rounded(c - b), ca = rounded(a - c);
  const double of_ab = dot(ab, ab), of_bc = dot(bc, bc), of_ca = dot(ca, ca);
  const double second = std::max(std::min(of_ab, of_bc), std::min(std::max(of_ab, of_bc), of_ca));
  const double edges = std::sqrt(std::min({of_ab, of_bc, of_ca})) * std::sqrt(second);
  const Vector n = triangle_normal<Real>(a, b, c);
  const double size = length_of(n);
  const double scale = size > 0 ? 1 / size : 0.0;
  facet.n = n * Real{scale};
  const Real of_a = dot(facet.n, a), of_b = dot(facet.n, b), of_c = dot(facet.n, c);
  const auto lower_of = [](const Real& x, const Real& y) { return x < y ? x : y; };
  const auto higher_of = [](const Real& x, const Real& y) { return x < y ? y : x; };
  facet.reach = higher_of(of_a, higher_of(of_b, of_c));
  const double least = rounded(lower_of(of_a, lower_of(of_b, of_c)));
  facet.offset = least - kFacetProduct<Real> * size_ - std::fabs(least) * 0x1p-52;
  const double needed = (kFacetEdges<Real> * edges * scale + kFacetProduct<Real>)*size_;
  if (!(size > kLeastFacetNormal && least > needed)) facet.offset = std::min(facet.offset, 0.0);
}

// Those that were made, eight at a time in doubles.
template <class Real>
void InnerPolytope<Real>::measure_made() {
  if constexpr (!kIsDouble<Real>) {
    for (const std::int32_t i : made_) measure(facets_[static_cast<std::size_t>(i)]);
  } else {
    constexpr std::size_t kCount = FacetLanes::kCount;
    for (std::size_t first = 0; first < made_.size(); first += kCount) {
      const std::size_t count = std::min(kCount, made_.size() - first);
      for (std::size_t lane = 0; lane < count; ++lane) {
        const DepthFacet<Real>& facet = this->facet(made_[first + lane]);
        for (int c = 0; c < 3; ++c) {
          const Vector& corner = point(facet.corner[c]).s;
          lanes_.corner[c][0][lane] = corner.x;
          lanes_.corner[c][1][lane] = corner.y;
          lanes_.corner[c][2][lane] = corner.z;
        }
      }
      measure_facets(size_, lanes_);
      for (std::size_t lane = 0; lane < count; ++lane) {
        DepthFacet<Real>& facet = facets_[static_cast<std::size_t>(made_[first + lane])];
        facet.n = {lanes_.n[0][lane], lanes_.n[1][lane], lanes_.n[2][lane]};
        facet.reach = lanes_.reach[lane];
        facet.offset = lanes_.offset[lane];
      }
    }
  }
}

template <class Real>
std::int32_t InnerPolytope<Real>::make(std::int32_t a, std::int32_t b, std::int32_t c) {
  std::int32_t index = 0;
  if (free_.empty()) {
    index = facet_count();
    facets_.emplace_back();
    mark_.push_back(0);
  } else {
    index = free_.back();
    free_.pop_back();
  }
  DepthFacet<Real>& facet = facets_[static_cast<std::size_t>(index)];
  facet.corner[0] = a;
  facet.corner[1] = b;
  facet.corner[2] = c;
  facet.stamp = ++stamps_;
  made_.push_back(index);
  return index;
}

template <class Real>
bool InnerPolytope<Real>::sees(std::int32_t i, const Vector& x) const {
  return high(above(facet(i), x)) > noise_;
}

// The rim of the facets that x sees, in order, by walking around them; and these facets.
template <class Real>
void InnerPolytope<Real>::find_rim(std::int32_t first, const Vector& x) {
  ++searches_;
  rim_.clear();
  seen_.assign(1, first);
  mark_[static_cast<std::size_t>(first)] = searches_;
  stack_.assign(1, {first, 0, 3});
  while (!stack_.empty()) {
    Visit& visit = stack_.back();
    if (visit.left == 0) {
      stack_.pop_back();
      continue;
    }
    const int edge = visit.edge;
    visit.edge = kNext[edge];
    --visit.left;
    const DepthFacet<Real>& here = facet(visit.facet);
    const std::int32_t beyond = here.neighbour[edge], from = here.corner[edge], to = here.corner[kNext[edge]];
    const bool known = mark_[static_cast<std::size_t>(beyond)] == searches_;
    if (known) continue;
    if (!sees(beyond, x)) {
      rim_.push_back({from, to, beyond});
      continue;
    }
    mark_[static_cast<std::size_t>(beyond)] = searches_;
    seen_.push_back(beyond);
    const DepthFacet<Real>& other = facet(beyond);
    int entry = 0;
    while (entry < 2 && other.corner[entry] != to) ++entry;
    stack_.push_back({beyond, kNext[entry], 2});
  }
}

template <class Real>
bool InnerPolytope<Real>::is_loop() const {
  if (rim_.size() < 3) return false;
  for (std::size_t i = 0; i < rim_.size(); ++i) {
    if (rim_[i].to != rim_[i + 1 < rim_.size() ? i + 1 : 0].from) return false;
  }
  return true;
}

template <class Real>
void InnerPolytope<Real>::link(std::int32_t i, std::int32_t from, std::int32_t to, std::int32_t neighbour) {
  DepthFacet<Real>& facet = facets_[static_cast<std::size_t>(i)];
  for (int e = 0; e < 3; ++e) {
    if (facet.corner[e] == from && facet.corner[kNext[e]] == to) facet.neighbour[e] = neighbour;
  }
}

template <class Real>
RAYGAUGE_FUSED bool InnerPolytope<Real>::add(std::int32_t first, const DepthPoint<Real>& added) {
  find_rim(first, added.s);
  if (!is_loop()) return false;
  const auto apex = static_cast<std::int32_t>(points_.size());
  points_.push_back(added);
  for (const std::int32_t i : seen_) {
    facets_[static_cast<std::size_t>(i)].stamp = 0;
    free_.push_back(i);
  }
  made_.clear();
  for (const Edge& edge : rim_) {
    const std::int32_t i = make(edge.from, edge.to, apex);
    facets_[static_cast<std::size_t>(i)].neighbour[0] = edge.beyond;
    link(edge.beyond, edge.to, edge.from, i);
  }
  measure_made();
  for (std::size_t k = 0; k < made_.size(); ++k) {
    DepthFacet<Real>& facet = facets_[static_cast<std::size_t>(made_[k])];
    facet.neighbour[1] = made_[k + 1 < made_.size() ? k + 1 : 0];
    facet.neighbour[2] = made_[k > 0 ? k - 1 : made_.size() - 1];
  }
  return true;
}

template class InnerPolytope<double>;
template class InnerPolytope<DoubleDouble>;

}  // namespace raygauge
