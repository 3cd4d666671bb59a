// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/kernels/kernel.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/queries/facet_walks.h"

namespace raygauge {

/// What is asked of a walk: the gauge at x (n doubles), and the normal of a plane that bounds it, if there is
/// room for it.
struct WalkQuestion {
  const double* x = nullptr;
  WalkAnswer* answer = nullptr;
  double* normal = nullptr;
};

/// A walk over facets for one point, and the proof of what it found.
class PointWalk {
 public:
  static constexpr int kRoom = 1024;  ///< columns that are chosen at most

  explicit PointWalk(const WalkedPoints& points);

  FacetWalk& walk() noexcept { return walk_; }
  const FacetWalk& walk() const noexcept { return walk_; }
  bool arrived() const noexcept { return walk_.end == WalkEnd::arrived; }

  /// Takes a question. False where the length of x is beyond single precision; that it is not closed is the
  /// answer then, as it is until there is another.
  bool begin(const WalkQuestion& question);

  /// What a pass is to look for, once the walk has arrived: points that rounded numbers, whose errors are
  /// bounded, cannot prove to be below the plane. False where single precision can tell nothing.
  bool prepare_pass();

  /// Whether integers tell enough, so that find_beyond is to be asked.
  bool integers_suffice() const noexcept { return integers_suffice_; }

  /// Else the same in single precision, over the first blocks.
  void find_in_single(const FacetWalkPoints& group, std::ptrdiff_t block_count);

  /// What the pass found, evaluated in double: max y·p, and the points beyond the plane.
  void read_pass(const FacetWalkPoints& group);

  /// With the points that the pass found beyond the plane. False if there are none, or after many passes.
  bool go_on(const FacetWalkPoints& group);

  /// Answers the question. Returns whether the bounds are within the tolerance.
  bool answer() const;

 private:
  static constexpr int kPasses = 8;  // for one point

  WalkAnswer bounds() const;
  void round_normal();

  const WalkedPoints* all_;
  WalkQuestion question_;
  int passes_ = 0;
  FacetWalk walk_;
  AlignedBuffer<float> columns_, costs_, along_;
  AlignedBuffer<std::int32_t> places_, numbers_;  // of columns; of the basis, y in pairs, what passes found
  AlignedBuffer<float> small_;                    // R, y, x, b
  AlignedBuffer<double> doubles_;                 // b, and what the walk found
  std::vector<std::int32_t> beyond_;
  bool integers_suffice_ = false;
  double lost_ = 0;     // of a product y·p in single precision
  double error_ = 0;    // and in double
  double support_ = 1;  // at least max y·p
};

}  // namespace raygauge
