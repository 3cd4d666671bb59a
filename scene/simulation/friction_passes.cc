// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/friction_passes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/simulation/contact_lanes.h"
#include "scene/simulation/extrapolation.h"
#include "scene/simulation/tuning.h"

namespace raygauge {
namespace {

constexpr int kMostPasses = 600;
constexpr double kGain = 0.5;  // passes go on while the residual falls so much ...
constexpr int kMore = 8;       // ... within kPatienceOfPasses, or so many where it is small enough
constexpr double kNear = 100;  // times enough: of smaller changes every residual is looked at
constexpr double kWorse = 10;  // a pass that changes more than the best one by so much begins anew

/// Passes from r on until they gain nothing more; r is where the residual was least.
class Descent {
 public:
  Descent(const FrictionIsland& island, double bound, Eigen::VectorXd& r, double enough)
      : island_(island),
        bound_(bound),
        size_of_q_(island.size_of_q()),
        enough_(enough),
        lanes_(island),
        r_(r) {}

  double go() {
    if (!(size_of_q_ > 0)) {
      r_.setZero();
      return 0;
    }
    begin();
    if (best_ > enough_) pass();
    return island_residual(island_, bound_, r_);  // passes have it but for rounding
  }

 private:
  double residual(const Eigen::VectorXd& r) const {
    const double s = step_of(bound_);
    return std::sqrt(lanes_.error(s, r)) / (s * size_of_q_);
  }

  // At r, or at nothing where that is better.
  void begin() {
    lanes_.reset(r_);
    best_ = residual(r_);
    if (!r_.isZero(0)) {
      g_.setZero(r_.size());
      lanes_.reset(g_);
      const double of_nothing = residual(g_);
      if (!(best_ <= of_nothing)) {
        best_ = of_nothing;
        r_ = g_;
      }
    }
    gained_ = best_;
  }

  void pass() {
    Extrapolation extrapolation(r_.size());
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
    lanes_.pass(g_);
    f_ = g_ - here;
    const double size = f_.norm();
    if (size > kNear * enough_ * step_of(bound_) * size_of_q_ &&
        k % tuned::kPassesOfLook != tuned::kPassesOfLook - 1)
      return size;
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
    const int patience = enough_ > kSolvedFriction ? tuned::kPatienceOfRoughPasses
                         : best_ > kSolvedFriction ? tuned::kPatienceOfPasses
                                                   : kMore;
    return k > gained_at_ + patience;
  }

  const FrictionIsland& island_;
  double bound_, size_of_q_, enough_;
  IslandLanes lanes_;
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
