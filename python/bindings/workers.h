// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace raygauge::python {

/// Items that a thread takes at once: few enough that all threads end together, many enough that the counter
/// which they share costs nothing beside the smallest solve, which takes a microsecond.
inline constexpr std::ptrdiff_t kItemsAtOnce = 16;

/// Threads for a batch: `asked`, or for 0 one for each CPU that the process may use; no more than there are
/// `items`. Throws InvalidParameterError for a number below 0 or above 4096.
int batch_threads(int asked, std::ptrdiff_t items);

/// What one thread does: calls `next` for the number of an item until it is negative.
using BatchWorker = std::function<void(const std::function<std::ptrdiff_t()>& next)>;

/// Shares the items 0 … items - 1 among threads until all are taken or `stop` is set: a thread takes
/// kItemsAtOnce in a row, the first of which is a multiple of that. The
/// first exception of a worker stops the others and is thrown.
void share_items(std::ptrdiff_t items, int threads, std::atomic<bool>& stop, const BatchWorker& worker);

}  // namespace raygauge::python
