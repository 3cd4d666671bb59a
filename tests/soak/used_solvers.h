// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "raygauge/queries/pair_batch.h"

namespace raygauge::soak {

/// What was asked of used solvers.
struct UsedSolverTally {
  std::int64_t queries = 0;
  std::int64_t certified = 0;  ///< with a final status, or a separation that is decided
};

/// Solvers that keep nothing but memory: a query of random kind, method and tolerance about random sets in
/// R^2, R^3 or more dimensions, near, far or overlapping, is asked of solvers that have answered all queries
/// before it, and of new ones. Every number of both answers, the warm start left included, must be the same
/// bit for bit.
class UsedSolvers {
 public:
  explicit UsedSolvers(std::uint64_t seed);
  ~UsedSolvers();

  /// Query number `number` of this seed: what differs, or nothing.
  std::optional<std::string> check(std::int64_t number);

  const UsedSolverTally& tally() const noexcept { return tally_; }

 private:
  struct Team;
  std::uint64_t seed_;
  std::vector<std::unique_ptr<Team>> teams_;  // one for each choice of options
  UsedSolverTally tally_;
};

std::string to_string(const UsedSolverTally& tally);

}  // namespace raygauge::soak
