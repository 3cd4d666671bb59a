// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "raygauge/sets/convex_set.h"
#include "raygauge/sweep/registry.h"

namespace raygauge {

/// What an instance depends on, besides the generator and its parameters; nothing else may influence it.
struct InstanceKey {
  std::uint64_t seed = 1;
  int n = 3;           ///< dimension of the space
  int N = 200;         ///< points in each set (generators without point sets ignore it)
  int repetition = 0;  ///< 0, 1, …
};

/// One distance query, with its exact answer where the generator knows it.
struct Instance {
  std::shared_ptr<const ConvexSet> A;
  std::shared_ptr<const ConvexSet> Q;
  std::optional<double> exact_distance;
  double exact_distance_rounding = 0;  ///< its relative error, where it is more than the generator promises
};

/// A family of instances. Implementations are immutable and shared between threads.
class Generator {
 public:
  virtual ~Generator() = default;

  /// The instance of that key: the same on any machine, in any order, on any number of threads.
  /// Throws InvalidParameterError where the family has no member of that n or N.
  virtual Instance generate(const InstanceKey& key) const = 0;
};

using GeneratorRegistry = Registry<Generator>;

}  // namespace raygauge
