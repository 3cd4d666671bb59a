// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "raygauge/methods/result.h"

namespace raygauge {

/// A counter by its name: JSON, results files, and sums over methods go by this list. A new counter is a
/// member of DistanceCounters and one line here.
struct CounterInfo {
  const char* name;
  const char* description;
  std::int64_t DistanceCounters::*member;
};

inline constexpr std::array<CounterInfo, 8> kCounters = {{
    {"outer_iterations", "K of the paper: scalings of Q", &DistanceCounters::outer_iterations},
    {"ray_iterations", "N_rs of the paper: iterations of the ray shooter over all outer iterations",
     &DistanceCounters::ray_iterations},
    {"pivots", "basis changes", &DistanceCounters::pivots},
    {"support_queries", "evaluations of a support function over a whole set",
     &DistanceCounters::support_queries},
    {"points_priced",
     "points whose reduced cost was computed, working sets included, or spared by the tree of a prepared set",
     &DistanceCounters::points_priced},
    {"refactorisations", "basis inverses computed afresh", &DistanceCounters::refactorisations},
    {"exact_pivots", "basis changes in exact arithmetic, where doubles did not suffice",
     &DistanceCounters::exact_pivots},
    {"witness_evaluations", "contact points computed", &DistanceCounters::witness_evaluations},
}};

// Every counter of the struct is in the list.
static_assert(sizeof(DistanceCounters) == kCounters.size() * sizeof(std::int64_t));

}  // namespace raygauge
