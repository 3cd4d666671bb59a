// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <limits>

namespace raygauge {

/// The time that a baseline has for its model. A library copies, scales or presolves the model in calls that
/// nothing interrupts: they take at most `later` times what building it took (measured by each baseline), so
/// building ends where they would no longer end within the limit.
class BuildingTime {
 public:
  explicit BuildingTime(double later) : later_(later) {}

  /// Of the models that are begun from now on.
  void limit(double seconds) noexcept { limit_ = seconds; }

  void begin() noexcept {
    start_ = Clock::now();
    seconds_ = 0;
    too_long_ = false;
  }

  /// Whether the model begun last will take too long; to be asked every few columns.
  bool is_too_long() noexcept {
    seconds_ = seconds_since_begin();
    too_long_ = too_long_ || (1 + later_) * seconds_ > limit_;
    return too_long_;
  }

  double seconds_since_begin() const noexcept {
    return std::chrono::duration<double>(Clock::now() - start_).count();
  }

  /// What is left of `limit` for the iterations of a solve; not positive where nothing is.
  double left_of(double limit) const noexcept { return too_long_ ? 0 : limit - (1 + later_) * seconds_; }

 private:
  using Clock = std::chrono::steady_clock;
  double later_;
  double limit_ = std::numeric_limits<double>::infinity();
  Clock::time_point start_;
  double seconds_ = 0;
  bool too_long_ = false;
};

/// Columns between two looks at the clock.
inline constexpr int kColumnsBetweenLooks = 1024;

}  // namespace raygauge
