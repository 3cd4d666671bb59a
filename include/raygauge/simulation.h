// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

// The public interface of the library raygauge::simulation: bodies that fall, hit, slide and rest. Friction
// needs a solver: that of raygauge::friction, or one of your own.
#if __cplusplus < 201709L && (!defined(_MSVC_LANG) || _MSVC_LANG < 202002L)
#error "raygauge needs C++20: compile with -std=c++20"
#else
#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "raygauge/exceptions.h"
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
Moments moments_of(const std::vector<std::shared_ptr<const ConvexSet> >& parts);

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

/// Contacts of one island. With impulses r = (r_n, r_t1, r_t2) and velocities u = W r + q of each contact:
///
///     0 <= r_n  ⊥  u_n >= 0,     |r_t| <= μ r_n,     r_t against u_t and on the rim where u_t != 0.
struct FrictionProblem {
  Eigen::MatrixXd W;       ///< 3c × 3c
  Eigen::VectorXd q;       ///< 3c
  std::vector<double> mu;  ///< c
};

/// Solves friction problems. One a thread.
class FrictionSolver {
 public:
  virtual ~FrictionSolver() = default;
  FrictionSolver(const FrictionSolver&) = delete;
  FrictionSolver& operator=(const FrictionSolver&) = delete;

  /// Writes r, which on entry is a first guess.
  virtual void solve(const FrictionProblem& problem, Eigen::VectorXd& r) = 0;

 protected:
  FrictionSolver() = default;
};

/// The point of {r : |r_t| <= μ r_n} nearest to x = (x_n, x_t1, x_t2).
inline Eigen::Vector3d nearest_in_cone(const Eigen::Vector3d& x, double mu) {
  const double tangential = x.tail<2>().norm();
  if (tangential <= mu * x[0]) return x;
  if (mu * tangential <= -x[0]) return Eigen::Vector3d::Zero();
  const double normal = (x[0] + mu * tangential) / (1 + mu * mu);
  const double share = mu * normal / tangential;
  return {normal, share * x[1], share * x[2]};
}

/// How far r is from a solution, relative to |q|: with s = 1/‖W‖ and the velocities ũ = u + μ|u_t| e_n of De
/// Saxcé, |r - P_K(r - s ũ)| / (s |q|), P_K the projection to the cones of friction. 0 for q = 0.
double friction_residual(const FrictionProblem& problem, const Eigen::VectorXd& r);

/// min ½ rᵀW r + qᵀr over r >= 0, W positive semidefinite: contacts without friction, 0 <= r ⊥ W r + q >= 0.
/// Among velocities without approach it is the point nearest to the free one in the kinetic metric. Lawson
/// and Hanson's active sets.
Eigen::VectorXd nonnegative_solution(const Eigen::MatrixXd& W, const Eigen::VectorXd& q);

/// The same measure for them: |r - max(0, r - s (W r + q))| / (s |q|).
double nonnegative_residual(const Eigen::MatrixXd& W, const Eigen::VectorXd& q, const Eigen::VectorXd& r);

/// Of the library raygauge::friction, by Siconos numerics: nonsmooth Gauss-Seidel on the contacts, from the
/// first guess to a relative error of 1e-10 or 4000 passes, beyond which it gains little.
std::unique_ptr<FrictionSolver> siconos_friction();

/// A contact that carried an impulse.
struct ContactRecord {
  std::int64_t step = 0;
  double time = 0;  ///< of the beginning of the substep; of an impact, its moment
  std::int32_t body_a = 0, body_b = 0;
  bool impact = false;            ///< by Newton's law of restitution, at one moment
  Eigen::Vector3d point, normal;  ///< in space; the normal points from b to a
  double gap = 0;
  Eigen::Vector3d impulse;  ///< on a, during the substep or at the impact
};

