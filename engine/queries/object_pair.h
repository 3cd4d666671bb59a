// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/numerics/aligned_buffer.h"
#include "raygauge/sets/minkowski_view.h"

namespace raygauge {

/// The support points a1 of A1 that belong to support points a2 - a1 of the difference of two objects.
class SupportPairs {
 public:
  void clear(int n) noexcept {
    n_ = n;
    count_ = 0;
  }
  void add(const double* difference, const double* a1);

  /// The a1 of the difference nearest to this one, which is a recorded one, perhaps after a multiplication by
  /// one; nullptr if nothing was recorded.
  const double* partner(const double* difference) const;

 private:
  int n_ = 0;
  std::ptrdiff_t count_ = 0;
  AlignedBuffer<double> pairs_;  // difference, then a1
};

/// A2 - A1 as MinkowskiDifference has it, of two sets that it only looks at for the time of one solve.
///
/// Closest points of A1 and A2 need the parts of each support point of the difference. So a pair with `pairs`
/// writes them there whenever it is asked: such a pair is one solve's, and not shared between threads as
/// other sets may be.
class ObjectPair final : public MinkowskiView {
 public:
  /// Throws DimensionMismatchError. `pairs` may be null.
  ObjectPair(const ConvexSet& A2, const ConvexSet& A1, SupportPairs* pairs);

  const ConvexSet& A2() const noexcept { return first(); }
  const ConvexSet& A1() const noexcept { return second(); }

 private:
  bool records_parts() const noexcept override { return pairs_ != nullptr; }
  void record_parts(const double* point, const double* of_T) const override { pairs_->add(point, of_T); }

  SupportPairs* pairs_;
};

}  // namespace raygauge
