// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "baselines/exact_lp.h"
#include "tests/soak/random_family.h"

namespace raygauge::soak {

/// Two point sets whose distance is proven in rational arithmetic, and what the proof rests on.
struct ProvenInstance {
  std::string label;  ///< generator
  Eigen::MatrixXd A;  ///< one point a column
  Eigen::MatrixXd Q;
  ExactLpResult truth;
  std::vector<bool> carries_A;  ///< whether the proof gives point i of A a positive weight
  std::vector<bool> carries_Q;

  /// Whether u·a <= -t - margin, resp. -u·q <= 1 - margin (0 - margin for unreachable), is certain in double
  /// precision for a point: then the dual half of the proof allows it in A, resp. Q. The margin is the
  /// rounding error of the test itself.
  bool may_join_A(const Eigen::Ref<const Eigen::VectorXd>& a) const;
  bool may_join_Q(const Eigen::Ref<const Eigen::VectorXd>& q) const;

  Vector u;                      ///< truth.u, rounded
  double t = 0;                  ///< truth.t, rounded
  bool dual_is_rounded = false;  ///< whether u and t lie in the range where rounding is relative
};

/// The largest number of coordinates, points of A and Q together, that a base instance may have.
constexpr Eigen::Index kMostCoordinates = 4000;

/// Draws families until one has a member of that size, and proves its distance. Throws Error where the exact
/// program's proof does not verify.
ProvenInstance draw_proven_instance(const GeneratorRegistry& registry, const std::vector<std::string>& names,
                                    RandomStream& stream);

/// The same for given points.
ProvenInstance prove(std::string label, const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q);

}  // namespace raygauge::soak
