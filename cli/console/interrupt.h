// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <csignal>

namespace raygauge::cli {

/// The program's exit status once a signal has ended its work; the one of SIGINT where another cause has.
int interrupted_status() noexcept;

/// While it lives, the first SIGINT or SIGTERM is kept for the program to act on when it suits; the second
/// one ends the program at once. One object at a time.
class InterruptGuard {
 public:
  /// The first signal writes `notice` to standard error, to show that it was heard; null: nothing. `notice`
  /// outlives the guard.
  explicit InterruptGuard(const char* notice);
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  /// The signal that came; 0 for none. May be asked from any thread.
  static int signal() noexcept;

 private:
  struct sigaction previous_interrupt_ {};
  struct sigaction previous_terminate_ {};
};

}  // namespace raygauge::cli
