// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/certify.h"

#include <limits>

#include "engine/queries/certified_bounds.h"

namespace raygauge {
namespace {

// For the proof of an upper bound. Bases that have a feasible combination need a fraction of it.
constexpr double kProofSeconds = 2;

void certify_dual(const GaugeLp& lp, const Vector& u, DistanceResult& result) {
  if (u.size() == 0 || !u.allFinite()) return;
  result.lower = certified_lower(lp.A(), lp.Q(), u.data());
  const double h_Q = lp.Q().support_function(-u);
  result.normal = h_Q > 0 ? Vector(u / h_Q) : u;
}

void certify_basis(const GaugeLp& lp, const std::vector<std::ptrdiff_t>& basis, DistanceResult& result) {
  std::vector<std::ptrdiff_t> index_A, index_Q;
  for (const std::ptrdiff_t column : basis) {
    if (column < lp.A().size()) {
      index_A.push_back(column);
    } else {
      index_Q.push_back(column - lp.A().size());
    }
  }
  if (index_A.empty()) return;
  // The weights only say which points matter. Basic points of weight zero do: without them the points may
  // have no combination that is feasible in spite of rounding.
  const std::vector<double> alpha(index_A.size(), 1.0), beta(index_Q.size(), 1.0);
  result.upper = certified_upper(lp.A(), lp.Q(), index_A, alpha, index_Q, beta, kProofSeconds);
}

}  // namespace

DistanceResult certified_result(const GaugeLp& lp, const LpAnswer& answer) {
  DistanceResult result;
  result.status = answer.status;
  result.distance = answer.status == DistanceStatus::unreachable ? std::numeric_limits<double>::infinity()
                                                                 : answer.objective;
  result.counters.pivots = answer.pivots;
  certify_dual(lp, answer.u, result);
  if (result.lower == std::numeric_limits<double>::infinity()) {
    result.upper = result.lower;
  } else {
    certify_basis(lp, answer.basis, result);
  }
  return result;
}

}  // namespace raygauge
