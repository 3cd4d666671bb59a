// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace raygauge {

/// 2^64 over the golden ratio, odd: the step of SplitMix64.
inline constexpr std::uint64_t kGoldenGamma = 0x9e3779b97f4a7c15U;

/// The finaliser of SplitMix64 (Steele, Lea & Flood 2014): a bijection of 64-bit words.
constexpr std::uint64_t mix64(std::uint64_t z) noexcept {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

/// A word that looks random and is the same everywhere, for choices that need not differ from run to run.
constexpr std::uint64_t splitmix64(std::uint64_t x) noexcept { return mix64(x + kGoldenGamma); }

}  // namespace raygauge
