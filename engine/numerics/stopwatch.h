// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>
#include <limits>

namespace raygauge {

/// Watches a time limit, and whether somebody asks for an end; never looks at the clock where there is no
/// limit.
class Stopwatch {
 public:
  /// `stop`, where it is given and not empty, is asked as often as the limit is looked at; it outlives the
  /// watch.
  void start(double limit_seconds, const std::function<bool()>* stop = nullptr) {
    stop_ = stop != nullptr && *stop ? stop : nullptr;
    limit_ = limit_seconds;
    if (limited()) begin_ = std::chrono::steady_clock::now();
  }
  bool limited() const noexcept { return limit_ < std::numeric_limits<double>::infinity(); }
  bool expired() const { return (stop_ != nullptr && (*stop_)()) || (limited() && seconds() >= limit_); }

  /// Seconds left of the limit, negative when it is over; +infinity where no limit was set.
  double remaining() const { return limited() ? limit_ - seconds() : limit_; }

  /// Seconds since start; NaN where no limit was set.
  double seconds() const {
    if (!limited()) return std::numeric_limits<double>::quiet_NaN();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  const std::function<bool()>* stop_ = nullptr;
  double limit_ = std::numeric_limits<double>::infinity();
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace raygauge
