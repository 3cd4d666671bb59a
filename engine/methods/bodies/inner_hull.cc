// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/bodies/inner_hull.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/methods/bodies/tuning.h"

namespace raygauge {
namespace {

template <std::size_t N>
std::uint8_t index_of(const std::array<std::int32_t, N>& list, std::int32_t value) {
  std::uint8_t i = 0;
  while (i < N && list[i] != value) ++i;
  return i;
}

}  // namespace

template <int N>
bool InnerHull<N>::begin(const Point* corners, double size, double error) {
  points_.assign(corners, corners + N + 1);
  facets_.clear();
  mark_.clear();
  height_.clear();
  free_.clear();
  made_.clear();
  stamps_ = searches_ = 0;
  size_ = size;
  noise_ = noise_of(size);
  margin_ = noise_ + 4 * error;
  center_ = {};
  for (const Point& p : points_) {
    for (std::size_t k = 0; k < N; ++k) center_[k] += p.s[k] / (N + 1);
  }
  bool solid = true;
  for (std::int32_t i = 0; i <= N; ++i) {
    Facet& facet = at(take_place());
    for (std::int32_t k = 0; k < N; ++k) {
      const std::int32_t corner = k < i ? k : k + 1;
      facet.corner[static_cast<std::size_t>(k)] = corner;
      facet.neighbour[static_cast<std::size_t>(k)] = corner;
    }
    solve_normal(facet);
    put_extent(facet);
    solid = solid && facet.offset - product(facet.n, center_) > margin_;
  }
  return solid;
}

template <int N>
std::int32_t InnerHull<N>::take_place() {
  std::int32_t index = 0;
  if (free_.empty()) {
    index = facet_count();
    facets_.emplace_back();
    mark_.push_back(0);
    height_.push_back(0);
  } else {
    index = free_.back();
    free_.pop_back();
  }
  at(index).stamp = ++stamps_;
  made_.push_back(index);
  return index;
}

// The direction orthogonal to all edges, by elimination with complete pivoting.
template <int N>
void InnerHull<N>::solve_normal(Facet& facet) const {
  std::array<Array, N - 1> row{};
  const Array& base = point(facet.corner[0]).s;
  for (std::size_t i = 0; i + 1 < N; ++i) {
    const Array& s = point(facet.corner[i + 1]).s;
    for (std::size_t k = 0; k < N; ++k) row[i][k] = s[k] - base[k];
  }
  std::array<std::size_t, N> column{};
  for (std::size_t k = 0; k < N; ++k) column[k] = k;
  for (std::size_t step = 0; step + 1 < N; ++step) {
    std::size_t best_row = step, best_column = step;
    for (std::size_t i = step; i + 1 < N; ++i) {
      for (std::size_t k = step; k < N; ++k) {
        if (std::fabs(row[i][column[k]]) > std::fabs(row[best_row][column[best_column]])) {
          best_row = i;
          best_column = k;
        }
      }
    }
    std::swap(row[step], row[best_row]);
    std::swap(column[step], column[best_column]);
    const double pivot = row[step][column[step]];
    if (pivot == 0) continue;
    for (std::size_t i = step + 1; i + 1 < N; ++i) {
      const double factor = row[i][column[step]] / pivot;
      for (std::size_t k = step; k < N; ++k) row[i][column[k]] -= factor * row[step][column[k]];
    }
  }
  facet.n[column[N - 1]] = 1;
  for (std::size_t step = N - 1; step-- > 0;) {
    double sum = 0;
    for (std::size_t k = step + 1; k < N; ++k) sum += row[step][column[k]] * facet.n[column[k]];
    const double pivot = row[step][column[step]];
    facet.n[column[step]] = pivot != 0 ? -sum / pivot : 0.0;
  }
  const double size = std::sqrt(product(facet.n, facet.n));
  const bool inward = product(facet.n, base) < product(facet.n, center_);
  for (double& x : facet.n) x *= (inward ? -1 : 1) / size;
}

template <int N>
void InnerHull<N>::put_extent(Facet& facet) const {
  double least = product(facet.n, point(facet.corner[0]).s);
  facet.reach = least;
  for (std::size_t i = 1; i < N; ++i) {
    const double along = product(facet.n, point(facet.corner[i]).s);
    least = std::min(least, along);
    facet.reach = std::max(facet.reach, along);
  }
  facet.offset = least - kProduct * size_;
}

// For a normal from a neighbour's. False unless c is proven to be below the facet.
template <int N>
bool InnerHull<N>::measure(Facet& facet) {
  const double squares = product(facet.n, facet.n);
  const double scale = squares > 0 ? 1 / std::sqrt(squares) : 0.0;
  for (double& x : facet.n) x *= scale;
  put_extent(facet);
  if (!(facet.reach - facet.offset <= tuned::kUnevenFacet * noise_) || !(scale > 0)) {
    solve_normal(facet);
    put_extent(facet);
  }
  return facet.offset - product(facet.n, center_) > margin_;
}

template <int N>
bool InnerHull<N>::is_seen(std::int32_t i, const Array& x) {
  const auto k = static_cast<std::size_t>(i);
  if (mark_[k] / 2 != searches_) {
    height_[k] = above(facet(i), x);
    mark_[k] = 2 * searches_ + (height_[k] > noise_ ? 1 : 0);
    if (height_[k] > noise_) seen_.push_back(i);
  }
  return mark_[k] % 2 != 0;
}

// False if there is none.
template <int N>
bool InnerHull<N>::find_rim(std::int32_t first, const Array& x) {
  ++searches_;
  rim_.clear();
  seen_.clear();
  is_seen(first, x);
  for (std::size_t next = 0; next < seen_.size(); ++next) {  // NOLINT(modernize-loop-convert): it grows
    const std::int32_t here = seen_[next];
    for (std::size_t i = 0; i < N; ++i) {
      const std::int32_t beyond = facet(here).neighbour[i];
      if (is_seen(beyond, x)) continue;
      rim_.push_back({here, beyond, static_cast<std::uint8_t>(i), index_of(facet(beyond).neighbour, here)});
      if (rim_.back().lacks_of_hidden == N) return false;
    }
  }
  return !rim_.empty();
}

// Over the ridge between f, which the apex sees from the height a > 0, and g, from b <= 0, the normal is
// a n_g - b n_f. The ridges of `seen` facets then hold ~ of the facet over them.
template <int N>
bool InnerHull<N>::make_facets(std::int32_t apex) {
  bool certain = true;
  for (const Ridge& ridge : rim_) {
    const std::int32_t i = take_place();
    Facet& added = at(i);
    Facet &f = at(ridge.seen), &g = at(ridge.hidden);
    const double a = height_[static_cast<std::size_t>(ridge.seen)],
                 b = std::min(height_[static_cast<std::size_t>(ridge.hidden)], 0.0);
    added.corner = f.corner;
    added.corner[ridge.lacks] = apex;
    added.neighbour.fill(-1);
    added.neighbour[ridge.lacks] = ridge.hidden;
    for (std::size_t k = 0; k < N; ++k) added.n[k] = a * g.n[k] - b * f.n[k];
    certain = measure(added) && certain;
    f.neighbour[ridge.lacks] = ~i;
    g.neighbour[ridge.lacks_of_hidden] = i;
  }
  return certain;
}

// Beyond the ridge of a new facet that lacks a corner of the rim is another one, which is over the ridge
// where a walk through the facets seen, around the corners that both have in common, comes out.
template <int N>
bool InnerHull<N>::link(const Ridge& ridge, std::int32_t made, std::int32_t apex) {
  for (std::size_t k = 0; k < N; ++k) {
    if (k == ridge.lacks || facet(made).neighbour[k] >= 0) continue;
    std::int32_t here = ridge.seen, kept = facet(here).corner[ridge.lacks];
    auto leave = static_cast<std::uint8_t>(k);
    std::size_t steps = 0;
    while (facet(here).neighbour[leave] >= 0) {
      const std::int32_t next = facet(here).neighbour[leave];
      const std::uint8_t entry = index_of(facet(next).neighbour, here);
      leave = index_of(facet(next).corner, kept);
      if (entry == N || leave == N || ++steps > seen_.size()) return false;
      kept = facet(next).corner[entry];
      here = next;
    }
    const std::int32_t beyond = ~facet(here).neighbour[leave];
    const std::uint8_t back = index_of(facet(beyond).corner, kept);
    if (beyond == made || kept == apex || back == N || facet(beyond).neighbour[back] >= 0) return false;
    at(made).neighbour[k] = beyond;
    at(beyond).neighbour[back] = made;
  }
  return true;
}

template <int N>
bool InnerHull<N>::add(std::int32_t first, const Point& added) {
  if (!find_rim(first, added.s)) return false;
  made_.clear();
  const auto apex = static_cast<std::int32_t>(points_.size());
  points_.push_back(added);
  bool certain = make_facets(apex);
  for (std::size_t i = 0; i < rim_.size(); ++i) certain = link(rim_[i], made_[i], apex) && certain;
  for (const std::int32_t i : seen_) {
    at(i).stamp = 0;
    free_.push_back(i);
  }
  return certain;
}

template class InnerHull<4>;
template class InnerHull<5>;
template class InnerHull<6>;

}  // namespace raygauge
