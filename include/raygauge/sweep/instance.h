// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

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

/// What is asked of an instance. All but the distance are asked of two bodies A1 and A2: A is their
/// difference A2 - A1, Q the unit ball about the origin. A DistanceResult then holds, in place of the
/// distance with its bounds,
enum class Quantity : std::uint8_t {
  distance,   ///< d_Q(A)
  depth,      ///< see ObjectDepth; `optimal`, also where it is 0
  separated,  ///< 1 with both bounds (`optimal`) of bodies apart; 0 (`contains_origin`) of bodies that meet
  growth,     ///< the growth distance about both centres
};

/// "distance", "depth", "separated", "growth".
std::string_view to_string(Quantity quantity) noexcept;

/// The inverse of to_string. Throws UnknownNameError.
Quantity quantity_from_string(std::string_view name);

/// One query, with its exact answer where the generator knows it.
struct Instance {
  std::shared_ptr<const ConvexSet> A;
  std::shared_ptr<const ConvexSet> Q;
  std::optional<double> exact_distance;  ///< of another quantity that one
  double exact_distance_rounding = 0;    ///< its relative error, where it is more than the generator promises
  Quantity quantity = Quantity::distance;
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
