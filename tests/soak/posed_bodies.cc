// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/soak/posed_bodies.h"

#include <Eigen/Geometry>
#include <cmath>

#include "engine/numerics/number_text.h"
#include "raygauge/sets/ball.h"
#include "tests/soak/random_set.h"
#include "tests/soak/result_checks.h"

namespace raygauge::soak {
namespace {

constexpr double kTolerance = 1e-6;
constexpr int kFrames = 4;

// A limit on the iterations is what only the general methods have: it sends a query their way.
DistanceOptions options_of(bool general) {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  options.tolerance = kTolerance;
  options.time_limit = 1;
  if (general) options.max_iterations = 100000;
  return options;
}

// Half of all angles are multiples of 45 degrees, so that faces and edges are parallel.
double draw_angle(RandomStream& stream) {
  const double quarter = std::acos(-1) / 4;
  return stream.uniform() < 0.5 ? quarter * static_cast<double>(stream.integer(0, 7)) : 6 * stream.uniform();
}

Pose turned(const Vector& axis, double angle, const Vector& t) {
  if (t.size() == 2) return {Eigen::Rotation2Dd(angle).toRotationMatrix(), t};
  return {Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d(axis))), Eigen::Vector3d(t)};
}

// What is false of two results about one quantity.
std::string contradiction(const DistanceResult& one, const DistanceResult& other) {
  for (const DistanceResult* r : {&one, &other}) {
    const std::string wrong = wrong_status(*r, kTolerance);
    if (!wrong.empty()) return wrong;
  }
  if (one.lower <= other.upper && other.lower <= one.upper) return "";
  return "[" + shortest_text(one.lower) + ", " + shortest_text(one.upper) + "] against [" +
         shortest_text(other.lower) + ", " + shortest_text(other.upper) + "] of the general methods";
}

}  // namespace

PosedBodies::PosedBodies(std::uint64_t seed)
    : seed_(seed),
      distance_(options_of(false)),
      general_distance_(options_of(true)),
      growth_(options_of(false)),
      general_growth_(options_of(true)) {}

std::optional<std::string> PosedBodies::check(std::int64_t number) {
  RandomStream stream({seed_, 1, static_cast<int>(number >> 31), static_cast<int>(number & 0x7fffffff)},
                      "posed_bodies", RandomPurpose::shape);
  const int n = stream.uniform() < 0.8 ? 3 : 2;
  const double size =
      stream.uniform() < 0.7 ? 1.0 : std::ldexp(1.0, static_cast<int>(stream.integer(-40, 40)));
  const RandomSet A = draw_set(stream, Vector::Zero(n), size, 0);
  const RandomSet B = draw_set(stream, Vector::Zero(n), size, 0);
  const Ball metric(Vector::Zero(n), 1.0);
  const Vector axis_A = draw_direction(stream, n), axis_B = draw_direction(stream, n),
               way = draw_direction(stream, n);
  const double angle_A = draw_angle(stream), angle_B = draw_angle(stream);
  const double away = static_cast<double>(stream.integer(0, 16)) / 4, step = stream.uniform() * 0.02;
  const bool foreign = stream.uniform() < 0.2;
  if (!foreign) warm_distance_ = warm_growth_ = WarmStart();
  ++tally_.pairs;
  for (int frame = 0; frame < kFrames; ++frame) {
    const Pose pose_A = turned(axis_A, angle_A, Vector::Zero(n));
    const Pose pose_B = turned(axis_B, angle_B + step * frame, way * (away + step * frame) * size);
    const bool cold = stream.uniform() < 0.3;
    const auto& d = distance_.solve({*A.set, pose_A}, {*B.set, pose_B}, metric, ObjectEffects::none,
                                    cold ? nullptr : &warm_distance_);
    const auto& e = general_distance_.solve({*A.set, pose_A}, {*B.set, pose_B}, metric);
    const auto& g =
        growth_.solve_about_centers({*A.set, pose_A}, {*B.set, pose_B}, cold ? nullptr : &warm_growth_);
    const auto& h = general_growth_.solve_about_centers({*A.set, pose_A}, {*B.set, pose_B});
    ++tally_.frames;
    tally_.certified += (is_final(d.distance) ? 1 : 0) + (is_final(g) ? 1 : 0);
    const std::string of_distance = contradiction(d.distance, e.distance), of_growth = contradiction(g, h);
    if (of_distance.empty() && of_growth.empty()) continue;
    return A.label + " and " + B.label + " in R^" + std::to_string(n) + ", size " + shortest_text(size) +
           ", pair " + std::to_string(number) + ", frame " + std::to_string(frame) + ": " +
           (of_distance.empty() ? "growth distance " + of_growth : "distance " + of_distance);
  }
  return std::nullopt;
}

std::string to_string(const PosedBodyTally& tally) {
  return std::to_string(tally.pairs) + " pairs, " + std::to_string(tally.frames) + " frames, " +
         std::to_string(2 * tally.frames) + " queries, " + std::to_string(tally.certified) + " certified\n";
}

}  // namespace raygauge::soak
