// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/seeded_order.h"

#include <numeric>
#include <utility>

#include "engine/numerics/splitmix64.h"

namespace raygauge {
std::vector<std::size_t> seeded_order(std::size_t count, std::uint64_t seed, std::uint64_t stream) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::uint64_t state = mix64(seed + kGoldenGamma) ^ mix64(~stream);
  for (std::size_t i = count; i > 1; --i) {
    state += kGoldenGamma;
    // The modulus prefers small values by less than i / 2^64, which no sweep can notice.
    std::swap(order[i - 1], order[mix64(state) % i]);
  }
  return order;
}

}  // namespace raygauge
