// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/friction_passes.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace raygauge {
namespace {

constexpr int kMostPasses = 600;
constexpr double kGain = 0.5;        // passes go on while the residual falls so much ...
constexpr int kPatience = 30;        // ... within so many of them, ...
constexpr int kRough = 10;           // ... or within so many where a rough answer is enough, ...
constexpr int kMore = 8;             // ... or within so many where it is small enough
constexpr double kNear = 100;        // times enough: a change, as a residual, from which on every pass ...
constexpr int kFar = 8;              // ... is measured; of others every eighth
constexpr Eigen::Index kMemory = 8;  // passes that are extrapolated
constexpr double kWorse = 10;        // a pass that changes more than the best one by so much begins anew

// What does not change of a contact from pass to pass.
struct Own {
  Eigen::Matrix3d W, inverse;
  double rate = 0;  // 1 / the mean of W across the normal
};

// Steps of projection to the cone, which come nearer always.
Eigen::Vector3d nearer(const Own& own, double mu, const Eigen::Vector3d& b, Eigen::Vector3d r) {
  constexpr int kSteps = 8;
  const double rate = 1 / own.W.norm();
  for (int step = 0; step < kSteps; ++step) {
    Eigen::Vector3d changed = own.W * r + b;
    changed[0] += mu * changed.tail<2>().norm();
    r = nearest_in_cone(r - rate * changed, mu);
  }
  return r;
}

// Towards 0 <= r_n ⊥ u_n >= 0 and Coulomb's law with u = W r + b. What slips turns once into the direction
// that r so far asks for. `last`: it is near that.
Eigen::Vector3d solved(const Own& own, double mu, const Eigen::Vector3d& b, const Eigen::Vector3d& last) {
  if (b[0] >= 0) return Eigen::Vector3d::Zero();
  if (!(mu > 0)) return {-b[0] / own.W(0, 0), 0, 0};
  Eigen::Vector3d sticks = -(own.inverse * b);
  if (sticks.tail<2>().norm() <= mu * sticks[0]) return sticks;
  Eigen::Vector3d r = last[0] > 0 ? last : sticks;
  const Eigen::Vector2d u = b.tail<2>() + own.W.bottomRows<2>() * r;
  const Eigen::Vector2d way = r.tail<2>() - own.rate * u;
  const double length = way.norm();
  const double slope = own.W(0, 0) + mu / length * own.W.topRightCorner<1, 2>().dot(way);
  if (!(length > 0 && slope > 0)) return nearer(own, mu, b, last);
  r[0] = -b[0] / slope;
  r.tail<2>() = mu * r[0] / length * way;
  return u.dot(way) > 0 ? nearer(own, mu, b, last) : r;
}

/// One pass after the other.
class Passes {
 public:
  explicit Passes(const FrictionIsland& island) : island_(island) {
    own_.reserve(island.contacts.size());
    for (const IslandContact& contact : island.contacts) {
      Own& one = own_.emplace_back();
      one.W = contact.A_a.transpose() * contact.A_a + contact.A_b.transpose() * contact.A_b;
      if (!(one.W(2, 2) > 0)) one.W(2, 2) = one.W(0, 0);  // in the plane
      one.inverse = one.W.inverse();
      one.rate = 2 / (one.W(1, 1) + one.W(2, 2));
    }
  }

  /// Gives the velocities that go with the new r.
  void pass(IslandVelocities& velocities, Eigen::VectorXd& r) const {
    velocities.reset(island_, r);
    for (std::size_t c = 0; c < own_.size(); ++c) {
      const IslandContact& contact = island_.contacts[c];
      auto here = r.segment<3>(3 * static_cast<Eigen::Index>(c));
      const Eigen::Vector3d before = here;
      const Eigen::Vector3d b = velocities.of(contact) - own_[c].W * before;
      here = solved(own_[c], contact.mu, b, before);
      velocities.push(contact, here - before);
    }
  }

 private:
  const FrictionIsland& island_;
  std::vector<Own> own_;
};

/// Anderson's extrapolation of r -> g(r): of what was seen, the combination whose changes g - r cancel best.
class Extrapolation {
 public:
  void forget() { count_ = 0; }

