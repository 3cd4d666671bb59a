// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/highest_points.h"

#include <algorithm>

#include "engine/sets/cluster_tree.h"

namespace raygauge {

Highest highest_point(const Kernels& kernels, const PointSet& S, const double* u) {
  Highest found{0, 0, S.size()};
  if (const ClusterTree* tree = S.tree()) {
    found = tree->highest(kernels, S.data(), u);
  } else {
    found.value = kernels.price(S.data(), S.block_count(), S.dimension(), u, &found.index);
  }
  found.index = std::min(found.index, S.size() - 1);
  return found;
}

double collect_points(const Kernels& kernels, const PointSet& S, const double* u, Collection& found) {
  if (const ClusterTree* tree = S.tree()) return tree->collect(kernels, S.data(), u, found);
  return kernels.collect(S.data(), 0, S.block_count(), S.dimension(), u, &found);
}

}  // namespace raygauge
