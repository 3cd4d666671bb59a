// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "bench/streaming_pass.h"

#include <array>
#include <cstddef>

namespace raygauge::bench {
namespace {

std::ptrdiff_t doubles_of(const PointSet& S) { return S.block_count() * S.dimension() * PointSet::kLanes; }

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define RAYGAUGE_WIDEST_VECTORS __attribute__((target_clones("arch=skylake-avx512", "avx2", "default")))
#else
#define RAYGAUGE_WIDEST_VECTORS
#endif

// Independent partial sums: as many chains as hide the latency of an addition at any vector width.
constexpr std::ptrdiff_t kChains = 64;

RAYGAUGE_WIDEST_VECTORS double sum(const double* data, std::ptrdiff_t count) {
  std::array<double, kChains> chain{};
  std::ptrdiff_t i = 0;
  for (; i + kChains <= count; i += kChains) {
    for (std::size_t c = 0; c < kChains; ++c) chain[c] += data[i + static_cast<std::ptrdiff_t>(c)];
  }
  for (; i < count; i += PointSet::kLanes) {  // whole blocks
    for (std::size_t c = 0; c < PointSet::kLanes; ++c) chain[c] += data[i + static_cast<std::ptrdiff_t>(c)];
  }
  for (std::size_t half = kChains / 2; half > 0; half /= 2) {
    for (std::size_t c = 0; c < half; ++c) chain[c] += chain[c + half];
  }
  return chain[0];
}

}  // namespace

double streaming_pass(const PointSet& S) { return sum(S.data(), doubles_of(S)); }

double bytes_of(const PointSet& S) { return static_cast<double>(doubles_of(S)) * sizeof(double); }

}  // namespace raygauge::bench
