// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

#include "raygauge/methods/options.h"
#include "raygauge/methods/result.h"

namespace raygauge::soak {

/// Of a method that the soak asks, among them.
constexpr std::size_t place_of(DistanceMethod method) {
  return method == DistanceMethod::column_generation ? 0 : 1;
}

/// What became of the solves of one family.
struct FamilyTally {
  std::int64_t bases = 0;
  std::int64_t solves = 0;
  std::array<std::int64_t, 6> by_status{};  ///< in the order of DistanceStatus
  std::int64_t settled_exactly = 0;         ///< solves that needed exact pivots
  std::int64_t normals_checked = 0;         ///< by dual_value()
  std::int64_t normals_short = 0;   ///< of those: the rounded normal alone proves less than lower (1 - 1e-9)
  std::int64_t exact_checks = 0;    ///< solved again by the exact rational program
  std::array<double, 2> seconds{};  ///< of the solves by method, see place_of
  std::array<std::int64_t, 2> by_method{};
  double worst_width = 0;  ///< among optimal ones with a tolerance of 1e-12

  std::int64_t certified() const;
  void add(const FamilyTally& other);
};

/// By family and by dimension.
struct Tally {
  std::map<std::string, FamilyTally> families;
  std::map<int, FamilyTally> dimensions;

  FamilyTally total() const;
  void add(const Tally& other);
};

/// Both tables as text, one line a family or dimension, the totals last.
std::string to_string(const Tally& tally);

}  // namespace raygauge::soak
