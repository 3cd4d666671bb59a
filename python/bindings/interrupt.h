// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <utility>

namespace raygauge::python {

/// Runs `work` in a thread of its own, without the interpreter's lock, while this one waits and looks for
/// Ctrl-C every 20 ms. A signal handler that raises sets `stop`, and what it raised is thrown when `work` has
/// returned; otherwise what `work` throws is thrown here. To be called with the lock held.
void run_interruptibly(std::atomic<bool>& stop, const std::function<void()>& work);

/// Looks for Ctrl-C while a solve runs in this thread without the interpreter's lock: every 20 ms, when the
/// solve asks whether it is to stop. One object a call.
class SignalWatch {
 public:
  /// For DistanceSolver::set_stop.
  std::function<bool()> function() {
    return [this] { return look(); };
  }

  /// What `solve` returns, which is called without the lock. Throws what a signal handler raised meanwhile.
  template <class Solve>
  auto run(const Solve& solve) {
    auto result = [&] {
      const pybind11::gil_scoped_release release;
      return solve();
    }();
    if (raised_) throw pybind11::error_already_set(*raised_);
    return result;
  }

 private:
  bool look();

  std::chrono::steady_clock::time_point last_look_;  // the epoch: the solve has not asked yet
  std::optional<pybind11::error_already_set> raised_;
};

}  // namespace raygauge::python
