// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/soak/exact_motions.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/number_text.h"
#include "raygauge/scene/motion.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "tests/scene/exact_motion.h"

namespace raygauge::soak {
namespace {

using exact_motion::QuadVector;
using Outcome = ImpactResult::Outcome;

constexpr double kHalfWidth = 3;  // of the box, across the way

double power_of_ten(RandomStream& stream, double least, double most) {
  return std::pow(10.0, least + (most - least) * stream.uniform());
}

double between(RandomStream& stream, double least, double most) {
  return least + (most - least) * stream.uniform();
}

}  // namespace

ExactMotion::ExactMotion(RandomStream& stream) {
  const double kind = stream.uniform();
  radius_ = between(stream, 0.1, 1);
  place_ = kind < 0.35   ? draw_rest(stream)
           : kind < 0.55 ? draw_reversal(stream)
           : kind < 0.75 ? draw_turn(stream)
                         : draw_chain(stream);
  nearest_ = farthest(0, stop_);
  const double gap = terms_ * power_of_ten(stream, -20, -6) * (stream.uniform() < 0.5 ? 1 : -1);
  face_ = static_cast<double>(place_(nearest_)[0] + radius_ + gap);
}

// x0 + v t + a t²/2, turned around within the time.
ExactMotion::Place ExactMotion::draw_rest(RandomStream& stream) {
  kind_ = "rest";
  stop_ = power_of_ten(stream, -2, 2);
  terms_ = power_of_ten(stream, 0, 8);
  const double rest = between(stream, 0.2, 1.2) * stop_;
  TwistMotion::Rates rates;
  rates.acceleration = Eigen::Vector3d(-2 * terms_ / (rest * rest), 0, 0);
  rates.velocity = -rest * rates.acceleration;
  if (stream.uniform() < 0.3) rates.spin = Eigen::Vector3d(between(stream, -9, 9), 0, 0) / stop_;
  Placement first = Placement::identity(3);
  first.t << -terms_, between(stream, -1, 1), between(stream, -1, 1);
  const double start = stream.uniform() < 0.3 ? 0.0 : between(stream, -1, 0) * stop_;
  motion_ = std::make_shared<TwistMotion>(first, rates, start);
  return [=](Quad t) { return exact_motion::twist(first, rates, start, t).t; };
}

// To a keyframe and back, with a turn about the way of the ball or none.
ExactMotion::Place ExactMotion::draw_reversal(RandomStream& stream) {
  kind_ = "reversal";
  stop_ = power_of_ten(stream, -3, 2);
  terms_ = power_of_ten(stream, 0, 8);
  const std::vector<double> times = {0, between(stream, 0.1, 0.9) * stop_, stop_};
  std::vector<Placement> frames;
  for (const double x : {-terms_, between(stream, -1, 1), -terms_ * stream.uniform() - 2}) {
    frames.push_back(Placement::identity(3));
    frames.back().t[0] = x;
    if (stream.uniform() < 0.5) frames.back().R = rotation_about({between(stream, -1.5, 1.5), 0, 0});
  }
  motion_ = std::make_shared<KeyframeMotion>(times, frames);
  return [=](Quad t) { return exact_motion::keyframes(times, frames, t).t; };
}

// A ball off the origin of a body that spins, far from the origin of the scene or not.
ExactMotion::Place ExactMotion::draw_turn(RandomStream& stream) {
  kind_ = "turn";
  stop_ = power_of_ten(stream, -2, 1);
  terms_ = power_of_ten(stream, 0, 5);
  TwistMotion::Rates rates;
  rates.velocity = Eigen::Vector3d::Zero();
  rates.spin = Eigen::Vector3d(0, 0, between(stream, 1, 60)) / stop_;
  if (stream.uniform() < 0.5) rates.spin.head(2) = Eigen::Vector2d(between(stream, -3, 3), 2) / stop_;
  center_ = Eigen::Vector3d(between(stream, -2, 2), between(stream, -1, 1), between(stream, -1, 1));
  Placement first = Placement::identity(3);
  first.t[0] = terms_ * between(stream, -1, 1);
  motion_ = std::make_shared<TwistMotion>(first, rates, 0.0);
  const QuadVector center = exact_motion::quad_vector(center_);
  return [=](Quad t) { return exact_motion::twist(first, rates, 0.0, t)(center); };
}

// Two links as long as all terms, the second folded back onto the first, both turning by what moves the end
// by a length of 1 or so; between them sometimes a joint that slides back.
ExactMotion::Place ExactMotion::draw_chain(RandomStream& stream) {
  kind_ = "chain";
  stop_ = power_of_ten(stream, -1, 1);
  terms_ = power_of_ten(stream, 0, 6);
  auto tree = std::make_shared<KinematicTree>();
  auto trajectory = std::make_shared<JointTrajectory>();
  trajectory->times = {0, between(stream, 0.1, 0.9) * stop_, stop_};
  trajectory->values = Eigen::MatrixXd::Zero(3, 3);
  const bool slides = stream.uniform() < 0.3;
  for (int i = 0; i < 3; ++i) {
    TreeLink link;
    link.parent = i - 1;
    link.origin = Placement::identity(3);
    if (i == 1 || (i == 2 && !slides)) link.origin.t[0] = terms_;
    link.kind = i == 2 && slides ? JointKind::prismatic : JointKind::revolute;
    link.axis = i == 2 && slides ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitZ();
    link.joint = i;
    if (i == 1 && !slides) link.offset = EIGEN_PI;
    if (i == 2 && slides) link.offset = -terms_;
    const double swing = i == 2 && !slides ? 3 : 1 / terms_;
    for (int k = 0; k < 3; ++k) trajectory->values(i, k) = between(stream, -swing, swing);
    if (i == 2 && slides) trajectory->values.row(i) *= terms_;
    tree->links.push_back(link);
  }
  const Placement base = Placement::identity(3);
  center_ = Eigen::Vector3d(between(stream, -1, 1), between(stream, -1, 1), 0);
  motion_ = std::make_shared<LinkMotion>(tree, trajectory, base, 2);
  const QuadVector center = exact_motion::quad_vector(center_);
  return [=](Quad t) { return exact_motion::link(*tree, *trajectory, base, 2, t)(center); };
}

/// The moment of [from, to] at which the ball's centre is farthest along x: of a grid, then a golden section.
double ExactMotion::farthest(double from, double to) const {
  constexpr int kMoments = 48, kNarrowings = 90;
  const double step = (to - from) / kMoments;
  double best = from;
  Quad most = place_(from)[0];
  const auto try_at = [&](double t) {
    const Quad x = place_(t)[0];
    if (x > most) best = t, most = x;
    return x;
  };
  for (int k = 1; k <= kMoments; ++k) try_at(std::min(to, from + k * step));
  double low = std::max(from, best - step), high = std::min(to, best + step);
  const double share = (std::sqrt(5.0) - 1) / 2;
  for (int k = 0; k < kNarrowings && high - low > 1e-16 * stop_; ++k) {
    const double inner = high - share * (high - low), outer = low + share * (high - low);
    if (try_at(inner) >= try_at(outer)) {
      high = outer;
    } else {
      low = inner;
    }
  }
  return best;
}

/// Of the ball and the box; negative: how deep the ball's surface is inside.
Quad ExactMotion::distance(double t) const {
  const QuadVector c = place_(t);
  const QuadVector beyond{
      c[0] < Quad(face_) ? face_ - c[0] : (c[0] > Quad(face_) + 1 ? c[0] - face_ - 1 : Quad(0)),
      std::max(Quad(0), elementary::fabs(c[1]) - kHalfWidth),
      std::max(Quad(0), elementary::fabs(c[2]) - kHalfWidth)};
  return exact_motion::norm(beyond) - radius_;
}

std::string ExactMotion::text(const ImpactResult& impact, const ClearanceResult& found) const {
  return kind_ + ", terms " + shortest_text(terms_) + ", nearest " +
         shortest_text(static_cast<double>(distance(nearest_))) + " at " + shortest_text(nearest_) +
         ": impact " + std::to_string(static_cast<int>(impact.outcome)) + " [" + shortest_text(impact.lower) +
         ", " + shortest_text(impact.upper) + "], clearance [" + shortest_text(found.lower) + ", " +
         shortest_text(found.upper) + "] at " + shortest_text(found.time) +
         (found.touches ? ", touches" : "");
}

std::optional<std::string> ExactMotion::check(bool& undecided) {
  const Body ball = make_body("ball", {std::make_shared<Ball>(center_, radius_)}, motion_);
  const auto box = std::make_shared<Box>(Eigen::Vector3d(face_, -kHalfWidth, -kHalfWidth),
                                         Eigen::Vector3d(face_ + 1, kHalfWidth, kHalfWidth));
  const Body wall = make_body("wall", {box}, std::make_shared<StaticMotion>(Placement::identity(3)));
  const Quad least = distance(nearest_);
  ContinuousOptions over;
  over.to = stop_;
  over.contact = std::max(1e-14, 1e-3 * std::fabs(static_cast<double>(least)));
  over.max_steps = 20'000;
  ContinuousSolver solver(3);
  const ImpactResult impact = solver.time_of_impact(ball, wall, over);
  const ClearanceResult found = solver.clearance(ball, wall, SceneMetric(), nullptr, over);
  undecided = impact.outcome == Outcome::undecided;
  const bool contact = impact.outcome == Outcome::contact;
  std::string wrong;
  if (impact.outcome == Outcome::free && least < 0) wrong = "not free";
  if (contact && distance(impact.upper) > Quad(over.contact)) wrong = "no contact";
  if (nearest_ < impact.lower && least < 0) wrong = "a contact before";
  if (Quad(found.lower) > std::max(Quad(0), least)) wrong = "not so far apart";
  if (Quad(found.upper) < distance(found.time)) wrong = "not so near";
  if (found.touches && distance(found.time) > 0) wrong = "they do not touch";
  if (undecided && least < -Quad(1e-11) * (terms_ + 1)) wrong = "undecided";
  if (wrong.empty()) return std::nullopt;
  return wrong + ": " + text(impact, found);
}

}  // namespace raygauge::soak