  /// Where to go on after r with the change f = g - r and the value g.
  void next(const Eigen::VectorXd& f, const Eigen::VectorXd& g, Eigen::VectorXd& here) {
    if (count_ == 0) {
      changes_.resize(f.size(), kMemory);
      values_.resize(f.size(), kMemory);
    } else {
      const Eigen::Index at = (count_ - 1) % kMemory;
      changes_.col(at) = f - f_;
      values_.col(at) = g - g_;
      learn(at);
    }
    f_ = f;
    g_ = g;
    here = g;
    const Eigen::Index known = std::min(count_++, kMemory);
    if (known == 0) return;
    Square products = products_.topLeftCorner(known, known);
    products.diagonal() *= 1 + kRounding;
    const Few shares = products.ldlt().solve(changes_.leftCols(known).transpose() * f);
    if (shares.allFinite()) here.noalias() -= values_.leftCols(known) * shares;
  }

 private:
  static constexpr double kRounding = 1e-13;
  using Few = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMemory, 1>;
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMemory, kMemory>;

  void learn(Eigen::Index at) {
    const Eigen::Index known = std::min(count_, kMemory);
    products_.col(at).head(known).noalias() = changes_.leftCols(known).transpose() * changes_.col(at);
    products_.row(at).head(known) = products_.col(at).head(known);
  }

  Eigen::Index count_ = 0;
  Eigen::MatrixXd changes_, values_;
  Eigen::Matrix<double, kMemory, kMemory> products_;
  Eigen::VectorXd f_, g_;
};

/// Passes from r on until they gain nothing more; r is where the residual was least.
class Descent {
 public:
  Descent(const FrictionIsland& island, double bound, Eigen::VectorXd& r, double enough)
      : island_(island),
        bound_(bound),
        size_of_q_(island.size_of_q()),
        enough_(enough),
        passes_(island),
        r_(r) {}

  double go() {
    if (!(size_of_q_ > 0)) {
      r_.setZero();
      return 0;
    }
    begin();
    if (!(best_ > enough_)) return best_;
    pass();
    velocities_.reset(island_, r_);  // passes have them but for rounding
    return residual(r_);
  }

 private:
  double residual(const Eigen::VectorXd& r) const {
    return island_residual(island_, bound_, size_of_q_, velocities_, r);
  }

  // At r, or at nothing where that is better.
  void begin() {
    velocities_.reset(island_, r_);
    best_ = residual(r_);
    if (!r_.isZero(0)) {
      g_.setZero(r_.size());
      velocities_.reset(island_, g_);
      const double of_nothing = residual(g_);
      if (!(best_ <= of_nothing)) {
        best_ = of_nothing;
        r_ = g_;
      }
    }
    gained_ = best_;
  }

  void pass() {
    Extrapolation extrapolation;
    Eigen::VectorXd here = r_;
    double last = std::numeric_limits<double>::infinity();
    for (int k = 0; k < kMostPasses && best_ > enough_; ++k) {
      const double size = pass_from(k, here);
      if (!(size > 0) || has_stalled(k)) break;
      if (size <= kWorse * last) {
        last = std::min(last, size);
        extrapolation.next(f_, g_, here);
      } else {  // the extrapolation has left what it was learnt from
        extrapolation.forget();
        last = std::numeric_limits<double>::infinity();
        here = r_;
      }
    }
  }

  // To g_, by f_. Gives the size of that. A residual takes as long as half a pass.
  double pass_from(int k, const Eigen::VectorXd& here) {
    g_ = here;
    passes_.pass(velocities_, g_);
    f_ = g_ - here;
    const double size = f_.norm();
    if (size > kNear * enough_ * step_of(bound_) * size_of_q_ && k % kFar != kFar - 1) return size;
    const double residual = this->residual(g_);
    if (residual < best_) {
      best_ = residual;
      r_ = g_;
    }
    if (best_ < kGain * gained_) {
      gained_ = best_;
      gained_at_ = k;
    }
    return size;
  }

  bool has_stalled(int k) const {
    const int patience = enough_ > kSolvedFriction ? kRough : best_ > kSolvedFriction ? kPatience : kMore;
    return k > gained_at_ + patience;
  }

  const FrictionIsland& island_;
  double bound_, size_of_q_, enough_;
  Passes passes_;
  IslandVelocities velocities_;
  Eigen::VectorXd& r_;
  Eigen::VectorXd g_, f_;  // where the last pass has led, and from where it began to there
  double best_ = 0, gained_ = 0;
  int gained_at_ = 0;
};

}  // namespace

double pass_over_friction(const FrictionIsland& island, double bound, Eigen::VectorXd& r, double enough) {
  return Descent(island, bound, r, enough).go();
}

}  // namespace raygauge
