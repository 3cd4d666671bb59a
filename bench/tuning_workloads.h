// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/workload.h"

namespace raygauge::bench {

/// What is timed.
using Call = std::function<void()>;

/// Makes a call: sets are made and loaded under the thresholds of that moment. The same instances each time.
using Workload = std::function<Call()>;

struct Cell {
  int n = 0, N = 0;
};

/// Cold solves of instances of a variant, some of each cell.
Workload solves(const std::string& method, const std::vector<Cell>& cells,
                const std::string& variant = "random", int threads = 1);

/// Cold solves of two cross-polytopes, ellipsoids or 3-norm balls of R^n.
enum class Shapes { cross_polytopes, ellipsoids, p_norm_balls };
Workload solves_of(Shapes shapes, const std::vector<int>& dimensions);

/// Euclidean distances of two point sets by the nearest point of their difference.
Workload euclidean(const std::vector<Cell>& cells);

/// Depths of two hulls of points of the sphere, whose centres are 0.3 apart.
Workload depths(const std::vector<Cell>& cells);

/// Support points of a prepared set of N points of the sphere, along random directions; those of a needle are
/// 10^4 times as far along one axis.
Workload supports(Cell cell, bool needle = false);

/// Gauges of K points of a ball in a hull of N points of the sphere.
Workload gauges_in(Cell cell, int K);

/// A distance of two hulls that are read as streams.
Workload streams(Cell cell);

/// Whether the hull of N random points has the origin inside, which it hardly has.
Workload origins(const std::vector<Cell>& cells);

/// Distances of two tori of triangles, in some poses; and building the tree of one.
Workload tori(int triangles);
Workload torus_trees(int triangles);

/// Pairs of bodies of R^3: pair_bodies.h. At rest: each pose is asked ten times.
enum class PairAsk { distance, warm, growth, depth, depth_warm, depth_at_rest };
Workload pairs(const std::vector<std::pair<std::string, std::string>>& kinds, const std::string& place,
               PairAsk ask);

/// Steps of a heap of so many bodies, always the same ones: from one time of a Bin to another.
Workload heap_steps(int bodies, double from, double to, int threads = 1);

}  // namespace raygauge::bench
