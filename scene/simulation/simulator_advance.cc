// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "raygauge/exceptions.h"
#include "scene/simulation/simulator.h"

// Steps of another engine: its motion, and what is proven of it.
namespace raygauge {
namespace {

// The angular velocity that turns `first` into `last` within dt. Of those that do, the one nearest to `spin`.
Eigen::Vector3d even_spin(const Eigen::Matrix3d& first, const Eigen::Matrix3d& last,
                          const Eigen::Vector3d& spin, double dt) {
  const Eigen::AngleAxisd turn(last * first.transpose());
  const double whole = 2 * std::numbers::pi;
  const double more = std::round((turn.axis().dot(spin) * dt - turn.angle()) / whole);
  return (turn.angle() + whole * more) / dt * turn.axis();
}

}  // namespace

void Simulator::advance(double to) {
  std::vector<BodyState> states;
  for (const SimulatedBody& body : bodies_) states.push_back({body.x, body.R, body.v, body.spin});
  hooks_.advance(to, states);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    SimulatedBody& body = bodies_[b];
    const BodyState& then = states[b];
    if (!body.reacts()) continue;
    if (!(then.x.allFinite() && then.R.allFinite() && then.v.allFinite() && then.spin.allFinite()))
      throw Error("simulation: the engine has lost the body '" + out_.scene.bodies[b].name + "' at " +
                  std::to_string(to) + " s");
    TwistMotion::Rates rates;
    rates.velocity = SmallVector(((then.x - body.x) / (to - t_)).head(n_));
    rates.spin = even_spin(body.R, then.R, then.spin, to - t_);
    const Placement first{SmallMatrix(body.R.topLeftCorner(n_, n_)), SmallVector(body.x.head(n_))};
    body.piece = {t_, first, rates};
    body.motion = std::make_shared<TwistMotion>(first, rates, t_);
    log_.pieces[b].push_back(body.piece);
  }
  while (dynamics_.contact && t_ < to) {
    double end = to;
    for (const SimulatedBody& body : bodies_) end = std::min(end, body.motion->next_break(t_));
    row_.least_distance = std::min(row_.least_distance, pairs_->least_distance(t_, end));
    t_ = end;
  }
  t_ = to;
  ++row_.substeps;
  row_.residual = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    SimulatedBody& body = bodies_[b];
    if (!body.reacts()) continue;
    body.x = states[b].x;
    body.R = states[b].R;
    body.v = states[b].v;
    body.spin = states[b].spin;
    body.L = body.R * body.rotor.J * body.R.transpose() * body.spin;
  }
}

}  // namespace raygauge
