// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/friction_newton.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/simulation/tuning.h"

namespace raygauge {
namespace {

constexpr int kMostRounds = 60;
constexpr double kMore = 0.1;  // of enough: rounds that gain go on to there
constexpr int kStuck = 3;      // rounds without a step, after which it goes back to the best
constexpr int kMostSteps = 12, kMostHalves = 4;          // of a round, and of a step
constexpr double kLeastFirst = 1e-7, kMostFirst = 1e-3;  // κ, relative to W, at first the residual, ...
constexpr double kLeastSoftness = 1e-9, kMostSoftness = 1;
constexpr double kStiffer = 0.3, kSofter = 10;  // ... and how it changes
constexpr int kSoon = 2;                        // steps of a round after which κ falls twice
constexpr double kClose = 1e-3;                 // of F: that ends a round
constexpr double kFailed = 0.1;                 // of F: more than that at its end

auto part_of(const Eigen::VectorXd& r, std::size_t c) {
  return r.segment<3>(3 * static_cast<Eigen::Index>(c));
}

}  // namespace

IslandNewton::IslandNewton(const FrictionIsland& island, double bound)
    : island_(island),
      bound_(bound),
      size_of_q_(island.size_of_q()),
      step_(3 * static_cast<Eigen::Index>(island.contacts.size())),
      rows_(island.contacts.size()),
      factors_(island) {
  for (std::size_t c = 0; c < rows_.size(); ++c) {
    const IslandContact& contact = island.contacts[c];
    const Eigen::Matrix3d W = contact.A_a.transpose() * contact.A_a + contact.A_b.transpose() * contact.A_b;
    rows_[c].size = std::max(W.norm(), 1e-300);
    largest_ = std::max(largest_, W.diagonal().maxCoeff());
    rows_[c].places = factors_.places_of(contact);
  }
}

// F of the contact c.
inline Eigen::Vector3d IslandNewton::lacks(std::size_t c, const Eigen::Vector3d& r,
                                           const Eigen::Vector3d& u) const {
  const double rho = steepness_ / rows_[c].size, a = r[0] - rho * u[0];
  if (!(a > 0)) return r;
  const double x = r[1] - rho * u[1], y = r[2] - rho * u[2], radius = island_.contacts[c].mu * a;
  const double square = x * x + y * y;
  if (square <= radius * radius) return rho * u;
  const double share = radius / std::sqrt(square);
  return {rho * u[0], r[1] - share * x, r[2] - share * y};
}

// |F|, where the velocities of r are known.
double IslandNewton::look(const Eigen::VectorXd& r) {
  double square = 0;
  for (std::size_t c = 0; c < rows_.size(); ++c) {
    Row& row = rows_[c];
    row.u = velocities_.of(island_.contacts[c]) + softness_ * (part_of(r, c) - part_of(anchor_, c));
    row.F = lacks(c, part_of(r, c), row.u);
    square += row.F.squaredNorm();
  }
  return std::sqrt(square);
}

// |F| after a share of the step from r, which was looked at last.
double IslandNewton::after(double share, const Eigen::VectorXd& r) const {
  double square = 0;
  for (std::size_t c = 0; c < rows_.size(); ++c) {
    const Eigen::Vector3d u = rows_[c].u + share * rows_[c].by_step;
    square += lacks(c, part_of(r, c) + share * part_of(step_, c), u).squaredNorm();
  }
  return std::sqrt(square);
}

// (A + κ B)⁻¹ and that times B in closed form. With w the direction in which a contact slips, p across it and
// k = μ a / |r_t - ρ u_t| the lower right parts of A and B are 1 - k p pᵀ and ρ k p pᵀ, and the lower left
// ones -μ w and μ ρ w.
void IslandNewton::take_slope(std::size_t c, const Eigen::Vector3d& r) {
  Row& row = rows_[c];
  const double rho = steepness_ / row.size, mu = island_.contacts[c].mu, a = r[0] - rho * row.u[0];
  row.inverse.setIdentity();
  row.by_y.setZero();
  if (!(a > 0)) return;
  const double soft = softness_ * rho, radius = mu * a;
  const Eigen::Vector2d y = (r - rho * row.u).tail<2>();
  const double square = y.squaredNorm();
  if (mu > 0 && square <= radius * radius) {
    row.by_y.diagonal().setConstant(1 / softness_);
    row.inverse.diagonal().setConstant(1 / soft);
    return;
  }
  row.inverse(0, 0) = 1 / soft;
  row.by_y(0, 0) = 1 / softness_;
  if (!(mu > 0)) return;
  const double length = std::sqrt(square), k = radius / length;
  const Eigen::Vector2d w = y / length, p(-w[1], w[0]);
  const double across = 1 - (1 - soft) * k;
  row.inverse.bottomLeftCorner<2, 1>() = mu * (1 - soft) / soft * w;
  row.inverse.bottomRightCorner<2, 2>() = w * w.transpose() + p * p.transpose() / across;
  row.by_y.bottomLeftCorner<2, 1>() = mu / softness_ * w;
  row.by_y.bottomRightCorner<2, 2>() = rho * k / across * p * p.transpose();
}

// From r, which was looked at last.
void IslandNewton::find_step(const Eigen::VectorXd& r) {
  factors_.set_identity();
  y_.setZero(6, island_.bodies);
  for (std::size_t c = 0; c < rows_.size(); ++c) {
    take_slope(c, part_of(r, c));
    const IslandContact& contact = island_.contacts[c];
    const Row& row = rows_[c];
    const Eigen::Vector3d by_F = row.inverse * row.F;
    step_.segment<3>(3 * static_cast<Eigen::Index>(c)) = -by_F;
    push_bodies(contact, -by_F, y_);
    if (row.by_y(0, 0) != 0) factors_.add(contact, row.places, row.by_y);  // it is closed
  }
  factors_.factorize();
  factors_.solve(y_);
  for (std::size_t c = 0; c < rows_.size(); ++c) {
    const IslandContact& contact = island_.contacts[c];
    const Eigen::Vector3d u = with_bodies(contact, Eigen::Vector3d::Zero(), y_);
    auto step = step_.segment<3>(3 * static_cast<Eigen::Index>(c));
    step.noalias() -= rows_[c].by_y * u;
    rows_[c].by_step = u + softness_ * step;
  }
}

// The problem of soft contacts about r, from there. Gives how many steps it took; kMostSteps + 1: it is not
// solved.
int IslandNewton::solve_soft(Eigen::VectorXd& r) {
  anchor_ = r;
  ++stuck_;
  const double first = look(r);
  double size = first;
  int k = 0;
  for (; k < kMostSteps && size > kClose * first; ++k) {
    find_step(r);
    double share = 1, next = after(1, r);
    for (int half = 0; half < kMostHalves && !(next < (1 - share / 4) * size); ++half) {
      share /= 2;
      next = after(share, r);
    }
    if (!(next < size)) break;
    stuck_ = 0;
    r += share * step_;
    velocities_.reset(island_, r);
    size = look(r);
  }
  return size <= kFailed * first ? k : kMostSteps + 1;
}

double IslandNewton::improve(double steepness, double enough, Eigen::VectorXd& r, int patience) {
  steepness_ = steepness;
  Eigen::VectorXd here = r;
  velocities_.reset(island_, here);
  double best = island_residual(island_, bound_, here), gained = best;
  softness_ = std::clamp(best, kLeastFirst, kMostFirst) * largest_;
  stuck_ = 0;
  for (int round = 0, gained_at = 0; round < kMostRounds && best > kMore * enough; ++round) {
    const int steps = solve_soft(here);
    softness_ *= steps > kMostSteps ? kSofter : steps > kSoon ? kStiffer : kStiffer * kStiffer;
    softness_ = std::clamp(softness_, kLeastSoftness * largest_, kMostSoftness * largest_);
    const double residual = island_residual(island_, bound_, size_of_q_, velocities_, here);
    if (residual < best) {
      best = residual;
      r = here;
    }
    if (best < gained / 2) {
      gained = best;
      gained_at = round;
    }
    if (round > gained_at + (best <= enough ? 1 : patience)) break;
    if (stuck_ < kStuck) continue;
    here = r;
    velocities_.reset(island_, here);
    stuck_ = 0;
  }
  return best;
}

}  // namespace raygauge
