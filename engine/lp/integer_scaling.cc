// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/integer_scaling.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace raygauge {
namespace {

constexpr int kDigits = std::numeric_limits<double>::digits;

int lowest_bit(double value) {
  int exponent = 0;
  const double mantissa = std::ldexp(std::frexp(std::fabs(value), &exponent), kDigits);
  return exponent - kDigits + std::countr_zero(static_cast<std::uint64_t>(mantissa));
}

}  // namespace

void IntegerScaling::scan(const PointSet& S, std::vector<Bits>& bits) {
  const int n = S.dimension();
  bits.assign(static_cast<std::size_t>(n), {});
  for (int k = 0; k < n; ++k) {
    const double largest = S.coordinate_magnitude()[k];
    if (largest > 0) {
      const int top = std::ilogb(largest);
      bits[static_cast<std::size_t>(k)] = {top, top, true};
    }
  }
  for (std::ptrdiff_t b = 0; b < S.block_count(); ++b) {
    for (int k = 0; k < n; ++k) {
      Bits& row = bits[static_cast<std::size_t>(k)];
      const double* value = S.data() + (b * n + k) * PointSet::kLanes;
      for (int lane = 0; lane < PointSet::kLanes; ++lane) {
        if (value[lane] != 0) row.low = std::min<std::int64_t>(row.low, lowest_bit(value[lane]));
      }
    }
  }
}

std::int64_t IntegerScaling::row_length(const Bits& a, const Bits& q, std::int64_t lift,
                                        std::int64_t* lowest) const {
  *lowest = a.any && q.any ? std::min(a.low + lift, q.low) : (a.any ? a.low + lift : q.low);
  const std::int64_t highest =
      a.any && q.any ? std::max(a.high + lift, q.high) : (a.any ? a.high + lift : q.high);
  return highest - *lowest;
}

std::int64_t IntegerScaling::length(std::int64_t lift) const {
  std::int64_t sum = 0;
  for (std::size_t k = 0; k < bits_A_.size(); ++k) {
    std::int64_t lowest = 0;
    sum += row_length(bits_A_[k], bits_Q_[k], lift, &lowest);
  }
  return sum;
}

void IntegerScaling::compute(const PointSet& A, const PointSet& Q) {
  scan(A, bits_A_);
  scan(Q, bits_Q_);
  lift_ = 0;
  std::int64_t shortest = length(0);
  const auto propose = [&](std::int64_t lift) {
    const std::int64_t proposed = length(lift);
    if (proposed >= shortest) return;
    shortest = proposed;
    lift_ = lift;
  };
  // The sum is piecewise linear in the lift: its corners are where the ends of some row meet.
  for (std::size_t k = 0; k < bits_A_.size(); ++k) {
    if (!bits_A_[k].any || !bits_Q_[k].any) continue;
    propose(bits_Q_[k].low - bits_A_[k].low);
    propose(bits_Q_[k].high - bits_A_[k].high);
  }
  mean_bits_ = 1 + static_cast<double>(shortest) / static_cast<double>(bits_A_.size());
  row_.assign(bits_A_.size(), 0);
  for (std::size_t k = 0; k < row_.size(); ++k) {
    std::int64_t lowest = 0;
    row_length(bits_A_[k], bits_Q_[k], lift_, &lowest);
    row_[k] = -lowest;
  }
}

}  // namespace raygauge
