// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "raygauge/scene/scene_run.h"
#include "scene/queries/pair_solver.h"
#include "scene/queries/timeline.h"

namespace raygauge {

/// The k nearest pairs of a query at the instants [first, last): pairs are solved in the order of the bounds
/// of their bounding balls, until the next one cannot be among the k nearest. Planes of the instant before
/// save some of those solves.
void find_nearest(const Scene& scene, const Timeline& timeline, int query, std::size_t first,
                  std::size_t last, PairSolver& solver, SceneCellResult& result,
                  const std::function<bool()>& stop);

}  // namespace raygauge
