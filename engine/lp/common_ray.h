// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <vector>

#include "engine/lp/column_pool.h"
#include "engine/numerics/double_double.h"

namespace raygauge {

/// A point a of A and a point q of Q on one ray from the origin, a = λ q exactly: λ >= d_Q(A), an upper bound
/// for which no equation has to be solved. At a degenerate optimum these two may be all that carries weight,
/// where a basis of n + 1 columns is found last.
class CommonRay {
 public:
  /// The pair with the least λ. O(N log N) operations, O(n) for each point that begins as one of the other
  /// set does, and for each pair whose rays are equal but for rounding.
  void find(const ColumnPool& A, const ColumnPool& Q, int n);
  void forget() noexcept { *this = {}; }

  double upper() const noexcept { return upper_; }  ///< λ, rounded up; +infinity where there is no pair
  double ratio() const noexcept { return ratio_; }  ///< λ, rounded
  std::ptrdiff_t point_of_A() const noexcept { return a_; }  ///< the position of a in its pool

 private:
  // Quotients p_k / max |p_k| of two points on one ray are the same numbers, and round alike.
  struct Direction {
    std::uint64_t key = 0;
    double length = 0;  // max |p_k|
    std::ptrdiff_t point = -1;
    bool operator<(const Direction& other) const noexcept { return key < other.key; }
  };
  static constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15U;
  static std::uint64_t mixed(std::uint64_t key, double quotient) noexcept {
    key = (key ^ std::bit_cast<std::uint64_t>(quotient)) * kOdd;
    return key ^ (key >> 29U);
  }
  static std::vector<std::uint64_t> heads_of(const PricedPoints& points, int n);
  static std::vector<std::uint64_t> common(std::vector<std::uint64_t> a, std::vector<std::uint64_t> q);
  static Direction direction_of(const std::vector<double>& p, std::ptrdiff_t point);
  static bool are_on_one_ray(const std::vector<double>& a, double length_a, const std::vector<double>& q,
                             double length_q);

  double upper_ = std::numeric_limits<double>::infinity();
  double ratio_ = std::numeric_limits<double>::infinity();
  std::ptrdiff_t a_ = -1;
};

inline CommonRay::Direction CommonRay::direction_of(const std::vector<double>& p, std::ptrdiff_t point) {
  Direction direction{kOdd, 0, point};
  for (const double coordinate : p) direction.length = std::max(direction.length, std::fabs(coordinate));
  if (!(direction.length > 0)) return direction;
  for (const double coordinate : p) {
    direction.key = mixed(direction.key, coordinate / direction.length + 0.0);  // -0 becomes 0
  }
  return direction;
}

// Whether a / |a|∞ = q / |q|∞, by products without error.
inline bool CommonRay::are_on_one_ray(const std::vector<double>& a, double length_a,
                                      const std::vector<double>& q, double length_q) {
  constexpr double kNoUnderflow = 0x1p-900;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k] == 0 && q[k] == 0) continue;
    const DoubleDouble left = two_product(a[k], length_q);
    const DoubleDouble right = two_product(q[k], length_a);
    if (left.high != right.high || left.low != right.low) return false;
    if (!(std::fabs(left.high) > kNoUnderflow)) return false;
  }
  return true;
}

// Of the first coordinate that is not zero, and the quotients of those after it by that one.
inline std::vector<std::uint64_t> CommonRay::heads_of(const PricedPoints& points, int n) {
  constexpr std::ptrdiff_t kLooks = 4;
  std::vector<std::uint64_t> heads(static_cast<std::size_t>(points.size));
  for (std::ptrdiff_t i = 0; i < points.size; ++i) {
    const double* p = points.blocks + i / PointSet::kLanes * n * PointSet::kLanes + i % PointSet::kLanes;
    std::ptrdiff_t first = 0;
    while (first < n - 1 && p[first * PointSet::kLanes] == 0) ++first;
    const double length = std::fabs(p[first * PointSet::kLanes]);
    std::uint64_t key = mixed(kOdd, static_cast<double>(first));
    for (std::ptrdiff_t k = first; k < std::min<std::ptrdiff_t>(n, first + kLooks); ++k)
      key = mixed(key, p[k * PointSet::kLanes] / length + 0.0);  // -0 becomes 0
    heads[static_cast<std::size_t>(i)] = key;
  }
  return heads;
}

// Those that both have, in order.
inline std::vector<std::uint64_t> CommonRay::common(std::vector<std::uint64_t> a,
                                                    std::vector<std::uint64_t> q) {
  std::vector<std::uint64_t> both;
  std::sort(a.begin(), a.end());
  std::sort(q.begin(), q.end());
  std::set_intersection(a.begin(), a.end(), q.begin(), q.end(), std::back_inserter(both));
  return both;
}

inline void CommonRay::find(const ColumnPool& A, const ColumnPool& Q, int n) {
  forget();
  const std::vector<std::uint64_t> heads_A = heads_of(A.view(), n);
  const std::vector<std::uint64_t> heads_Q = heads_of(Q.view(), n);
  const std::vector<std::uint64_t> heads = common(heads_A, heads_Q);
  const auto is_common = [&heads](std::uint64_t head) {
    return std::binary_search(heads.begin(), heads.end(), head);
  };
  if (heads.empty()) return;
  std::vector<double> a(static_cast<std::size_t>(n)), q(a.size());
  std::vector<Direction> of_Q;
  for (std::ptrdiff_t j = 0; j < Q.size(); ++j) {
    if (!is_common(heads_Q[static_cast<std::size_t>(j)])) continue;
    Q.copy_point(j, q.data());
    const Direction direction = direction_of(q, j);
    if (direction.length > 0) of_Q.push_back(direction);
  }
  std::sort(of_Q.begin(), of_Q.end());
  for (std::ptrdiff_t i = 0; i < A.size(); ++i) {
    if (!is_common(heads_A[static_cast<std::size_t>(i)])) continue;
    A.copy_point(i, a.data());
    const Direction direction = direction_of(a, i);
    if (!(direction.length > 0)) continue;
    const auto [first, last] = std::equal_range(of_Q.begin(), of_Q.end(), direction);
    for (auto other = first; other != last; ++other) {
      const double ratio = direction.length / other->length;
      if (!(ratio < ratio_)) continue;
      Q.copy_point(other->point, q.data());
      if (!are_on_one_ray(a, direction.length, q, other->length)) continue;
      ratio_ = ratio;
      upper_ = std::nextafter(ratio, std::numeric_limits<double>::infinity());
      a_ = i;
    }
  }
}

}  // namespace raygauge
