// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <limits>

namespace raygauge {

/// Watches a time limit; never looks at the clock where there is none.
class Stopwatch {
 public:
  void start(double limit_seconds) {
    limit_ = limit_seconds;
    if (limited()) begin_ = std::chrono::steady_clock::now();
  }
  bool limited() const noexcept { return limit_ < std::numeric_limits<double>::infinity(); }
  bool expired() const { return limited() && seconds() >= limit_; }

  /// Seconds left of the limit, negative when it is over; +infinity where no limit was set.
  double remaining() const { return limited() ? limit_ - seconds() : limit_; }

  /// Seconds since start; NaN where no limit was set.
  double seconds() const {
    if (!limited()) return std::numeric_limits<double>::quiet_NaN();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  double limit_ = std::numeric_limits<double>::infinity();
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace raygauge
