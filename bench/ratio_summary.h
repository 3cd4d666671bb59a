// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdio>

namespace raygauge::bench {

/// Ratios of one row, with their geometric mean and the worst cell.
class Summary {
 public:
  enum class Worst { largest, smallest };

  explicit Summary(const char* what, Worst worst = Worst::largest)
      : what_(what), sense_(worst == Worst::largest ? 1.0 : -1.0) {}

  void add(double ratio, int n, int N) {
    sum_of_logs_ += std::log(ratio);
    ++cells_;
    if (cells_ > 1 && sense_ * (ratio - worst_) <= 0) return;
    worst_ = ratio;
    worst_n_ = n;
    worst_N_ = N;
  }
  void print() const {
    std::printf("%-22s geometric mean %.4g, worst %.4g (n = %d, N = %d), %d cells\n", what_,
                std::exp(sum_of_logs_ / cells_), worst_, worst_n_, worst_N_, cells_);
  }

 private:
  const char* what_;
  double sense_;
  double sum_of_logs_ = 0;
  double worst_ = 0;
  int cells_ = 0;
  int worst_n_ = 0;
  int worst_N_ = 0;
};

}  // namespace raygauge::bench
