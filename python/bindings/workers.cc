// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "python/bindings/workers.h"

#include <sched.h>

#include <algorithm>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "raygauge/exceptions.h"

namespace raygauge::python {
namespace {

constexpr int kMostBatchThreads = 4096;

int usable_cpus() {
  cpu_set_t cpus;
  if (sched_getaffinity(0, sizeof cpus, &cpus) == 0) return std::max(1, CPU_COUNT(&cpus));
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// The items of one thread, out of those that all threads share.
class Share {
 public:
  Share(std::atomic<std::ptrdiff_t>& taken, std::ptrdiff_t items, const std::atomic<bool>& stop)
      : taken_(taken), items_(items), stop_(stop) {}

  std::ptrdiff_t next() {
    if (stop_.load(std::memory_order_relaxed)) return -1;
    if (item_ == end_) {
      item_ = taken_.fetch_add(kItemsAtOnce, std::memory_order_relaxed);
      end_ = item_ + kItemsAtOnce;
    }
    return item_ < items_ ? item_++ : -1;
  }

 private:
  std::atomic<std::ptrdiff_t>& taken_;
  std::ptrdiff_t items_;
  const std::atomic<bool>& stop_;
  std::ptrdiff_t item_ = 0;
  std::ptrdiff_t end_ = 0;
};

}  // namespace

int batch_threads(int asked, std::ptrdiff_t items) {
  if (asked < 0 || asked > kMostBatchThreads) {
    throw InvalidParameterError("threads: " + std::to_string(asked) + " is outside 0 ... " +
                                std::to_string(kMostBatchThreads) + " (0: one for each CPU)");
  }
  const int wanted = asked == 0 ? usable_cpus() : asked;
  const std::ptrdiff_t shares = (items + kItemsAtOnce - 1) / kItemsAtOnce;
  return static_cast<int>(std::clamp<std::ptrdiff_t>(shares, 1, wanted));
}

void share_items(std::ptrdiff_t items, int threads, std::atomic<bool>& stop, const BatchWorker& worker) {
  std::atomic<std::ptrdiff_t> taken = 0;
  std::mutex mutex;
  std::exception_ptr error;
  const auto work = [&] {
    try {
      Share share(taken, items, stop);
      worker([&share] { return share.next(); });
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!error) error = std::current_exception();
      stop = true;
    }
  };
  std::vector<std::thread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(work);
  work();
  for (std::thread& thread : others) thread.join();
  if (error) std::rethrow_exception(error);
}

}  // namespace raygauge::python
