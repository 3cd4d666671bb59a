// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/friction_newton.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/simulation/friction_passes.h"

namespace raygauge {
namespace {

constexpr int kMostSteps = 30;
constexpr int kMostHalves = 16;      // of one step
constexpr double kSteep = 1e4;       // times ρ: bodies that slip by little are told from such that stick
constexpr double kEnough = 1e-12;    // residual that ends the steps
constexpr double kRedundant = 1e-9;  // of W: contacts of one face on another share what they carry at will

auto part_of(const Eigen::VectorXd& r, std::size_t c) {
  return r.segment<3>(3 * static_cast<Eigen::Index>(c));
}

}  // namespace

IslandNewton::IslandNewton(const FrictionIsland& island, double bound)
    : island_(island), bound_(bound), rows_(island.contacts.size()), factors_(island) {
  for (std::size_t c = 0; c < rows_.size(); ++c) {
    const IslandContact& contact = island.contacts[c];
    const Eigen::Matrix3d W = contact.A_a.transpose() * contact.A_a + contact.A_b.transpose() * contact.A_b;
    rows_[c].rho = 1 / std::max(W.norm(), 1e-300);
    largest_ = std::max(largest_, W.diagonal().maxCoeff());
  }
}

// |F|.
double IslandNewton::look(const Eigen::VectorXd& r) {
  velocities_.reset(island_, r);
  double square = 0;
  for (std::size_t c = 0; c < rows_.size(); ++c) {
    look_at(c, part_of(r, c));
    square += rows_[c].F.squaredNorm();
  }
  return std::sqrt(square);
}

void IslandNewton::look_at(std::size_t c, const Eigen::Vector3d& r) {
  Row& row = rows_[c];
  const double rho = factor_ * row.rho, mu = island_.contacts[c].mu;
  row.u = velocities_.of(island_.contacts[c]) + softness_ * r;
  row.F = r;
  const double a = r[0] - rho * row.u[0];
  if (!(a > 0)) return;
  row.F[0] = rho * row.u[0];
  if (!(mu > 0)) return;
  const Eigen::Vector2d y = (r - rho * row.u).tail<2>();
  const double length = y.norm(), radius = mu * a;
  if (length <= radius)
    row.F.tail<2>() = rho * row.u.tail<2>();
  else
    row.F.tail<2>() -= radius / length * y;
}

void IslandNewton::take_slope(std::size_t c, const Eigen::Vector3d& r) {
  Row& row = rows_[c];
  const double rho = factor_ * row.rho, mu = island_.contacts[c].mu;
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity(), B = Eigen::Matrix3d::Zero();
  const double a = r[0] - rho * row.u[0];
  if (a > 0) {
    A(0, 0) = 0;
    B(0, 0) = rho;
  }
  if (a > 0 && mu > 0) {
    const Eigen::Vector2d y = (r - rho * row.u).tail<2>();
    const double length = y.norm(), radius = mu * a;
    if (length <= radius) {
      A.bottomRightCorner<2, 2>().setZero();
      B.bottomRightCorner<2, 2>() = rho * Eigen::Matrix2d::Identity();
    } else {
      const Eigen::Vector2d way = y / length;
      const Eigen::Matrix2d across = radius / length * (Eigen::Matrix2d::Identity() - way * way.transpose());
      A.bottomRightCorner<2, 2>() -= across;
      A.bottomLeftCorner<2, 1>() = -mu * way;
      B.bottomRightCorner<2, 2>() = rho * across;
      B.bottomLeftCorner<2, 1>() = mu * rho * way;
    }
  }
  row.inverse = (A + (softness_ + kRedundant * largest_) * B).inverse();
  row.by_y = row.inverse * B;
}

double IslandNewton::residual(const Eigen::VectorXd& r) const {
  const double s = step_of(bound_ + softness_);
  double square = 0;
  for (std::size_t c = 0; c < rows_.size(); ++c)
    square += law_error(island_.contacts[c].mu, rows_[c].u, s, part_of(r, c));
  return std::sqrt(square) / (s * size_of_q_);
}

// From r, which was looked at last.
Eigen::VectorXd IslandNewton::step(const Eigen::VectorXd& r) {
  factors_.set_identity();
  BodyFactors::Columns y = BodyFactors::Columns::Zero(6, island_.bodies);
  for (std::size_t c = 0; c < rows_.size(); ++c) {
    take_slope(c, part_of(r, c));
    const IslandContact& contact = island_.contacts[c];
    const Row& row = rows_[c];
    const Eigen::Vector3d by_F = row.inverse * row.F;
    for (const auto& [i, G] : {std::pair(contact.a, &contact.A_a), std::pair(contact.b, &contact.A_b)}) {
      if (i < 0) continue;
      y.col(i).noalias() -= *G * by_F;
      const ContactSlope moved = *G * row.by_y;
      for (const auto& [j, H] : {std::pair(contact.a, &contact.A_a), std::pair(contact.b, &contact.A_b)}) {
        if (j >= 0) factors_.add(i, j, moved * H->transpose());
      }
    }
  }
  factors_.factorize();
  factors_.solve(y);
  Eigen::VectorXd change(r.size());
  for (std::size_t c = 0; c < rows_.size(); ++c) {
    const IslandContact& contact = island_.contacts[c];
    Eigen::Vector3d u = Eigen::Vector3d::Zero();
    if (contact.a >= 0) u += contact.A_a.transpose() * y.col(contact.a);
    if (contact.b >= 0) u += contact.A_b.transpose() * y.col(contact.b);
    change.segment<3>(3 * static_cast<Eigen::Index>(c)) =
        -(rows_[c].inverse * rows_[c].F) - rows_[c].by_y * u;
  }
  return change;
}

double IslandNewton::descend(double factor, double best, Eigen::VectorXd& r) {
  factor_ = factor;
  Eigen::VectorXd here = r;
  double size = look(here);
  for (int k = 0; k < kMostSteps && best > (softness_ > 0 ? kSolvedFriction : kEnough); ++k) {
    const Eigen::VectorXd step = this->step(here);
    if (!step.allFinite()) break;
    double share = 1, next = look(here + step);
    for (int half = 0; half < kMostHalves && !(next < (1 - share / 4) * size); ++half) {
      share /= 2;
      next = look(here + share * step);
    }
    if (!(next < size)) break;
    here += share * step;
    size = next;
    const double residual = this->residual(here);
    if (!(residual < best)) continue;
    best = residual;
    r = here;
  }
  return best;
}

double IslandNewton::improve(double softness, Eigen::VectorXd& r) {
  softness_ = softness;
  factor_ = 1;
  size_of_q_ = island_.size_of_q();
  look(r);
  double best = residual(r);
  best = descend(1, best, r);
  return best > kSolvedFriction ? descend(kSteep, best, r) : best;
}

double IslandNewton::stiffen(const Eigen::VectorXd& start, double residual, Eigen::VectorXd& r) {
  constexpr double kSoftest = 1e-2, kStiffer = 0.1;  // of W
  constexpr int kSteps = 8;
  double softness = kSoftest * largest_;
  Eigen::VectorXd trial = start;
  for (int step = 0; step < kSteps; ++step) {
    if (improve(softness, trial) > kSolvedFriction) break;
    softness *= kStiffer;
  }
  const double found = improve(0, trial);
  if (!(found < residual)) return residual;
  r = std::move(trial);
  return found;
}

}  // namespace raygauge
