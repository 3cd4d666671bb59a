// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "raygauge/scene/simulation.h"
#include "scene/simulation/contact_problem.h"
#include "scene/simulation/near_pairs.h"
#include "scene/simulation/simulation_part.h"

namespace raygauge {

/// The work of simulate(): steps in time.
class Simulator {
 public:
  Simulator(const Scene& scene, const Dynamics& dynamics, FrictionSolver* friction);

  Simulation run(const SimulationHooks& hooks, std::span<const SimulationPart> before);

 private:
  SimulationState state() const;
  void go_on(std::span<const SimulationPart> before);
  Simulation result();
  void add_body(const Body& body, const BodyDynamics& how);
  void make_parts();
  void come_to_start();
  void resolve_overlaps();
  void refuse_overlaps();
  bool step(double to);
  void advance(double to);
  double longest_substep(double to) const;
  void follow_motions();
  void choose_roles(double dt);
  double closing_speed(const NearPair& pair) const;
  PairRole role_of(const NearPair& pair, double dt) const;
  bool is_rebound(const NearPair& pair, double approach) const;
  bool bounce();
  bool move(double dt);
  double end_of(double dt) const;
  bool push_and_move(double dt, const std::vector<SimulatedBody>& before);
  void accelerate(SimulatedBody& body, double dt);
  bool give_motion(SimulatedBody& body, const SimulatedBody& before, double dt, bool pushed);
  bool catch_leaving();
  bool corrected(double dt);
  Eigen::Vector3d guess(const NearPair& pair, const GapPoint& point) const;
  bool limit_energy(std::vector<ContactUnknown>& contacts, const std::vector<SimulatedBody>& free,
                    std::vector<double> allowed);
  void limit_pushes(double end, const std::vector<SimulatedBody>& before);
  void commit(double end, const std::vector<SimulatedBody>& before);
  bool stop_now() const { return hooks_.stop && hooks_.stop(); }
  void record_contacts(const std::vector<ContactUnknown>& contacts, bool impact);
  void record_step();
  void add_energy(StepRecord& row) const;
  double pressing(const NearPair& pair) const;
  double approach(const NearPair& pair, const GapPoint& point) const;

  const Dynamics& dynamics_;
  int n_;
  Simulation out_;
  SimulationLog log_;
  SimulationHooks hooks_;
  std::vector<SimulatedBody> bodies_;
  std::vector<SimulatedBody> free_;  // before the impulses of the substep in work
  std::vector<SimulatedPart> parts_;
  ContactScales scales_;
  std::optional<NearPairs> pairs_;
  ContactProblem problem_;
  double t_ = 0;
  double end_of_step_ = 0;
  std::vector<NearPair>* near_ = nullptr;
  std::vector<ContactUnknown> contacts_;  // of the substep in work
  std::vector<ContactUnknown> last_;      // of the one before
  std::vector<bool> pushed_;              // bodies with an impulse of contacts_
  StepRecord row_;
  double residual_ = 0;  // of the contact problem of the substep in work
  int bounces_ = 0;      // at this moment
};

}  // namespace raygauge
