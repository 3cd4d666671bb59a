// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/soak/random_simulations.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "raygauge/exceptions.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/half_space.h"
#include "tests/scene/random_scenes.h"

namespace raygauge::soak {
namespace {

using namespace random_scenes;

constexpr double kTo = 0.3;
constexpr double kCell =
    2.6;  // bodies of a reach below 1.3 do not overlap at the start; a box may have 1.386
constexpr int kMoments = 4;

struct Drawn {
  Scene scene;
  Dynamics dynamics;
  bool driven = false;
};

Eigen::Vector3d vector_in_space(Random& random, int n, double size) {
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  v.head(n) = uniform_vector(random, n, size);
  return v;
}

std::optional<double> sometimes(Random& random, double low, double high) {
  const double value = uniform(random, low, high);
  return random() % 3 == 0 ? std::nullopt : std::optional(value);
}

Dynamics draw_effects(Random& random, int n) {
  Dynamics dynamics;
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
  gravity[n - 1] = -9.81;
  if (random() % 4 != 0) dynamics.gravity = gravity;
  dynamics.contact = ContactLaw{sometimes(random, 0, 1), sometimes(random, 0, 1)};
  if (random() % 4 == 0) dynamics.damping = Damping{uniform(random, 0, 1), uniform(random, 0, 1)};
  dynamics.overlap_at_start = StartOverlap::resolved;
  dynamics.step = random() % 2 == 0 ? 1e-2 : 3e-3;
  dynamics.tolerance = random() % 2 == 0 ? 1e-4 : 1e-6;
  return dynamics;
}

// In a cell of a lattice above the floor.
Placement place_of(Random& random, int n, int number) {
  constexpr int kRow = 3;
  Placement where = placement(random, n, 0);
  const int layer = n == 3 ? number / (kRow * kRow) : number / kRow;
  where.t[0] = kCell * (number % kRow);
  if (n == 3) where.t[1] = kCell * (number / kRow % kRow);
  where.t[n - 1] = kCell * (0.52 + layer);
  return where;
}

void add_body(Random& random, int n, int number, Drawn& drawn) {
  const SetPointer set = shape(random, n, static_cast<int>(random() % kShapes));
  const Placement where = place_of(random, n, number);
  MotionPointer motion = std::make_shared<StaticMotion>(where);
  BodyDynamics how;
  if (number > 0 && random() % 12 == 0) {  // it moves on, and pushes
    drawn.driven = true;
    TwistMotion::Rates rates;
    rates.velocity = uniform_vector(random, n, 2);
    motion = std::make_shared<TwistMotion>(where, rates, 0.0);
  }
  Body body = make_body("body " + std::to_string(number), {set}, motion);
  if (motion->is_static()) {
    how = reacting_body(body, std::nullopt, std::pow(10, uniform(random, 1, 4)));
    how.velocity = vector_in_space(random, n, random() % 8 == 0 ? 100 : 6);
    how.spin = vector_in_space(random, 3, 8);
    if (n == 2) how.spin.head(2).setZero();
  }
  drawn.scene.bodies.push_back(std::move(body));
  drawn.dynamics.bodies.push_back(how);
}

void add_floor(Random& random, int n, Drawn& drawn) {
  Vector up = Vector::Zero(n), low = Vector::Constant(n, -40), high = Vector::Constant(n, 40);
  up[n - 1] = 1;
  low[n - 1] = -1;
  high[n - 1] = 0;
  SetPointer floor = std::make_shared<Box>(low, high);
  if (random() % 2 == 0) floor = std::make_shared<HalfSpace>(up, 0.0);
  drawn.scene.bodies.push_back(
      make_body("floor", {floor}, std::make_shared<StaticMotion>(Placement::identity(n))));
  drawn.dynamics.bodies.emplace_back();
}

Drawn draw(Random& random) {
  Drawn drawn;
  const int n = random() % 4 == 0 ? 2 : 3;
  drawn.dynamics = draw_effects(random, n);
  drawn.scene.instants = {0, kTo};
  const int bodies = 1 + static_cast<int>(random() % (random() % 4 == 0 ? 29 : 8));
  for (int k = 0; k < bodies; ++k) add_body(random, n, k, drawn);
  add_floor(random, n, drawn);
  return drawn;
}

bool is_finite(const Body& body, double t) {
  const Placement at = body.motion->at(t);
  return at.t.allFinite() && at.R.allFinite();
}

}  // namespace

RandomSimulations::RandomSimulations(std::uint64_t seed) : seed_(seed) {}

std::string RandomSimulations::energy_error(const Simulation& found, const Dynamics& dynamics) {
  double mass = 0, before = found.energy_at_start, kinetic = 0;
  for (const BodyDynamics& body : dynamics.bodies) mass += body.mass;
  for (const StepRecord& step : found.steps) kinetic = std::max(kinetic, step.kinetic);
  const double weight = dynamics.gravity ? mass * dynamics.gravity->norm() : 0;
  for (const StepRecord& step : found.steps) {
    const double energy = step.kinetic + step.potential;
    const double scale = kinetic + weight * kCell;
    tally_.rise = std::max(tally_.rise, (energy - before) / scale);
    if (energy - before > (1e-9 + 10 * step.residual) * scale)
      return "at " + std::to_string(step.time) + " s the energy rises by " +
             std::to_string((energy - before) / scale) + " of all";
    before = energy;
  }
  return "";
}

// Bodies that do not react may meet.
std::string RandomSimulations::depth_error(const Simulation& found, const Dynamics& dynamics, double t) {
  const int n = found.scene.dimension();
  ObjectDistanceSolver solver;
  const Ball ball(Vector::Zero(n), 1.0);
  for (std::size_t a = 0; a < found.scene.bodies.size(); ++a) {
    for (std::size_t b = a + 1; b < found.scene.bodies.size(); ++b) {
      const Body &one = found.scene.bodies[a], &two = found.scene.bodies[b];
      if (!dynamics.bodies[a].reacts() && !dynamics.bodies[b].reacts()) continue;
      const Placement at = one.motion->at(t), to = two.motion->at(t);
      ++tally_.checks;
      const Pose pose_a(at.R, at.t), pose_b(to.R, to.t);
      const double depth = solver
                               .solve({*one.parts.front().set, pose_a}, {*two.parts.front().set, pose_b},
                                      ball, ObjectEffects::depth)
                               .depth.lower;
      if (depth > found.tolerance * (1 + 1e-9))
        return "'" + one.name + "' and '" + two.name + "' are deeper than δ at " + std::to_string(t);
    }
  }
  return "";
}

std::string RandomSimulations::error_of(const Simulation& found, const Dynamics& dynamics, bool driven) {
  tally_.steps += static_cast<std::int64_t>(found.steps.size());
  for (const StepRecord& step : found.steps) {
    tally_.cuts += step.substeps - 1;
    tally_.contacts += step.contacts;
    tally_.impacts += step.impacts;
    if (step.residual > tally_.residual) {
      tally_.residual = step.residual;
      tally_.worst_scene = number_;
    }
    tally_.rough += step.residual > 1e-8 ? 1 : 0;
    if (!std::isfinite(step.kinetic + step.potential + step.residual)) return "a number is not finite";
    if (!(step.least_distance >= -found.tolerance))
      return "the step until " + std::to_string(step.time) + " s is not proven";
  }
  for (int k = 1; k <= kMoments; ++k) {
    const double t = found.scene.instants.back() * (k - 0.37 * (k % 2)) / kMoments;
    for (const Body& body : found.scene.bodies) {
      if (!is_finite(body, t)) return "a place is not finite";
    }
    std::string wrong = depth_error(found, dynamics, t);
    if (!wrong.empty()) return wrong;
  }
  return driven ? "" : energy_error(found, dynamics);
}

std::optional<std::string> RandomSimulations::check(std::int64_t number) {
  Random random(seed_ * 0x9e3779b97f4a7c15ULL + static_cast<std::uint64_t>(number));
  number_ = number;
  const Drawn drawn = draw(random);
  std::string wrong;
  try {
    wrong = error_of(simulate(drawn.scene, drawn.dynamics, nullptr), drawn.dynamics, drawn.driven);
  } catch (const SimulationError& error) {
    wrong = error.what();
    const bool jams = drawn.driven && wrong.find(" is jammed by ") != std::string::npos;
    if (jams) wrong = error_of(error.done(), drawn.dynamics, true);
    tally_.jammed += jams ? 1 : 0;
  } catch (const Error& error) {
    wrong = error.what();
  }
  ++tally_.scenes;
  tally_.bodies += static_cast<std::int64_t>(drawn.scene.bodies.size());
  if (wrong.empty()) return std::nullopt;
  return "scene " + std::to_string(number) + " of " + std::to_string(drawn.scene.bodies.size()) +
         " bodies in R^" + std::to_string(drawn.scene.dimension()) + ": " + wrong;
}

std::string to_string(const SimulationSoakTally& tally) {
  char text[400];
  std::snprintf(
      text, sizeof text,
      "%lld scenes, %lld bodies, %lld steps, %lld cuts, %lld contacts, %lld impacts, %lld signed "
      "distances, %lld jammed; residual %.2g at most (scene %lld), above 1e-8 in %lld steps; energy rises by "
      "%.2g at most\n",
      static_cast<long long>(tally.scenes), static_cast<long long>(tally.bodies),
      static_cast<long long>(tally.steps), static_cast<long long>(tally.cuts),
      static_cast<long long>(tally.contacts), static_cast<long long>(tally.impacts),
      static_cast<long long>(tally.checks), static_cast<long long>(tally.jammed), tally.residual,
      static_cast<long long>(tally.worst_scene), static_cast<long long>(tally.rough), tally.rise);
  return text;
}

}  // namespace raygauge::soak
