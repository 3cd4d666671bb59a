// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/simulation.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <memory>

#include "raygauge/exceptions.h"
#include "raygauge/meshes/mesh.h"

namespace raygauge {
namespace {

[[noreturn]] void refuse(const std::string& message) { throw InvalidParameterError("dynamics: " + message); }

bool is_in(const std::vector<int>& group, int body) {
  return std::find(group.begin(), group.end(), body) != group.end();
}

std::string short_number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

constexpr double kLargest = 1e60;    // squares and products of a few stay finite
constexpr double kMostSteps = 1e15;  // are counted exactly, and far more than any computer takes

bool is_ordinary(double x) { return x >= 1 / kLargest && x <= kLargest; }

void check_law(const ContactLaw& law) {
  if (law.friction && !(*law.friction >= 0 && std::isfinite(*law.friction)))
    refuse("friction must be 0 or more, and finite");
  if (law.restitution && !(*law.restitution >= 0 && *law.restitution <= 1))
    refuse("restitution must lie in [0, 1]");
}

void check_body(const Body& body, const BodyDynamics& how, int n, double step) {
  const std::string name = "body '" + body.name + "'";
  if (!how.reacts()) return;
  if (!body.motion->is_static()) refuse(name + " has a mass and follows a motion; give it one of both");
  if (!is_ordinary(how.mass))
    refuse(name + ": mass must lie in [1e-60, 1e60], got " + short_number(how.mass));
  if (!how.inertia.allFinite()) refuse(name + ": inertia is not finite");
  if (!(how.velocity.norm() <= kLargest && how.spin.norm() <= kLargest))
    refuse(name + ": velocities must be at most 1e60");
  const double turn = how.spin.norm() * step;
  if (turn > kMostRadiansOfStep)
    refuse(name + " turns by " + short_number(turn) + " radians in a step of " + short_number(step) +
           " s; at most " + short_number(kMostRadiansOfStep) + " can be proven, in shorter steps");
  const Eigen::Matrix3d J =
      n == 2 ? Eigen::Matrix3d(how.inertia(2, 2) * Eigen::Matrix3d::Identity()) : how.inertia;
  if (J != J.transpose()) refuse(name + ": its inertia must be symmetric");
  const Eigen::Vector3d moments = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(J).eigenvalues();
  if (!(moments[0] > 0)) refuse(name + ": its inertia must be positive definite");
  if (!is_ordinary(moments[0]) || !is_ordinary(moments[2]))
    refuse(name + ": inertia must lie in [1e-60, 1e60], got " + short_number(moments[2]));
}

std::string counted(std::size_t n, const char* one, const char* more) {
  return std::to_string(n) + " " + (n == 1 ? one : more);
}

std::string list_of(const std::vector<SimulationAccuracy>& all, double SimulationAccuracy::*member) {
  std::vector<std::string> known;
  std::string text;
  for (const SimulationAccuracy& one : all) {
    const std::string number = short_number(one.*member);
    if (std::find(known.begin(), known.end(), number) != known.end()) continue;
    known.push_back(number);
    text += (text.empty() ? "" : ", ") + number;
  }
  return text;
}

std::vector<std::string> explain_contact(const Dynamics& dynamics,
                                         const std::vector<SimulationAccuracy>& accuracies) {
  if (!dynamics.contact) return {"contact: never computed; bodies pass through each other"};
  std::vector<std::string> lines = {
      "contact: of every pair of which one reacts; that none comes closer than -" +
      list_of(accuracies, &SimulationAccuracy::tolerance) +
      " of the smallest body's size is proven of every step"};
  lines.emplace_back(dynamics.has_friction() ? "friction: Coulomb's law as exact cones, an island at a time"
                                             : "friction: never computed; a contact has one unknown");
  lines.emplace_back(dynamics.has_restitution() ? "restitution: Newton's law, at the proven time of impact"
                                                : "restitution: never computed");
  if (dynamics.overlap_at_start == StartOverlap::resolved)
    lines.emplace_back("overlaps at the start: resolved; bodies are first moved apart");
  if (!dynamics.pairs.empty())
    lines.push_back(counted(dynamics.pairs.size(), "exception", "exceptions") + " for pairs of groups");
  return lines;
}

}  // namespace

BodyDynamics reacting_body(const Body& body, std::optional<double> mass, std::optional<double> density,
                           const std::optional<Eigen::Matrix3d>& inertia) {
  if (mass.has_value() == density.has_value())
    refuse("body '" + body.name + "' needs a mass or a density, not both");
  if (!(mass.value_or(1) > 0 && density.value_or(1) > 0))
    refuse("body '" + body.name + "': mass and density must be positive");
  std::vector<std::shared_ptr<const ConvexSet>> parts;
  for (const BodyPart& part : body.parts) parts.push_back(part.set);
  const Moments moments = moments_of(parts);
  BodyDynamics how;
  how.mass = mass ? *mass : *density * moments.measure;
  how.center.head(body.dimension()) = moments.center;
  const Eigen::Matrix3d J = how.mass / moments.measure * moments.inertia();
  how.inertia = inertia ? *inertia : Eigen::Matrix3d((J + J.transpose()) / 2);  // rounding is not symmetric
  return how;
}

bool Dynamics::has_friction() const {
  return contact && (contact->friction || std::any_of(pairs.begin(), pairs.end(), [](const PairLaw& pair) {
                       return pair.law.friction.has_value();
                     }));
}

bool Dynamics::has_restitution() const {
  return contact && (contact->restitution || std::any_of(pairs.begin(), pairs.end(), [](const PairLaw& pair) {
                       return pair.law.restitution.has_value();
                     }));
}

std::optional<ContactLaw> Dynamics::law_of(int a, int b) const {
  if (!contact) return std::nullopt;
  const auto names = [a, b](const PairLaw& pair) {
    const bool named = is_in(pair.group_1, a) && is_in(pair.group_2, b);
    return named || (is_in(pair.group_1, b) && is_in(pair.group_2, a));
  };
  const auto last = std::find_if(pairs.rbegin(), pairs.rend(), names);
  return last == pairs.rend() ? contact : last->law;
}

std::vector<SimulationAccuracy> accuracies_of(std::vector<double> steps, std::vector<double> tolerances) {
  for (std::vector<double>* list : {&steps, &tolerances}) {
    std::sort(list->rbegin(), list->rend());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  std::vector<SimulationAccuracy> all;
  for (const double step : steps) {
    for (const double tolerance : tolerances) all.push_back({step, tolerance});
  }
  return all;
}

void check_dynamics(const Scene& scene, const Dynamics& dynamics) {
  const int n = scene.dimension();
  if (n != 2 && n != 3) refuse("bodies react in 2 or 3 dimensions, not in " + std::to_string(n));
  if (dynamics.bodies.size() != scene.bodies.size()) refuse("every body of the scene needs its entry");
  for (const Body& body : scene.bodies) {
    for (const BodyPart& part : body.parts) {
      if (as_mesh(*part.set) != nullptr)
        refuse("body '" + body.name +
               "' is a mesh as it is: contacts are those of its hull (as = \"hull\") or of convex parts");
    }
  }
  if (!(dynamics.step > 0 && std::isfinite(dynamics.step))) refuse("step must be positive");
  if (scene.instants.empty()) refuse("a scene needs an instant");
  if (!((scene.instants.back() - scene.instants.front()) / dynamics.step < kMostSteps))
    refuse("step is too short: the time of the scene has more than 1e15 of them");
  bool any = false;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    check_body(scene.bodies[b], dynamics.bodies[b], n, dynamics.step);
    any = any || dynamics.bodies[b].reacts();
  }
  if (!any) refuse("no body reacts; give one a density or a mass");
  if (dynamics.gravity && !(dynamics.gravity->norm() <= kLargest))
    refuse("gravity must be finite, and at most 1e60");
  if (!(dynamics.tolerance >= 1e-9 && dynamics.tolerance <= 0.1)) refuse("tolerance must lie in [1e-9, 0.1]");
  if (dynamics.damping && !(dynamics.damping->linear >= 0 && dynamics.damping->angular >= 0 &&
                            std::isfinite(dynamics.damping->linear + dynamics.damping->angular)))
    refuse("damping must be 0 or more, and finite");
  if (!dynamics.contact && !dynamics.pairs.empty()) refuse("pairs have no effect without contact");
  if (dynamics.contact) check_law(*dynamics.contact);
  for (const PairLaw& pair : dynamics.pairs) check_law(pair.law);
}

std::vector<std::string> explain_dynamics(const Scene& scene, const Dynamics& dynamics,
                                          const std::vector<SimulationAccuracy>& accuracies) {
  std::size_t reacting = 0;
  for (const BodyDynamics& body : dynamics.bodies) reacting += body.reacts() ? 1U : 0U;
  std::vector<std::string> lines = {counted(reacting, "body reacts", "bodies react") + ", " +
                                    std::to_string(scene.bodies.size() - reacting) +
                                    " stand or follow their motions and push; steps of " +
                                    list_of(accuracies, &SimulationAccuracy::step) + " s"};
  if (accuracies.size() > 1)
    lines.push_back(counted(accuracies.size(), "simulation", "simulations") +
                    ": each step with each tolerance; the queries are answered of the finest");
  lines.emplace_back(dynamics.gravity ? "gravity: constant; flights are exact" : "gravity: none");
  lines.emplace_back(dynamics.damping ? "damping: of velocities, of second order"
                                      : "damping: never computed");
  const std::vector<std::string> contact = explain_contact(dynamics, accuracies);
  lines.insert(lines.end(), contact.begin(), contact.end());
  return lines;
}

}  // namespace raygauge
