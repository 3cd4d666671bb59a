// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/kernels/kernel.h"
#include "engine/threads/chunk_team.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

/// max_i u·p_i over the points of S, and into `collection` the points above its threshold, in one pass that
/// up to `threads` threads of `team` share: whoever is free takes the next chunk of blocks. Chunks, and the
/// share of the buffers that each fills, depend on the sizes alone, and so does what is found: not on the
/// number of threads above 1, nor on who took what. Where more points of a chunk lie above the threshold than
/// its share holds, its best are kept. Allocates nothing once the team has its size. One thread reads small
/// sets, for which waking a second costs more than it gains.
double shared_pass(const Kernels& kernels, const PointSet& S, const double* u, Collection& collection,
                   int threads, ChunkTeam& team);

}  // namespace raygauge
