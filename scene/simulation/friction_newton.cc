// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/friction_newton.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace raygauge {
namespace {

constexpr int kMostSteps = 30;
constexpr int kMostHalves = 16;      // of one step
constexpr double kSteep = 1e4;       // times ρ: bodies that slip by little are told from such that stick
constexpr double kEnough = 1e-14;    // of |q|: as small as rounding lets it be
constexpr double kRedundant = 1e-9;  // of W: contacts of one face on another share what they carry at will

/// The equations and their slope at r.
class Equations {
 public:
  Equations(const FrictionProblem& problem, double factor)
      : problem_(problem), size_(problem.q.size()), F_(size_), slope_(size_, size_) {
    W_ = problem.W;
    W_.diagonal().array() += kRedundant * problem.W.diagonal().maxCoeff();
    for (Eigen::Index at = 0; at < size_; at += 3)
      scale_.push_back(factor / std::max(problem.W.block<3, 3>(at, at).norm(), 1e-300));
  }

  /// |F|; F and the slope are kept if the latter is asked for.
  double look(const Eigen::VectorXd& r, bool slope) {
    u_ = problem_.W * r + problem_.q;
    if (slope) slope_.setZero();
    for (std::size_t c = 0; c < scale_.size(); ++c) look_at(c, r, slope);
    return F_.norm();
  }

  Eigen::VectorXd step() const { return slope_.partialPivLu().solve(-F_); }

 private:
  void look_at(std::size_t c, const Eigen::VectorXd& r, bool slope) {
    const auto at = 3 * static_cast<Eigen::Index>(c);
    const double rho = scale_[c], mu = problem_.mu[c];
    const double a = r[at] - rho * u_[at];
    F_.segment<3>(at) = r.segment<3>(at);
    if (slope) slope_.block<3, 3>(at, at).setIdentity();
    if (!(a > 0)) return;
    F_[at] = rho * u_[at];
    if (slope) slope_.row(at) = rho * W_.row(at);
    if (!(mu > 0)) return;
    const Eigen::Vector2d y = r.segment<2>(at + 1) - rho * u_.segment<2>(at + 1);
    const double length = y.norm(), radius = mu * a;
    if (length <= radius) {
      F_.segment<2>(at + 1) = rho * u_.segment<2>(at + 1);
      if (slope) slope_.middleRows<2>(at + 1) = rho * W_.middleRows<2>(at + 1);
      return;
    }
    const Eigen::Vector2d way = y / length;
    F_.segment<2>(at + 1) = r.segment<2>(at + 1) - radius * way;
    if (!slope) return;
    const Eigen::Matrix2d across = radius / length * (Eigen::Matrix2d::Identity() - way * way.transpose());
    slope_.middleRows<2>(at + 1) += rho * across * W_.middleRows<2>(at + 1);
    slope_.middleRows<2>(at + 1) += mu * rho * way * W_.row(at);
    slope_.block<2, 2>(at + 1, at + 1) -= across;
    slope_.block<2, 1>(at + 1, at) -= mu * way;
  }

  const FrictionProblem& problem_;
  Eigen::Index size_;
  Eigen::MatrixXd W_;
  std::vector<double> scale_;
  Eigen::VectorXd F_, u_;
  Eigen::MatrixXd slope_;
};

// Passes over the contacts, each brought nearer to its own law while the others stay.
void relax(const FrictionProblem& problem, int passes, Eigen::VectorXd& r) {
  constexpr int kInner = 5;
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t c = 0; c < problem.mu.size(); ++c) {
      const auto at = 3 * static_cast<Eigen::Index>(c);
      const Eigen::Matrix3d own = problem.W.block<3, 3>(at, at);
      const double rho = 1 / std::max(own.norm(), 1e-300);
      Eigen::Vector3d u = problem.W.middleRows<3>(at) * r + problem.q.segment<3>(at);
      for (int inner = 0; inner < kInner; ++inner) {
        const Eigen::Vector3d before = r.segment<3>(at);
        Eigen::Vector3d changed = u;
        changed[0] += problem.mu[c] * u.tail<2>().norm();
        r.segment<3>(at) = nearest_in_cone(before - rho * changed, problem.mu[c]);
        u += own * (r.segment<3>(at) - before);
      }
    }
  }
}

double newton(const FrictionProblem& problem, Equations& equations, Eigen::VectorXd& r) {
  double best = friction_residual(problem, r);
  if (!(best > kEnough)) return best;
  Eigen::VectorXd here = r;
  double size = equations.look(here, true);
  for (int k = 0; k < kMostSteps; ++k) {
    const Eigen::VectorXd step = equations.step();
    if (!step.allFinite()) break;
    double share = 1, next = 0;
    for (int half = 0; half < kMostHalves; ++half) {
      next = equations.look(here + share * step, false);
      if (next < (1 - share / 4) * size) break;
      share /= 2;
    }
    if (!(next < size)) break;
    here += share * step;
    const double residual = friction_residual(problem, here);
    if (residual < best) {
      best = residual;
      r = here;
    }
    if (best <= kEnough) break;
    size = equations.look(here, true);
  }
  return best;
}

}  // namespace

double improve_friction(const FrictionProblem& problem, Eigen::VectorXd& r, int rounds) {
  constexpr double kSolved = 1e-11;
  double best = friction_residual(problem, r);
  if (!(best > kEnough)) return best;
  Equations usual(problem, 1), steep(problem, kSteep);
  Eigen::VectorXd relaxed = r;
  best = newton(problem, usual, r);
  if (best > kSolved) best = newton(problem, steep, r);
  for (int round = 0, passes = 5; round < rounds && best > kSolved; ++round, passes = passes * 3 / 2) {
    relax(problem, passes, relaxed);
    for (Equations* const equations : {&usual, &steep}) {
      Eigen::VectorXd trial = relaxed;
      const double found = newton(problem, *equations, trial);
      if (found >= best) continue;
      best = found;
      r = trial;
    }
  }
  return best;
}

}  // namespace raygauge
