// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sets/point_set.h"

namespace raygauge::bench {

/// Reads every coordinate of S once and does nothing but add it up, as fast as the machine can: no support
/// query can be faster than this.
double streaming_pass(const PointSet& S);

/// Bytes that a pass over S reads.
double bytes_of(const PointSet& S);

}  // namespace raygauge::bench
