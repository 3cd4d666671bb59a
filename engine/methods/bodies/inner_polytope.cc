// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/bodies/inner_polytope.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/methods/bodies/facet_rounding.h"
#include "engine/methods/bodies/tuning.h"
#include "engine/methods/spatial/triangle_normal.h"
#include "engine/numerics/fused.h"

namespace raygauge {
namespace {

constexpr int kNext[3] = {1, 2, 0};

// n is right to 16 rounding units of the product of the triangle's shorter edges. By how much n·s is above 0
// decides whether the triangle is seen counterclockwise; where that is lost in rounding, no offset above 0 is
// proven.
template <class Real>
void measure(const BasicVector3<Real>& a, const BasicVector3<Real>& b, const BasicVector3<Real>& c,
             double size_of_all, DepthFacet<Real>& facet) {
  const Vector3 ab = rounded(b - a), bc = rounded(c - b), ca = rounded(a - c);
  const double of_ab = dot(ab, ab), of_bc = dot(bc, bc), of_ca = dot(ca, ca);
  const double second = std::max(std::min(of_ab, of_bc), std::min(std::max(of_ab, of_bc), of_ca));
  const double edges = std::sqrt(std::min({of_ab, of_bc, of_ca})) * std::sqrt(second);
  const BasicVector3<Real> n = triangle_normal<Real>(a, b, c);
  const double size = length_of(n);
  const double scale = size > 0 ? 1 / size : 0.0;
  facet.n = n * Real{scale};
  const Real of_a = dot(facet.n, a), of_b = dot(facet.n, b), of_c = dot(facet.n, c);
  const auto lower_of = [](const Real& x, const Real& y) { return x < y ? x : y; };
  const auto higher_of = [](const Real& x, const Real& y) { return x < y ? y : x; };
  facet.reach = higher_of(of_a, higher_of(of_b, of_c));
  const double least = rounded(lower_of(of_a, lower_of(of_b, of_c)));
  facet.offset = least - kFacetProduct<Real> * size_of_all - std::fabs(least) * 0x1p-52;
  const double needed = (kFacetEdges<Real> * edges * scale + kFacetProduct<Real>)*size_of_all;
  if (!(size > kLeastFacetNormal && least > needed)) facet.offset = std::min(facet.offset, 0.0);
}

// Of one lane.
void read(const FacetLanes& lanes, std::size_t lane, DepthFacet<double>& facet) {
  facet.n = {lanes.n[0][lane], lanes.n[1][lane], lanes.n[2][lane]};
  facet.reach = lanes.reach[lane];
  facet.offset = lanes.offset[lane];
}

}  // namespace

template <class Real>
double InnerPolytope<Real>::noise_of(double size) noexcept {
  return 4 * kFacetProduct<Real> * size;
}

template <class Real>
void InnerPolytope<Real>::restart(double size) {
  facet_count_ = 0;
  free_.clear();
  made_.clear();
  stamps_ = searches_ = 0;
  rim_count_ = seen_count_ = 0;
  size_ = size;
  noise_ = noise_of(size);
  is_joined_ = false;
  make_room(8);
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
    // The edges of the facet beyond are the same ones in the opposite order.
    facet.beyond[0] = edge_of(i ^ (is_even ? 1 : 2), 2);
    facet.beyond[1] = edge_of(i ^ 4, 1);
    facet.beyond[2] = edge_of(i ^ (is_even ? 2 : 1), 0);
  }
  measure_made();
}

template <class Real>
void InnerPolytope<Real>::join(const DepthMemory& memory, double size) {
  restart(size);
  is_joined_ = true;
  const std::size_t count = memory.facets().size();
  make_room(count);
  facet_count_ = static_cast<std::int32_t>(count);
  made_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::copy_n(memory.facets()[i].corner.begin(), 3, facets_[i].corner);
    std::copy_n(memory.facets()[i].beyond.begin(), 3, facets_[i].beyond);
    facets_[i].stamp = ++stamps_;
    mark_[i] = 0;
    made_[i] = static_cast<std::int32_t>(i);
  }
  measure_made();
}

