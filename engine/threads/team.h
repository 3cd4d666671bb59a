// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <vector>

namespace raygauge {

/// Keeps the first exception thrown in a team of threads, since none may leave an OpenMP region.
class FirstError {
 public:
  /// Runs `work`, keeping what it throws if it is the first.
  void guard(const std::function<void()>& work) noexcept;

  /// Whether something was thrown; the other threads then take no more work.
  bool occurred() const noexcept { return occurred_.load(std::memory_order_acquire); }

  /// Rethrows it, if there is one.
  void rethrow() const;

 private:
  std::mutex mutex_;
  std::exception_ptr error_;
  std::atomic<bool> occurred_{false};
};

/// Runs `work(thread, team_size)` on `threads` OpenMP threads at once and rethrows the first exception when
/// all have returned. Thread j is held on cpus[j]; with fewer CPUs than threads none is. The runtime may
/// grant fewer threads than asked for; team_size says how many there are.
void run_team(int threads, const std::vector<int>& cpus, const std::function<void(int, int)>& work);

}  // namespace raygauge
