// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "baselines/exact_number.h"
#include "raygauge/methods/result.h"

namespace raygauge::soak {

/// What is known of the distance: a rational number between neighbouring doubles (or one itself), or
/// +infinity.
struct Truth {
  DistanceStatus status = DistanceStatus::optimal;  ///< optimal, contains_origin or unreachable
  RoundedDoubles rounded;
};

/// What is false in `result`, a solve with that tolerance: bounds that miss the truth, a status that claims
/// what is not so, a distance outside the bounds. Empty if nothing is. Compares doubles with the neighbours
/// of the truth, hence without rounding.
std::string falsehood(const DistanceResult& result, const Truth& truth, double tolerance);

/// The lower bound of equation (10) at the returned normal,
///
///     L = -h_A(u) / h_Q(-u),
///
/// enclosed by below <= L <= above, with arithmetic of its own on the points as they are. known is false
/// where h_A(u) < 0 < h_Q(-u) is not certain or a coordinate lies outside 1e±150.
struct DualValue {
  bool known = false;
  double below = 0;
  double above = 0;
};

DualValue dual_value(const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q, const Vector& u);

}  // namespace raygauge::soak