// What is recorded gets its place. The number of corners; 0 where nothing is.
template <class Real>
std::size_t InnerPolytope<Real>::number(DepthMemory& memory) {
  memory.facets_.clear();
  place_.assign(points_.size(), -1);
  std::int64_t count_of_facets = 0;
  const auto count_of_all = static_cast<std::size_t>(facet_count_);
  for (std::size_t i = 0; i < count_of_all; ++i) mark_[i] = facets_[i].stamp > 0 ? count_of_facets++ : -1;
  std::int32_t corners = 0;
  for (const DepthFacet<Real>& facet : std::span(facets_).first(count_of_all)) {
    for (int k = 0; facet.stamp > 0 && k < 3; ++k) {
      std::int32_t& place = place_[static_cast<std::size_t>(facet.corner[k])];
      if (place < 0) place = corners++;
    }
  }
  const auto count = static_cast<std::size_t>(corners);
  if (!is_joined_) memory.least_corners_ = count;
  const double grown = tuned::kGrownPolytope * static_cast<double>(memory.least_corners_);
  return corners <= tuned::kCornersWorthRecording && corners <= grown ? count : 0;
}

template <class Real>
void InnerPolytope<Real>::record_facets(DepthMemory& memory) const {
  const auto count_of_all = static_cast<std::size_t>(facet_count_);
  memory.facets_.reserve(count_of_all);  // all or none, should memory end
  for (const DepthFacet<Real>& from : std::span(facets_).first(count_of_all)) {
    if (from.stamp == 0) continue;
    DepthMemory::Facet& facet = memory.facets_.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      facet.corner[k] = static_cast<std::uint8_t>(place_[static_cast<std::size_t>(from.corner[k])]);
      const auto place = static_cast<std::int32_t>(mark_[static_cast<std::size_t>(facet_at(from.beyond[k]))]);
      facet.beyond[k] = static_cast<std::uint16_t>(edge_of(place, corner_at(from.beyond[k])));
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
  constexpr std::int32_t kBeyond[4][3] = {{edge_of(1, 0), edge_of(2, 0), edge_of(3, 0)},
                                          {edge_of(0, 0), edge_of(3, 2), edge_of(2, 1)},
                                          {edge_of(0, 1), edge_of(1, 2), edge_of(3, 1)},
                                          {edge_of(0, 2), edge_of(2, 2), edge_of(1, 1)}};
  for (std::size_t i = 0; i < 4; ++i) std::copy_n(kBeyond[i], 3, facets_[i].beyond);
  return true;
}

// Those that were made, eight at a time in doubles.
template <class Real>
void InnerPolytope<Real>::measure_made() {
  if constexpr (!kIsDouble<Real>) {
    for (const std::int32_t i : made_) {
      DepthFacet<Real>& facet = facets_[static_cast<std::size_t>(i)];
      measure(point(facet.corner[0]).s, point(facet.corner[1]).s, point(facet.corner[2]).s, size_, facet);
    }
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
      for (std::size_t lane = 0; lane < count; ++lane)
        read(lanes_, lane, facets_[static_cast<std::size_t>(made_[first + lane])]);
    }
  }
}

// The same of those from the edges of the rim to a new corner.
template <class Real>
void InnerPolytope<Real>::measure_fan(const Vector& apex) {
  constexpr std::size_t kCount = FacetLanes::kCount;
  if constexpr (kIsDouble<Real>) {
    if (rim_count_ <= kCount) {
      const Vector3* corner[kCount + 1];
      for (std::size_t lane = 0; lane <= kCount; ++lane)
        corner[lane] = &point(rim_[lane < rim_count_ ? lane : 0].from).s;
      measure_fan_of_facets(size_, corner, apex, lanes_);
      for (std::size_t lane = 0; lane < rim_count_; ++lane)
        read(lanes_, lane, facets_[static_cast<std::size_t>(made_[lane])]);
      return;
    }
  }
  measure_made();
}

// For so many more.
template <class Real>
void InnerPolytope<Real>::make_room(std::size_t facets) {
  const std::size_t needed = static_cast<std::size_t>(facet_count_) + facets;
  if (needed <= facets_.size()) return;
  mark_.resize(2 * needed);
  facets_.resize(2 * needed);
}

template <class Real>
std::int32_t InnerPolytope<Real>::room_for_facet() {
  if (free_.empty()) {
    mark_[static_cast<std::size_t>(facet_count_)] = 0;
    return facet_count_++;
  }
  const std::int32_t index = free_.back();
  free_.pop_back();
  return index;
}

