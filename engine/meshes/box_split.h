// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace raygauge {

/// A triangle as a BoxTree sorts it: the middle of the box around it along the axes of the space, half its
/// sides, and the triangle's number. Nothing of it is rounded in any direction.
struct SplitItem {
  float center[3];
  float half[3];
  std::int32_t number;
};

/// The first so many items by their centres along an axis, and the others.
struct BoxSplit {
  int axis = 0;
  std::ptrdiff_t first = 0;
};

/// The cut, a multiple of `unit` from the first item, after which the products of the surfaces of the boxes
/// around both parts with the numbers of items in them have the least sum, roughly. More than `unit` items.
/// (J. D. MacDonald & K. S. Booth, "Heuristics for ray tracing using space subdivision", 1990.)
BoxSplit best_split(std::span<const SplitItem> items, std::ptrdiff_t unit);

/// Across the longest side of the box of the centres, half of the units to either side.
BoxSplit middle_split(std::span<const SplitItem> items, std::ptrdiff_t unit);

}  // namespace raygauge
