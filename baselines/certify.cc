// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/certify.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace raygauge {
namespace {

using Real = long double;
using RealMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using RealVector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// max_i u·p_i and the largest Σ_k |u_k p_ik|, for the rounding error.
struct Support {
  Real value = -std::numeric_limits<Real>::infinity();
  Real magnitude = 0;
};

Support support(const PointSet& set, const double* u, Real sign) {
  Support result;
  Vector p(set.dimension());
  for (std::ptrdiff_t i = 0; i < set.size(); ++i) {
    set.copy_point(i, p.data());
    Real sum = 0, magnitude = 0;
    for (int k = 0; k < set.dimension(); ++k) {
      const Real term = sign * Real(u[k]) * p[k];
      sum += term;
      magnitude += std::abs(term);
    }
    result.value = std::max(result.value, sum);
    result.magnitude = std::max(result.magnitude, magnitude);
  }
  return result;
}

double round_down(Real x) {
  const double y = static_cast<double>(x);
  return Real(y) > x ? std::nextafter(y, -kInfinity) : y;
}

double round_up(Real x) {
  const double y = static_cast<double>(x);
  return Real(y) < x ? std::nextafter(y, kInfinity) : y;
}

double certified_lower(const PointSet& A, const PointSet& Q, const double* u) {
  const Support a = support(A, u, 1), q = support(Q, u, -1);
  const Real unit = (A.dimension() + 2) * std::numeric_limits<Real>::epsilon();
  const Real numerator = -a.value - unit * a.magnitude;
  const Real denominator = q.value + unit * q.magnitude;
  if (!(numerator > 0)) return 0;
  if (!(denominator > 0)) return kInfinity;
  return round_down(numerator / denominator * (1 - 2 * std::numeric_limits<Real>::epsilon()));
}

double certified_upper(const PointSet& A, const PointSet& Q, std::span<const std::ptrdiff_t> index_A,
                       std::span<const std::ptrdiff_t> index_Q) {
  const int n = A.dimension();
  const auto count_A = static_cast<Eigen::Index>(index_A.size());
  const auto count_Q = static_cast<Eigen::Index>(index_Q.size());
  RealMatrix B = RealMatrix::Zero(n + 1, count_A + count_Q);
  for (Eigen::Index j = 0; j < count_A; ++j) {
    B.col(j).head(n) = A.point(index_A[static_cast<std::size_t>(j)]).cast<Real>();
    B(n, j) = 1;
  }
  for (Eigen::Index j = 0; j < count_Q; ++j) {
    B.col(count_A + j).head(n) = -Q.point(index_Q[static_cast<std::size_t>(j)]).cast<Real>();
  }
  const RealVector b = RealVector::Unit(n + 1, n);
  const Eigen::FullPivLU<RealMatrix> factors(B);
  RealVector x = factors.solve(b);
  x += factors.solve(b - B * x);
  const RealVector scale = B.cwiseAbs() * x.cwiseAbs() + b;
  const Real unit = 64 * (n + 1) * std::numeric_limits<Real>::epsilon();
  if (!((b - B * x).cwiseAbs().array() <= unit * scale.array()).all() || x.minCoeff() < 0) return kInfinity;
  return round_up(x.tail(count_Q).sum() * (1 + unit));
}

}  // namespace

DistanceResult certified_result(const GaugeLp& lp, const LpAnswer& answer) {
  DistanceResult result;
  result.status = answer.status;
  result.distance = answer.status == DistanceStatus::unreachable ? kInfinity : answer.objective;
  result.counters.pivots = answer.pivots;
  if (answer.u.size() > 0 && answer.u.allFinite()) {
    result.lower = certified_lower(lp.A(), lp.Q(), answer.u.data());
    const double h_Q = lp.Q().support_function(-answer.u);
    result.normal = h_Q > 0 ? Vector(answer.u / h_Q) : answer.u;
  }
  std::vector<std::ptrdiff_t> index_A, index_Q;
  for (std::size_t j = 0; j < answer.primal.size(); ++j) {
    const auto column = static_cast<std::ptrdiff_t>(j);
    if (!(answer.primal[j] > 0)) continue;
    if (column < lp.A().size()) {
      index_A.push_back(column);
    } else {
      index_Q.push_back(column - lp.A().size());
    }
  }
  if (!index_A.empty()) result.upper = certified_upper(lp.A(), lp.Q(), index_A, index_Q);
  return result;
}

}  // namespace raygauge
