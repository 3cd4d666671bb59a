// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/friction_jam.h"

#include <cmath>
#include <utility>

#include "scene/simulation/body_factors.h"

namespace raygauge {
namespace {

constexpr int kMostSteps = 50;
constexpr int kMostHalves = 30;
constexpr double kFaster = 1e4;   // velocities that are refuted, times those that are asked for
constexpr double kSlight = 1e-7;  // of |q|: what velocities lack that is not looked into
constexpr double kFirm = 1e-10;   // of W: added to slopes that may be singular

// How nearest_in_cone() changes with x.
Eigen::Matrix3d cone_slope(const Eigen::Vector3d& x, double mu) {
  const double tangential = x.tail<2>().norm();
  if (tangential <= mu * x[0]) return Eigen::Matrix3d::Identity();
  if (mu * tangential <= -x[0]) return Eigen::Matrix3d::Zero();
  if (!(mu > 0)) return Eigen::Vector3d::UnitX() * Eigen::RowVector3d::UnitX();
  const Eigen::Vector2d way = x.tail<2>() / tangential;
  const Eigen::Vector3d rim(1, mu * way[0], mu * way[1]);
  const double normal = (x[0] + mu * tangential) / (1 + mu * mu);
  Eigen::Matrix3d slope = rim * rim.transpose() / (1 + mu * mu);
  slope.bottomRightCorner<2, 2>() +=
      mu * normal / tangential * (Eigen::Matrix2d::Identity() - way * way.transpose());
  return slope;
}

auto part(Eigen::VectorXd& r, std::size_t c) { return r.segment<3>(3 * static_cast<Eigen::Index>(c)); }

/// Newton's method on half the squared distance of the velocities Aᵀy + q from the dual cones {u_n >=
/// μ|u_t|}. The nearest points of -Aᵀy - q in the cones are what the velocities lack; where the distance is
/// least, they are impulses r with Σ A r = 0, and rᵀq = -|r|².
class Lack {
 public:
  explicit Lack(const FrictionIsland& island)
      : island_(island),
        factors_(island),
        bound_(island.bound_of_W()),
        size_of_q_(island.size_of_q()),
        y_(BodyColumns::Zero(6, island.bodies)),
        r_(3 * static_cast<Eigen::Index>(island.contacts.size())) {}

  std::optional<Eigen::VectorXd> impulses() {
    double size = look(y_);
    for (int k = 0; k < kMostSteps && r_.norm() > kSlight * size_of_q_; ++k) {
      const BodyColumns push = this->push();
      if (refutes(push)) return r_;
      const BodyColumns step = this->step(push), from = y_;
      const double slope = push.cwiseProduct(step).sum();
      double share = 1;
      double next = look(y_ = from + step);
      for (int half = 0; half < kMostHalves && !(next <= size - share / 4 * slope); ++half) {
        share /= 2;
        next = look(y_ = from + share * step);
      }
      if (!(next < size)) break;
      size = next;
    }
    return std::nullopt;
  }

 private:
  // rᵀ(Aᵀy' + q) = (Σ A r)ᵀ(y' - y) - |r|², which is below 0 of all y' that are not so far from y.
  bool refutes(const BodyColumns& push) const {
    const double fast = kFaster * (y_.norm() + size_of_q_ / std::sqrt(bound_));
    return push.norm() * fast < r_.squaredNorm();
  }

  // Half the squared distance, and r.
  double look(const BodyColumns& y) {
    for (std::size_t c = 0; c < island_.contacts.size(); ++c) {
      const IslandContact& contact = island_.contacts[c];
      part(r_, c) = nearest_in_cone(-with_bodies(contact, contact.q, y), contact.mu);
    }
    return r_.squaredNorm() / 2;
  }

  // Σ A r: the slope of the distance, downwards.
  BodyColumns push() {
    BodyColumns sum = BodyColumns::Zero(6, island_.bodies);
    for (std::size_t c = 0; c < island_.contacts.size(); ++c)
      push_bodies(island_.contacts[c], part(r_, c), sum);
    return sum;
  }

  BodyColumns step(const BodyColumns& push) {
    const double firm = kFirm * bound_;
    factors_.set_identity();
    for (const IslandContact& contact : island_.contacts) {
      const Eigen::Matrix3d slope = cone_slope(-with_bodies(contact, contact.q, y_), contact.mu) / firm;
      factors_.add(contact, factors_.places_of(contact), slope);
    }
    factors_.factorize();
    BodyColumns step = push / firm;
    factors_.solve(step);
    return step;
  }

  const FrictionIsland& island_;
  BodyFactors factors_;
  double bound_, size_of_q_;
  BodyColumns y_;
  Eigen::VectorXd r_;
};

}  // namespace

std::optional<Eigen::VectorXd> jam_of(const FrictionIsland& island) { return Lack(island).impulses(); }

}  // namespace raygauge
