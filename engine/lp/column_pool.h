// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/kernels/kernel.h"
#include "engine/numerics/aligned_buffer.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

/// The points of one set that the simplex loop prices: all of them, in place where no scaling is needed, or a
/// growing choice of them, copied and scaled. Points keep their position; the last block is filled up with
/// copies of its last point.
class ColumnPool {
 public:
  /// The points of S to start with: all of them where S is small, in place if `trivial` and else scaled by
  /// `factor` (n powers of two); of a large set a stratified pseudo-random sample, the same for the same
  /// S.size(). `in_single`: the points are wanted in single precision too, where that is worth a copy or S
  /// has one, which makes it small.
  void choose(const PointSet& S, const double* factor, bool trivial, bool in_single);

  /// How many points of S are worth adding at a time.
  static std::ptrdiff_t growth(const PointSet& S);

  /// Appends point `index` of S, unless it is here already: false then. After the last of them, fill_up().
  bool add(const PointSet& S, const double* factor, std::int64_t index);

  /// Repeats the last point where the last block has room.
  void fill_up();

  /// Whether point `index` of S, from which the points were chosen, is here.
  bool holds(std::int64_t index) const noexcept;

  /// Starts an empty set of points that need not belong to a PointSet (general convex sets), of dimension n.
  void clear(int n);
  void add(const double* point);

  bool is_complete() const noexcept { return complete_; }
  std::ptrdiff_t size() const noexcept { return size_; }
  PricedPoints view() const noexcept;

  /// max |coordinate| of the points, scaled as they are: the scale of rounding errors in u·p.
  double magnitude() const noexcept { return magnitude_; }

  /// The smallest index in S, whose points these are, of the point at position i. Compares coordinates: not
  /// for the hot path.
  std::int64_t index_in(const PointSet& S, const double* factor, std::ptrdiff_t i) const noexcept;

  /// Copies the (scaled) point at position i.
  void copy_point(std::ptrdiff_t i, double* out) const noexcept;

 private:
  void take_all(const PointSet& S, const double* factor, bool trivial, bool in_single);
  void round_all();
  void take_sample(const PointSet& S, const double* factor, std::ptrdiff_t blocks);
  void take_blocks(const PointSet& S, const double* factor, std::ptrdiff_t blocks);
  void take_single_points(const PointSet& S, const double* factor);
  void grow_to(std::ptrdiff_t size);
  void forget_marks(std::ptrdiff_t size);
  void mark(std::int64_t index) noexcept;
  void mark_block(std::ptrdiff_t block) noexcept;
  void place_single(std::ptrdiff_t position, const double* slot);
  void place(std::ptrdiff_t position, const double* point, std::ptrdiff_t stride, const double* factor);

  int n_ = 0;
  std::ptrdiff_t size_ = 0;
  bool complete_ = false;
  double magnitude_ = 0;
  const double* blocks_ = nullptr;
  const float* single_blocks_ = nullptr;
  bool in_single_ = false;  // whether single_copy_ holds what copy_ holds
  AlignedBuffer<double> copy_;
  AlignedBuffer<float> single_copy_;
  AlignedBuffer<std::uint64_t> marks_;  // a bit for every point of S: whether it is here
  std::ptrdiff_t marked_size_ = 0;      // S.size(), where there are marks
};

}  // namespace raygauge
