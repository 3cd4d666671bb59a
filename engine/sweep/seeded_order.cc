// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/seeded_order.h"

#include <numeric>
#include <utility>

namespace raygauge {
namespace {

constexpr std::uint64_t kGoldenGamma = 0x9e3779b97f4a7c15u;

/// The finaliser of SplitMix64 (Steele, Lea & Flood 2014): a bijection of 64-bit words.
constexpr std::uint64_t mix(std::uint64_t z) noexcept {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

}  // namespace

std::vector<std::size_t> seeded_order(std::size_t count, std::uint64_t seed, std::uint64_t stream) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::uint64_t state = mix(seed + kGoldenGamma) ^ mix(~stream);
  for (std::size_t i = count; i > 1; --i) {
    state += kGoldenGamma;
    // The modulus prefers small values by less than i / 2^64, which no sweep can notice.
    std::swap(order[i - 1], order[mix(state) % i]);
  }
  return order;
}

}  // namespace raygauge
