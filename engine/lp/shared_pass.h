// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/kernels/kernel.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

/// max_i u·p_i over the points of S, and into `collection` the points above its threshold, in one pass that
/// up to `threads` OpenMP threads share: each reads an equal run of blocks and collects into an equal share
/// of the buffers. Allocates nothing. Where more points lie above the threshold than a share holds, its best
/// are kept: which those are depends on the number of threads, the maximum does not. One thread reads small
/// sets, for which waking a second costs more than it gains.
double shared_pass(const Kernels& kernels, const PointSet& S, const double* u, Collection& collection,
                   int threads);

}  // namespace raygauge
