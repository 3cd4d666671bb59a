// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/bodies/facet_depth.h"

namespace raygauge {

/// The depth of D = c + Σ [-1, 1] g_k, for the difference of two boxes, or of a box and a segment, is one. A
/// facet of it is across two of the g_k, and the depth is the least height of a facet's plane: so the least
/// of
///
///     h_D(±n) = Σ |n·g_k| - |n·c|,     n = g_i × g_j / |g_i × g_j|,
///
/// is the depth, and what a rounded n loses is bounded. Where two of the g_k are parallel but for rounding,
/// one of them is replaced by one that is parallel: D changes by no more than their distance, and a facet
/// across both is across a third one, too.
class ZonotopeDepth : public FacetDepth {
 public:
  static constexpr int kMost = 6;

  void begin(const Vector3& center) noexcept {
    center_ = center;
    count_ = first_count_ = 0;
  }
  /// The next g_k, of at most kMost: first those of the first body.
  void add(const Vector3& half) noexcept { half_[count_++] = half; }
  void add_first(const Vector3& half) noexcept {
    add(half);
    ++first_count_;
  }

  /// `size`: at least |x| for every x of D. False where nothing is proven: D is flat, the origin is outside,
  /// or numbers are out of range.
  bool solve(double size) noexcept;

  /// Of the point  c + Σ s_k g_k  of the nearest facet that is upper() normal(), to rounding, the sum for the
  /// first body. False where faces are parallel and this is not known.
  bool find_contact(Vector3& of_first) const noexcept;

  /// Calls use(n) for the facets that are at most `most` from the origin.
  template <class Use>
  void for_near(double most, const Use& use) const {
    for (int i = 0; i < lanes_count_; ++i)
      if (lanes_.height[i] <= most) use(outward(i));
  }

 private:
  /// One pair of the g_k to a lane, as structure of arrays.
  struct alignas(64) Lanes {
    static constexpr int kCount = 16, kVector = 8;
    using Row = double[kCount];
    Row first[3] = {}, second[3] = {};  ///< zero behind the last pair

    /// Out; `area`: |g_i × g_j| where both are parallel but for rounding, else 0.
    Row n[3], height, lower, area;
  };

  static void measure(const ZonotopeDepth& of, double size, Lanes& lanes) noexcept;
  Vector3 outward(int lane) const noexcept;
  /// The length of the longer of the pair.
  double longer_of(int lane) const noexcept;

  Vector3 center_, half_[kMost];
  int count_ = 0, first_count_ = 0, lanes_count_ = 0, nearest_ = 0;
  Lanes lanes_;
};

}  // namespace raygauge
