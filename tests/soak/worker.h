// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "raygauge/queries/solver.h"
#include "tests/soak/certificate_check.h"
#include "tests/soak/tally.h"
#include "tests/soak/variant.h"

namespace raygauge::soak {

/// A solve whose answer is false, with everything that is needed to see it again.
struct Violation {
  std::string what;
  std::string family;
  std::int64_t base = 0;
  std::int64_t variant = 0;
  std::string method;
  double tolerance = 0;
  Truth truth;
  DistanceResult result;
  bool repeats_in_a_fresh_solver = false;
  Eigen::MatrixXd A;
  Eigen::MatrixXd Q;
};

/// Solves the variants of one base instance after the other. The solvers live as long as the worker, so that
/// every solve meets the workspace that solves of other families, dimensions and methods have left behind.
class Worker {
 public:
  Worker(const GeneratorRegistry& registry, std::vector<std::string> names, std::uint64_t seed);

  /// Base instance number `base` with at most `most_solves` variants: the same on any worker, but for what
  /// the workspaces hold.
  std::optional<Violation> run(std::int64_t base, std::int64_t most_solves);

  /// What was counted since the last call.
  Tally take_tally();

 private:
  struct Request {
    DistanceOptions options;
    Effects effects = Effects::none;
  };

  Request draw_request(RandomStream& stream, int n) const;
  std::optional<Violation> solve_variant(const ProvenInstance& base, RandomStream& stream, bool ask_oracle);
  std::string check(const DistanceResult& result, const Truth& truth, double tolerance, FamilyTally& counts);
  bool oracle_agrees(const Truth& truth, FamilyTally& counts) const;
  Violation report(const std::string& what, const ProvenInstance& base, const Request& request,
                   const Truth& truth, const DistanceResult& result) const;

  const GeneratorRegistry& registry_;
  std::vector<std::string> names_;
  std::uint64_t seed_;
  DistanceSolver column_generation_;
  DistanceSolver zheng_yamane_;
  Variant variant_;
  Tally tally_;
  double work_ = 0;  // spent on the present base
};

}  // namespace raygauge::soak
