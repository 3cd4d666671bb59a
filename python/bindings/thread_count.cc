// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "python/bindings/thread_count.h"

#include <sched.h>

#include <algorithm>
#include <string>
#include <thread>

#include "raygauge/exceptions.h"
#include "raygauge/queries/pair_batch.h"

namespace raygauge::python {
namespace {

int usable_cpus() {
  cpu_set_t cpus;
  if (sched_getaffinity(0, sizeof cpus, &cpus) == 0) return std::max(1, CPU_COUNT(&cpus));
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

int batch_threads(int asked) {
  if (asked < 0 || asked > kMostBatchThreads) {
    throw InvalidParameterError("threads: " + std::to_string(asked) + " is outside 0 ... " +
                                std::to_string(kMostBatchThreads) + " (0: one for each CPU)");
  }
  return asked == 0 ? std::min(usable_cpus(), kMostBatchThreads) : asked;
}

}  // namespace raygauge::python
