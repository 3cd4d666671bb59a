// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "engine/sets/hull_surface.h"
#include "raygauge/numerics/vector3.h"

namespace raygauge {

/// Which points of a set of R^3 can be highest, for each cell of a cube of directions: each of its six faces
/// is cut into cells × cells squares. A point p is left out of a cell only where another point q is higher at
/// all four corners, by more than rounding errors. As v·(q - p) is linear in v, q is then higher along every
/// v of the cell. The highest point of a list is therefore the highest of all points.
///
/// The cells of a long or flat set are those of v' = Fᵀv, F its isotropic map, in which it is round: v·p =
/// v'·(F⁻¹p). Margins allow for the rounding errors of both.
class DirectionTable {
 public:
  /// Of no points: no list is known.
  DirectionTable() = default;

  /// `points` is 3 × N and finite.
  explicit DirectionTable(const Eigen::Ref<const Eigen::Matrix3Xd>& points, HullSurface surface = {});

  /// The points that may be highest along v and next to it: the list of v's cell. Empty where it was too long
  /// to keep.
  std::span<const std::int32_t> listed(const Vector3& v) const noexcept {
    const Vector3 w = is_mapped_ ? map_.transposed_times(v) : v;
    const List& list = lists_[static_cast<std::size_t>(cell(w, cells_))];
    return {candidates_.data() + list.first, static_cast<std::size_t>(list.count)};
  }

  /// The index of a point that is highest along v, to the rounding errors of v·p; -1 where the list of v's
  /// cell was too long to keep.
  std::int32_t highest(const Vector3& v) const noexcept {
    std::int32_t best = -1;
    double top = -std::numeric_limits<double>::infinity();
    for (const std::int32_t i : listed(v)) {
      const double* p = &points_[4 * static_cast<std::size_t>(i)];
      const double height = v.x * p[0] + v.y * p[1] + v.z * p[2];
      best = height > top ? i : best;
      top = height > top ? height : top;
    }
    return best;
  }

  /// Point i.
  Vector3 point(std::int32_t i) const noexcept {
    const double* p = &points_[4 * static_cast<std::size_t>(i)];
    return {p[0], p[1], p[2]};
  }

  bool empty() const noexcept { return lists_.empty(); }

  /// Of the points' hull; empty where it is not known.
  const HullSurface& surface() const noexcept { return surface_; }

  /// Bytes.
  std::size_t memory() const noexcept {
    return points_.size() * sizeof(double) + lists_.size() * sizeof(List) +
           candidates_.size() * sizeof(std::int32_t) + surface_.memory();
  }

  /// The cell that v belongs to, of 6 cells²; 0 for v = 0 and where v is not finite.
  static int cell(const Vector3& v, int cells) noexcept;

 private:
  struct List {
    std::int32_t first = 0, count = 0;
  };
  class Builder;

  int cells_ = 0;  // along an edge of the cube
  bool is_mapped_ = false;
  Matrix3 map_;                 // F, where is_mapped_
  std::vector<double> points_;  // 4 numbers each: x, y, z and nothing
  std::vector<List> lists_;
  std::vector<std::int32_t> candidates_;
  HullSurface surface_;
};

inline int DirectionTable::cell(const Vector3& v, int cells) noexcept {
  const double ax = std::fabs(v.x), ay = std::fabs(v.y), az = std::fabs(v.z);
  const double largest = std::max({ax, ay, az});
  if (!(largest > 0) || !(largest <= std::numeric_limits<double>::max())) return 0;
  int face = v.x < 0 ? 1 : 0;
  double first = v.y, second = v.z;
  if (ax < largest) {
    first = v.x;
    face = v.y < 0 ? 3 : 2;
    if (ay < largest) {
      second = v.y;
      face = v.z < 0 ? 5 : 4;
    }
  }
  const double half = 0.5 * cells, scale = half / largest;
  const int i = std::clamp(static_cast<int>(first * scale + half), 0, cells - 1);
  const int j = std::clamp(static_cast<int>(second * scale + half), 0, cells - 1);
  return (face * cells + i) * cells + j;
}

}  // namespace raygauge