template <class Real>
std::int32_t InnerPolytope<Real>::make(std::int32_t a, std::int32_t b, std::int32_t c) {
  const std::int32_t index = room_for_facet();
  DepthFacet<Real>& facet = facets_[static_cast<std::size_t>(index)];
  facet.corner[0] = a;
  facet.corner[1] = b;
  facet.corner[2] = c;
  facet.stamp = ++stamps_;
  made_.push_back(index);
  return index;
}

// The rim of the facets that x sees, in order, by walking around them; and these facets. Of F facets the
// whole surface has 3 F/2 edges.
template <class Real>
void InnerPolytope<Real>::find_rim(std::int32_t first, const Vector& x) {
  const std::size_t most = 2 * static_cast<std::size_t>(facet_count_) + 3;
  if (stack_.size() < most) {
    stack_.resize(2 * most);
    seen_.resize(2 * most);
    rim_.resize(2 * most);
  }
  const std::int64_t search = ++searches_;
  std::int64_t* const mark = mark_.data();
  std::int32_t *const bottom = stack_.data(), *top = bottom, *seen = seen_.data();
  Edge* rim = rim_.data();
  const auto enter = [&](std::int32_t i) {
    mark[i] = search;
    *seen++ = i;
  };
  enter(first);
  for (const int corner : {2, 1, 0}) *top++ = edge_of(first, corner);
  while (top != bottom) {
    const std::int32_t edge = *--top;
    const DepthFacet<Real>& here = facet(facet_at(edge));
    const std::int32_t back = here.beyond[corner_at(edge)], beyond = facet_at(back);
    if (mark[beyond] == search) continue;
    if (!(high(above(facet(beyond), x)) > noise_)) {
      *rim++ = {here.corner[corner_at(edge)], here.corner[kNext[corner_at(edge)]], back};
      continue;
    }
    enter(beyond);
    const int next = kNext[corner_at(back)];
    *top++ = edge_of(beyond, kNext[next]);
    *top++ = edge_of(beyond, next);
  }
  seen_count_ = static_cast<std::size_t>(seen - seen_.data());
  rim_count_ = static_cast<std::size_t>(rim - rim_.data());
}

template <class Real>
RAYGAUGE_FUSED bool InnerPolytope<Real>::look(std::int32_t facet, const DepthPoint<Real>& point) {
  find_rim(facet, point.s);
  bool is_loop = rim_count_ >= 3;
  for (std::size_t i = 0; i < rim_count_ && is_loop; ++i)
    is_loop = rim_[i].to == rim_[i + 1 < rim_count_ ? i + 1 : 0].from;
  return is_loop;
}

// The places of the facets that are seen are taken first.
template <class Real>
RAYGAUGE_FUSED void InnerPolytope<Real>::add(const DepthPoint<Real>& added) {
  const auto apex = static_cast<std::int32_t>(points_.size());
  points_.push_back(added);
  for (std::size_t k = rim_count_; k < seen_count_; ++k) {
    facets_[static_cast<std::size_t>(seen_[k])].stamp = 0;
    free_.push_back(seen_[k]);
  }
  made_.resize(rim_count_);
  make_room(rim_count_);
  for (std::size_t k = 0; k < rim_count_; ++k) made_[k] = k < seen_count_ ? seen_[k] : room_for_facet();
  for (std::size_t k = 0; k < rim_count_; ++k) {
    const Edge& edge = rim_[k];
    DepthFacet<Real>& facet = facets_[static_cast<std::size_t>(made_[k])];
    facet.corner[0] = edge.from;
    facet.corner[1] = edge.to;
    facet.corner[2] = apex;
    facet.stamp = ++stamps_;
    facet.beyond[0] = edge.beyond;
    facet.beyond[1] = edge_of(made_[k + 1 < rim_count_ ? k + 1 : 0], 2);
    facet.beyond[2] = edge_of(made_[k > 0 ? k - 1 : rim_count_ - 1], 1);
    facets_[static_cast<std::size_t>(facet_at(edge.beyond))].beyond[corner_at(edge.beyond)] =
        edge_of(made_[k], 0);
  }
  measure_fan(added.s);
}

template class InnerPolytope<double>;
template class InnerPolytope<DoubleDouble>;

}  // namespace raygauge
