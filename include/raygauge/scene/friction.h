// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace raygauge {

/// Contacts of one island. With impulses r = (r_n, r_t1, r_t2) and velocities u = W r + q of each contact:
///
///     0 <= r_n  ⊥  u_n >= 0,     |r_t| <= μ r_n,     r_t against u_t and on the rim where u_t != 0.
struct FrictionProblem {
  Eigen::MatrixXd W;       ///< 3c × 3c
  Eigen::VectorXd q;       ///< 3c
  std::vector<double> mu;  ///< c
};

/// Solves friction problems. One a thread.
class FrictionSolver {
 public:
  virtual ~FrictionSolver() = default;
  FrictionSolver(const FrictionSolver&) = delete;
  FrictionSolver& operator=(const FrictionSolver&) = delete;

  /// Writes r, which on entry is a first guess.
  virtual void solve(const FrictionProblem& problem, Eigen::VectorXd& r) = 0;

 protected:
  FrictionSolver() = default;
};

/// The point of {r : |r_t| <= μ r_n} nearest to x = (x_n, x_t1, x_t2).
inline Eigen::Vector3d nearest_in_cone(const Eigen::Vector3d& x, double mu) {
  const double tangential = x.tail<2>().norm();
  if (tangential <= mu * x[0]) return x;
  if (mu * tangential <= -x[0]) return Eigen::Vector3d::Zero();
  const double normal = (x[0] + mu * tangential) / (1 + mu * mu);
  const double share = mu * normal / tangential;
  return {normal, share * x[1], share * x[2]};
}

/// How far r is from a solution, relative to |q|: with s = 1/‖W‖ and the velocities ũ = u + μ|u_t| e_n of De
/// Saxcé, |r - P_K(r - s ũ)| / (s |q|), P_K the projection to the cones of friction. 0 for q = 0.
double friction_residual(const FrictionProblem& problem, const Eigen::VectorXd& r);

/// min ½ rᵀW r + qᵀr over r >= 0, W positive semidefinite: contacts without friction, 0 <= r ⊥ W r + q >= 0.
/// Among velocities without approach it is the point nearest to the free one in the kinetic metric. Lawson
/// and Hanson's active sets.
Eigen::VectorXd nonnegative_solution(const Eigen::MatrixXd& W, const Eigen::VectorXd& q);

/// The same measure for them: |r - max(0, r - s (W r + q))| / (s |q|).
double nonnegative_residual(const Eigen::MatrixXd& W, const Eigen::VectorXd& q, const Eigen::VectorXd& r);

/// Of the library raygauge::friction, by Siconos numerics: nonsmooth Gauss-Seidel on the contacts, from the
/// first guess to a relative error of 1e-10 or 4000 passes, beyond which it gains little.
std::unique_ptr<FrictionSolver> siconos_friction();

}  // namespace raygauge
