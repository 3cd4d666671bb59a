// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/shared_pass.h"

#include <algorithm>
#include <array>

#include "engine/lp/tuning.h"
#include "engine/sets/highest_points.h"

namespace raygauge {
namespace {

constexpr std::ptrdiff_t kMostChunks = 64;

std::ptrdiff_t begin_of(std::ptrdiff_t whole, std::ptrdiff_t chunk, std::ptrdiff_t chunks) {
  return whole * chunk / chunks;
}

// What a chunk holds; on a cache line of its own, since other threads write theirs at the same time.
struct alignas(64) Found {
  std::ptrdiff_t count = 0;
  double value = 0;
};

// Every chunk collects into its own share of the buffers.
Found read_chunk(const Kernels& kernels, const PointSet& S, const double* u, const Collection& whole,
                 int chunk, int chunks) {
  const std::ptrdiff_t first = begin_of(whole.capacity, chunk, chunks);
  const std::ptrdiff_t last = begin_of(whole.capacity, chunk + 1, chunks);
  Collection part{whole.index + first, whole.value + first, last - first, 0, whole.threshold};
  const double value = kernels.collect(S.data(), begin_of(S.block_count(), chunk, chunks),
                                       begin_of(S.block_count(), chunk + 1, chunks), S.dimension(), u, &part);
  return {part.count, value};
}

}  // namespace

double shared_pass(const Kernels& kernels, const PointSet& S, const double* u, Collection& collection,
                   int threads, ChunkTeam& team) {
  const std::ptrdiff_t numbers = S.block_count() * PointSet::kLanes * S.dimension();
  if (threads == 1 || numbers < tuned::kSharedNumbers || S.tree() != nullptr) {
    return collect_points(kernels, S, u, collection);
  }
  team.resize(threads);
  const auto chunks = static_cast<int>(
      std::min({numbers / tuned::kNumbersOfChunk, kMostChunks, S.block_count(), collection.capacity / 2}));
  std::array<Found, kMostChunks> found;
  team.run(chunks, numbers >= tuned::kNumbersWorthWaking, [&](int chunk) {
    found[static_cast<std::size_t>(chunk)] = read_chunk(kernels, S, u, collection, chunk, chunks);
  });

  double value = found[0].value;
  collection.count = found[0].count;
  for (int chunk = 1; chunk < chunks; ++chunk) {
    const Found& part = found[static_cast<std::size_t>(chunk)];
    const std::ptrdiff_t first = begin_of(collection.capacity, chunk, chunks);
    std::copy_n(collection.index + first, part.count, collection.index + collection.count);
    std::copy_n(collection.value + first, part.count, collection.value + collection.count);
    collection.count += part.count;
    value = std::max(value, part.value);
  }
  return value;
}

}  // namespace raygauge
