// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

namespace raygauge {

/// The CPUs that the calling thread may run on, those of different cores before the second hardware threads
/// of the same cores. Empty where the system does not tell.
std::vector<int> allowed_cpus();

/// allowed_cpus(), turned so that the CPU on which the calling thread runs comes first. The system has put
/// independent processes on different CPUs; each that pins its threads in this order stays where it is
/// instead of all meeting on the first CPU.
std::vector<int> allowed_cpus_from_here();

/// Keeps the calling thread on one CPU for as long as it lives, then gives back the affinity found before.
/// Create and destroy it in the same thread. Where the system refuses, the thread stays free.
class ThreadPin {
 public:
  explicit ThreadPin(int cpu);
  ~ThreadPin();
  ThreadPin(const ThreadPin&) = delete;
  ThreadPin& operator=(const ThreadPin&) = delete;

  /// Whether the thread is held on the CPU.
  bool pinned() const noexcept { return previous_ != nullptr; }

 private:
  struct Affinity;
  std::unique_ptr<Affinity> previous_;  ///< null: not pinned
};

}  // namespace raygauge
