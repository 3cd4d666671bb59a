// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/threads/team.h"

#include <omp.h>

#include <optional>

#include "engine/threads/thread_pin.h"

namespace raygauge {

void FirstError::guard(const std::function<void()>& work) noexcept {
  try {
    work();
  } catch (...) {
    const std::lock_guard lock(mutex_);
    if (!occurred()) error_ = std::current_exception();
    occurred_.store(true, std::memory_order_release);
  }
}

void FirstError::rethrow() const {
  if (error_) std::rethrow_exception(error_);
}

void run_team(int threads, const std::vector<int>& cpus, const std::function<void(int, int)>& work) {
  const bool pin = static_cast<std::size_t>(threads) <= cpus.size();
  FirstError error;
#pragma omp parallel num_threads(threads) default(none) shared(threads, cpus, work, pin, error)
  {
    const int thread = omp_get_thread_num();
    std::optional<ThreadPin> pinned;
    if (pin) pinned.emplace(cpus[static_cast<std::size_t>(thread)]);
    error.guard([&] { work(thread, omp_get_num_threads()); });
  }
  error.rethrow();
}

}  // namespace raygauge
