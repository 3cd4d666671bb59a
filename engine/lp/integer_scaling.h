// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "raygauge/sets/point_set.h"

namespace raygauge {

/// Powers of two that make every coordinate of a pair of point sets an integer: with
///
///     a'_k = 2^(row_k + lift) a_k,      q'_k = 2^row_k q_k,      d_Q'(A') = 2^lift d_Q(A).
///
/// The rows and the lift are chosen for few bits in all: determinants grow with the sum of the rows' lengths.
class IntegerScaling {
 public:
  void compute(const PointSet& A, const PointSet& Q);

  std::int64_t shift_A(int k) const noexcept { return row_[static_cast<std::size_t>(k)] + lift_; }
  std::int64_t shift_Q(int k) const noexcept { return row_[static_cast<std::size_t>(k)]; }
  std::int64_t lift() const noexcept { return lift_; }

  /// Bits of a coordinate, the mean of the rows.
  double mean_bits() const noexcept { return mean_bits_; }

 private:
  // Exponents of the highest and of the lowest bit that is set in coordinate k of any point.
  struct Bits {
    std::int64_t low = 0;
    std::int64_t high = 0;
    bool any = false;
  };

  static void scan(const PointSet& S, std::vector<Bits>& bits);
  std::int64_t length(std::int64_t lift) const;
  std::int64_t row_length(const Bits& a, const Bits& q, std::int64_t lift, std::int64_t* lowest) const;

  std::vector<Bits> bits_A_;
  std::vector<Bits> bits_Q_;
  std::vector<std::int64_t> row_;
  std::int64_t lift_ = 0;
  double mean_bits_ = 0;
};

}  // namespace raygauge
