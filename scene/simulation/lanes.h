// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

namespace raygauge {

/// Four and eight numbers, with the operators of one: the compiler makes of them what the machine has. How
/// they are passed by value depends on that; hence never to a function that is not inlined.
using Four [[gnu::vector_size(32), gnu::aligned(32)]] = double;
using Eight [[gnu::vector_size(64), gnu::aligned(64)]] = double;

/// The six numbers of a body, and zeros.
struct BodyLanes {
  Eight y = {};
};

}  // namespace raygauge
