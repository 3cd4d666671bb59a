// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace raygauge {

/// A permutation of 0, 1, …, count - 1 that depends on (count, seed, stream) alone: the same with every
/// standard library, unlike std::shuffle. `stream` separates the uses of one seed (a cell's index, say).
std::vector<std::size_t> seeded_order(std::size_t count, std::uint64_t seed, std::uint64_t stream);

}  // namespace raygauge
