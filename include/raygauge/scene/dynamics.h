// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "raygauge/scene/motion.h"
#include "raygauge/scene/scene.h"
#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// The moments of a body S of density 1 in R^2 or R^3,
///
///     V = ∫ dx,   c = ∫ x dx / V,   C = ∫ (x - c)(x - c)ᵀ dx,
///
/// V its volume, in the plane its area. Under x ↦ M x + t they become |det M| V, M c + t and |det M| M C Mᵀ.
struct Moments {
  double measure = 0;
  SmallVector center;
  SmallMatrix covariance;

  /// ∫ (|y|² 1 - y yᵀ) dx with y = x - c; in the plane its last entry alone, ∫ |y|² dx.
  Eigen::Matrix3d inertia() const;
};

/// The moments of S. Closed forms of balls, ellipsoids, p-norm balls, boxes, simplices, capsules, cylinders
/// and truncated cones, and affine images of all. Sums over the simplices of the hull for every set that is
/// the hull of known points, sums of such sets among them. Throws InvalidParameterError for other sets, for
/// sets without volume, for spaces of other dimensions, and for hulls in R^3 of a library without Qhull.
Moments moments_of(const ConvexSet& S);

/// Those of several parts together; where parts overlap, the common region counts twice. Throws as above.
Moments moments_of(const std::vector<std::shared_ptr<const ConvexSet>>& parts);

/// What happens where bodies touch. What is not named is not computed.
struct ContactLaw {
  std::optional<double> friction;     ///< Coulomb's μ >= 0: |r_t| <= μ r_n
  std::optional<double> restitution;  ///< Newton's e in [0, 1]: u_n after >= -e u_n before
};

/// A contact law for pairs of one body of each group, in place of that of all.
struct PairLaw {
  std::vector<int> group_1, group_2;
  ContactLaw law;
};

/// What becomes of bodies that overlap by more than δ at the start: an error, or they are first moved apart,
/// by translations along their shortest ways out, again until none overlaps.
enum class StartOverlap : std::uint8_t { refused, resolved };

/// Forces -c m v and torques -c L, with c in 1/s.
struct Damping {
  double linear = 0, angular = 0;
};

/// The step and the tolerance of a simulation.
struct SimulationAccuracy {
  double step = 1e-3;       ///< the longest step in time
  double tolerance = 1e-6;  ///< δ, relative to the reach of the smallest body that reacts
};

/// Each combination once, from coarse to fine: by falling steps, then by falling tolerances.
std::vector<SimulationAccuracy> accuracies_of(std::vector<double> steps, std::vector<double> tolerances);

/// No body may turn by more radians within a step: the proof of one step would take thousands of pieces.
inline constexpr double kMostRadiansOfStep = 1000;

/// How a body reacts. In the plane vectors have zeros behind them and the inertia is its last entry.
struct BodyDynamics {
  double mass = 0;                                     ///< 0: it stands or follows its motion, and pushes
  Eigen::Vector3d center = Eigen::Vector3d::Zero();    ///< of mass, in the frame of the body
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();   ///< about it, in the axes of the body
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< of the centre of mass, at the start
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();      ///< angular velocity, at the start, in space

  bool reacts() const noexcept { return mass > 0; }
};

/// How a body reacts whose mass is given, or the density of all its parts; the inertia is that of its shape,
/// or the one given about its centre of mass. Throws InvalidParameterError: shapes without volume, or without
/// a formula.
BodyDynamics reacting_body(const Body& body, std::optional<double> mass, std::optional<double> density,
                           const std::optional<Eigen::Matrix3d>& inertia = std::nullopt);

/// The effects of a simulation. What is not named here is not computed.
struct Dynamics {
  std::optional<Eigen::Vector3d> gravity;
  std::optional<ContactLaw> contact;  ///< none: bodies pass through each other
  std::vector<PairLaw> pairs;
  std::optional<Damping> damping;
  StartOverlap overlap_at_start = StartOverlap::refused;
  double step = SimulationAccuracy().step;
  double tolerance = SimulationAccuracy().tolerance;
  std::vector<BodyDynamics> bodies;  ///< of each body of the scene

  /// The law of a pair, if any: of the last entry of `pairs` that names it, or that of all.
  std::optional<ContactLaw> law_of(int a, int b) const;

  /// Whether some law names them.
  bool has_friction() const;
  bool has_restitution() const;
};

/// Throws InvalidParameterError for what cannot be simulated: no body that reacts, another space than R^2 or
/// R^3, numbers outside their ranges, exceptions for pairs where there is no contact.
void check_dynamics(const Scene& scene, const Dynamics& dynamics);

/// What will be computed, what never, and why: one sentence a line, for people.
std::vector<std::string> explain_dynamics(const Scene& scene, const Dynamics& dynamics,
                                          const std::vector<SimulationAccuracy>& accuracies);

}  // namespace raygauge
