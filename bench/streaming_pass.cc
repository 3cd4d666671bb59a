// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "bench/streaming_pass.h"

#include <cstddef>

namespace raygauge::bench {
namespace {

std::ptrdiff_t doubles_of(const PointSet& S) { return S.block_count() * S.dimension() * PointSet::kLanes; }

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define RAYGAUGE_WIDEST_VECTORS __attribute__((target_clones("arch=skylake-avx512", "avx2", "default")))
#else
#define RAYGAUGE_WIDEST_VECTORS
#endif

// Eight sums side by side hide the latency of an addition; the build lets the compiler reorder them
// (CMakeLists.txt).
RAYGAUGE_WIDEST_VECTORS double sum(const double* data, std::ptrdiff_t count) {
  constexpr std::ptrdiff_t kPiece = 256;  // doubles a sum takes at a time: near enough to read one stream
  double s0 = 0, s1 = 0, s2 = 0, s3 = 0, s4 = 0, s5 = 0, s6 = 0, s7 = 0;
  std::ptrdiff_t i = 0;
  for (; i + 8 * kPiece <= count; i += 8 * kPiece) {
    const double* piece = data + i;
    for (std::ptrdiff_t k = 0; k < kPiece; ++k) {
      s0 += piece[k];
      s1 += piece[k + kPiece];
      s2 += piece[k + 2 * kPiece];
      s3 += piece[k + 3 * kPiece];
      s4 += piece[k + 4 * kPiece];
      s5 += piece[k + 5 * kPiece];
      s6 += piece[k + 6 * kPiece];
      s7 += piece[k + 7 * kPiece];
    }
  }
  for (; i < count; ++i) s0 += data[i];
  return ((s0 + s1) + (s2 + s3)) + ((s4 + s5) + (s6 + s7));
}

}  // namespace

double streaming_pass(const PointSet& S) { return sum(S.data(), doubles_of(S)); }

double bytes_of(const PointSet& S) { return static_cast<double>(doubles_of(S)) * sizeof(double); }

}  // namespace raygauge::bench
