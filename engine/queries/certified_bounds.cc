// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/certified_bounds.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "engine/methods/column_generation/sifting.h"
#include "engine/proof/certificate.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

constexpr double kNegligible = 1e-12;

std::vector<std::int64_t> carriers(const PointSet& S, std::span<const std::ptrdiff_t> index,
                                   std::span<const double> weight) {
  if (index.size() != weight.size()) {
    throw InvalidParameterError("certified_upper: " + std::to_string(index.size()) + " indices for " +
                                std::to_string(weight.size()) + " weights");
  }
  double sum = 0;
  for (const double w : weight) sum += std::fabs(w);
  std::vector<std::int64_t> result;
  for (std::size_t i = 0; i < index.size(); ++i) {
    if (index[i] < 0 || index[i] >= S.size()) {
      throw InvalidParameterError("certified_upper: point " + std::to_string(index[i]) + " of a set of " +
                                  std::to_string(S.size()));
    }
    if (weight[i] > kNegligible * sum) result.push_back(index[i]);
  }
  return result;
}

}  // namespace

double certified_lower(const PointSet& A, const PointSet& Q, const double* u) {
  const Vector negative = -Vector::Map(u, Q.dimension());
  return lower_bound(support_value(best_kernels(), A, u), support_value(best_kernels(), Q, negative.data()));
}

double certified_upper(const PointSet& A, const PointSet& Q, std::span<const std::ptrdiff_t> index_A,
                       std::span<const double> alpha, std::span<const std::ptrdiff_t> index_Q,
                       std::span<const double> beta, double time_limit) {
  const std::vector<std::int64_t> points_A = carriers(A, index_A, alpha);
  std::vector<std::int64_t> points_Q = carriers(Q, index_Q, beta);
  if (points_A.empty()) return std::numeric_limits<double>::infinity();
  if (points_Q.empty()) points_Q.push_back(0);  // 0 in A: no point of Q carries weight
  Sifting solver;
  DistanceResult result;
  Stopwatch stopwatch;
  stopwatch.start(time_limit);
  solver.solve_restricted(A, Q, points_A, points_Q, {}, stopwatch, result);
  return result.upper;
}

}  // namespace raygauge
