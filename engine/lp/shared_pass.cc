// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/shared_pass.h"

#include <algorithm>
#include <array>

#include "raygauge/methods/options.h"

namespace raygauge {
namespace {

// Coordinates from which on a second thread pays: some 30 µs of reading, against the few that waking it
// takes.
constexpr std::ptrdiff_t kSharedNumbers = std::ptrdiff_t{1} << 17;

std::ptrdiff_t begin_of(std::ptrdiff_t whole, int share, int shares) { return whole * share / shares; }

// What a thread found; on a cache line of its own, since others write theirs at the same time.
struct alignas(64) Found {
  std::ptrdiff_t count = 0;
  double value = 0;
};

Found read_share(const Kernels& kernels, const PointSet& S, const double* u, const Collection& whole,
                 int share, int shares) {
  const std::ptrdiff_t first = begin_of(whole.capacity, share, shares);
  const std::ptrdiff_t last = begin_of(whole.capacity, share + 1, shares);
  Collection part{whole.index + first, whole.value + first, last - first, 0, whole.threshold};
  const double value = kernels.collect(S.data(), begin_of(S.block_count(), share, shares),
                                       begin_of(S.block_count(), share + 1, shares), S.dimension(), u, &part);
  return {part.count, value};
}

}  // namespace

double shared_pass(const Kernels& kernels, const PointSet& S, const double* u, Collection& collection,
                   int threads) {
  if (threads == 1 || S.size() * S.dimension() < kSharedNumbers) {
    return kernels.collect(S.data(), 0, S.block_count(), S.dimension(), u, &collection);
  }
  std::array<Found, kMostThreads> found;
#pragma omp parallel for schedule(static) num_threads(threads) default(none) \
    shared(kernels, S, u, collection, threads, found)
  for (int share = 0; share < threads; ++share)
    found[share] = read_share(kernels, S, u, collection, share, threads);

  double value = found[0].value;
  collection.count = found[0].count;
  for (int share = 1; share < threads; ++share) {
    const std::ptrdiff_t first = begin_of(collection.capacity, share, threads);
    std::copy_n(collection.index + first, found[share].count, collection.index + collection.count);
    std::copy_n(collection.value + first, found[share].count, collection.value + collection.count);
    collection.count += found[share].count;
    value = std::max(value, found[share].value);
  }
  return value;
}

}  // namespace raygauge