/// What is known of one step.
struct StepRecord {
  double time = 0;            ///< of its end
  std::int64_t substeps = 0;  ///< 1 + how often it was cut
  std::int64_t impacts = 0;   ///< impact laws evaluated
  std::int64_t contacts = 0;  ///< points of contact problems solved
  double residual = 0;        ///< the largest of those problems, see friction_residual(); NaN: not known
  double least_distance = 0;  ///< proven: no pair came closer at any time of the step; -infinity: unproven
  double kinetic = 0, potential = 0;
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();          ///< of all bodies that react
  Eigen::Vector3d angular_momentum = Eigen::Vector3d::Zero();  ///< the same, about the origin
};

/// How often what was computed; what is not named in Dynamics stays 0.
struct SimulationCounters {
  std::int64_t ball_tests = 0;       ///< pairs of parts apart by their bounding balls and speeds
  std::int64_t contact_queries = 0;  ///< signed distances with contact points
  std::int64_t motion_proofs = 0;    ///< proofs about a pair over a substep
  std::int64_t friction_problems = 0, frictionless_problems = 0, impact_problems = 0;
  std::int64_t damped_velocities = 0;

  SimulationCounters& operator+=(const SimulationCounters& more);
};

/// A simulated scene: its bodies, moved so that their origins are their centres of mass, under the motions
/// that were computed.
struct Simulation {
  Scene scene;
  std::vector<ContactRecord> contacts;
  std::vector<StepRecord> steps;
  SimulationCounters counters;
  double tolerance = 0;        ///< δ, in units of the scene
  double energy_at_start = 0;  ///< kinetic and potential
  double moved_at_start = 0;   ///< how far the centre of a body was moved at most, of bodies that overlapped
  bool stopped = false;
};

/// A simulation that cannot go on: driven bodies jam others, a body spins too fast for a step to be proven,
/// or what `advance` or `stop` threw. The steps until then are kept.
class SimulationError : public Error {
 public:
  SimulationError(const std::string& why, Simulation done);

  /// Until the end of the last step that was done: the last instant of its scene.
  const Simulation& done() const noexcept { return *done_; }

 private:
  std::shared_ptr<const Simulation> done_;
};

struct SimulationPart;  // scene/simulation/simulation_part.h

/// Where a body is, by its centre of mass, and how it moves. In the plane vectors have zeros behind them.
struct BodyState {
  Eigen::Vector3d x = Eigen::Vector3d::Zero();
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();  ///< angular velocity, in space
};

struct SimulationHooks {
  int threads = 1;  ///< share groups of bodies, and a large one's pairs; what is found does not depend on it
  std::function<bool()> stop;                  ///< true: end here; a step that is not done is taken back
  std::function<void(double share)> progress;  ///< of the time that is done
  std::function<bool()> due;                   ///< after a step: whether to call `store` now; none: no
  std::function<void(const SimulationPart& part)>
      store;  ///< what happened since its last call; also at the end, and before a SimulationError
  /// Another engine: it takes a step until `end`, and sets the states of the bodies that react, of all bodies
  /// in the order of the scene. Between the ends of a step each moves and turns evenly. Of this motion the
  /// least signed distance is proven, and no limit is kept.
  std::function<void(double end, std::vector<BodyState>& bodies)> advance;
};

/// Lets the bodies of the scene react, from its first instant to its last, in steps of at most dynamics.step.
/// Free flight is exact for constant forces. Contacts follow Moreau and Jean's time stepping in velocities
/// and impulses, restitution acts at proven times of impact. Of every step it is proven that no pair of
/// bodies comes closer than -δ; a step of which that is not so is cut where the proof ends.
///
/// `friction` solves contact problems with friction that Newton's method does not solve; it may be nullptr.
/// Throws what check_dynamics() throws, and InvalidParameterError for bodies that overlap by more than δ at
/// the start (see StartOverlap). SimulationError where it cannot go on.
///
/// `before`: what an earlier call has stored of the same scene and dynamics; this one goes on from there, and
/// finds bit for bit what one call would have.
Simulation simulate(const Scene& scene, const Dynamics& dynamics, FrictionSolver* friction,
                    const SimulationHooks& hooks = {}, std::span<const SimulationPart> before = {});

}  // namespace raygauge
#endif
