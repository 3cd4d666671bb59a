// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/hdf5/for_all.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/threads/thread_pin.h"

namespace raygauge {
namespace {

constexpr std::size_t kMostThreads = 8;  ///< reading and writing, one thread at a time, hold back more

}  // namespace

void for_all(std::size_t count, const std::function<void(std::size_t)>& work) {
  static const std::size_t kThreads = std::clamp<std::size_t>(allowed_cpus().size(), 1, kMostThreads);
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto take_turns = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) work(i);
    } catch (...) {
      const std::scoped_lock lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < std::min(kThreads, count); ++i) others.emplace_back(take_turns);
    take_turns();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace raygauge
