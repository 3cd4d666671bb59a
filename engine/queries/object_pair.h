// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/numerics/aligned_buffer.h"
#include "raygauge/sets/convex_set.h"

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

/// A2 - A1 as MinkowskiDifference has it, of two sets that it only looks at for the time of one solve; what
/// it answers is recorded in `pairs`, unless that is null.
class ObjectPair final : public ConvexSet {
 public:
  ObjectPair(const ConvexSet& A2, const ConvexSet& A1, SupportPairs* pairs);

  const ConvexSet& A2() const noexcept { return A2_; }
  const ConvexSet& A1() const noexcept { return A1_; }

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  SupportStructure do_structure() const noexcept override;
  bool do_is_unconditional(double* extent) const override;
  void do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const override;

  const ConvexSet& A2_;
  const ConvexSet& A1_;
  SupportPairs* pairs_;
};

}  // namespace raygauge
