// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/simulation.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace raygauge {
namespace {

double scale_of(const Eigen::MatrixXd& W) {
  const double size = W.cwiseAbs().rowwise().sum().maxCoeff();
  return size > 0 ? 1 / size : 1.0;
}

using Indices = std::vector<Eigen::Index>;

// W_PP r_P = -q_P.
Eigen::VectorXd solution_on(const Eigen::MatrixXd& W, const Eigen::VectorXd& q, const Indices& P) {
  return Eigen::MatrixXd(W(P, P)).ldlt().solve(-q(P));
}

void drop_zeros(Indices& P, Eigen::VectorXd& r) {
  const double zero = 1e-14 * r.cwiseAbs().maxCoeff();
  Indices kept;
  for (const Eigen::Index i : P) {
    if (r[i] > zero) kept.push_back(i);
    if (r[i] <= zero) r[i] = 0;
  }
  P = kept;
}

// Takes `next` into P. Where its velocity follows from those of P it grows in exchange for them, until one of
// them is 0 and leaves P. False: it may grow without end, and there is no solution.
bool take(Eigen::Index next, const Eigen::MatrixXd& W, Indices& P, Eigen::VectorXd& r) {
  constexpr double kDependent = 1e-12;
  const Eigen::VectorXd change = P.empty() ? Eigen::VectorXd() : solution_on(W, W.col(next), P);
  const double alone = W(next, next) + W(next, P).dot(change);
  double most = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < P.size(); ++i) {
    const double fall = -change[static_cast<Eigen::Index>(i)];
    if (fall > 0) most = std::min(most, r[P[i]] / fall);
  }
  if (alone <= kDependent * W(next, next)) {
    if (!std::isfinite(most)) return false;
    for (std::size_t i = 0; i < P.size(); ++i) r[P[i]] += most * change[static_cast<Eigen::Index>(i)];
    r[next] = most;
    drop_zeros(P, r);
  }
  P.push_back(next);
  return true;
}

// The way from r to the solution on P, until a number would be negative; such ones leave P. True: all the
// way.
bool go_to_solution(const Eigen::MatrixXd& W, const Eigen::VectorXd& q, Indices& P, Eigen::VectorXd& r) {
  const Eigen::VectorXd z = solution_on(W, q, P);
  double share = 1;
  for (std::size_t i = 0; i < P.size(); ++i) {
    const double now = r[P[i]], then = z[static_cast<Eigen::Index>(i)];
    if (then <= 0) share = std::min(share, now / std::max(now - then, 1e-300));
  }
  for (std::size_t i = 0; i < P.size(); ++i) r[P[i]] += share * (z[static_cast<Eigen::Index>(i)] - r[P[i]]);
  if (share >= 1) return true;
  drop_zeros(P, r);
  return false;
}

}  // namespace

double friction_residual(const FrictionProblem& problem, const Eigen::VectorXd& r) {
  if (problem.q.isZero(0)) return r.norm();
  const double s = scale_of(problem.W);
  const Eigen::VectorXd u = problem.W * r + problem.q;
  double square = 0;
  for (std::size_t c = 0; c < problem.mu.size(); ++c) {
    const auto at = 3 * static_cast<Eigen::Index>(c);
    Eigen::Vector3d changed = u.segment<3>(at);
    changed[0] += problem.mu[c] * changed.tail<2>().norm();
    const Eigen::Vector3d here = r.segment<3>(at);
    square += (here - nearest_in_cone(here - s * changed, problem.mu[c])).squaredNorm();
  }
  return std::sqrt(square) / (s * problem.q.norm());
}

Eigen::VectorXd nonnegative_solution(const Eigen::MatrixXd& W, const Eigen::VectorXd& q) {
  constexpr double kSmall = 1e-13;  // of |q|: velocities of approach that are rounding
  const Eigen::Index count = q.size();
  Eigen::VectorXd r = Eigen::VectorXd::Zero(count);
  Indices P;
  for (Eigen::Index k = 0; k < 3 * count + 10; ++k) {
    Eigen::VectorXd u = W * r + q;
    for (const Eigen::Index i : P) u[i] = 0;
    Eigen::Index worst = 0;
    if (!(u.minCoeff(&worst) < -kSmall * q.norm())) break;
    if (!take(worst, W, P, r)) break;
    while (!P.empty() && !go_to_solution(W, q, P, r)) {
    }
  }
  return r;
}

double nonnegative_residual(const Eigen::MatrixXd& W, const Eigen::VectorXd& q, const Eigen::VectorXd& r) {
  if (q.isZero(0)) return r.norm();
  const double s = scale_of(W);
  return (r - (r - s * (W * r + q)).cwiseMax(0)).norm() / (s * q.norm());
}

}  // namespace raygauge
