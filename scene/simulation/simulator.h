// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "engine/threads/shared_tools.h"
#include "raygauge/simulation.h"
#include "scene/simulation/group_stepper.h"
#include "scene/simulation/near_pairs.h"
#include "scene/simulation/shared_work.h"
#include "scene/simulation/simulation_part.h"

namespace raygauge {

/// The work of simulate(): steps in time, of groups of bodies that cannot meet within them.
class Simulator {
 public:
  Simulator(const Scene& scene, const Dynamics& dynamics, FrictionSolver* friction);

  Simulation run(const SimulationHooks& hooks, std::span<const SimulationPart> before);

 private:
  SimulationState state() const;
  void go_on(std::span<const SimulationPart> before);
  bool do_step(double to);
  Simulation result();
  void end_instants();
  void add_body(const Body& body, const BodyDynamics& how);
  void make_parts();
  void come_to_start();
  void resolve_overlaps();
  void refuse_overlaps();
  bool step(double to);
  void advance(double to);
  void make_steppers();
  std::vector<std::vector<int>> groups_of(const std::vector<double>& ways, double dt);
  void expect_ways(double dt);
  std::vector<BodyGroup> with_memory(const std::vector<std::vector<int>>& members) const;
  void step_groups(const std::vector<BodyGroup>& groups, double to, std::vector<GroupStep>& steps);
  bool went_too_far(const std::vector<BodyGroup>& groups, const std::vector<GroupStep>& steps, double to);
  void take(const std::vector<BodyGroup>& groups, std::vector<GroupStep>& steps);
  bool stop_now();
  void record_step();
  void add_energy(StepRecord& row) const;

  const Dynamics& dynamics_;
  int n_;
  Simulation out_;
  SimulationLog log_;
  SimulationHooks hooks_;
  std::vector<SimulatedBody> bodies_;
  std::vector<SimulatedPart> parts_;
  ContactScales scales_;
  std::optional<NearPairs> pairs_;
  FrictionSolver* friction_;
  std::unique_ptr<FrictionSolver> in_turn_;  // the same, of many threads
  ChunkTeam team_;
  std::thread::id begun_;                // the thread that began, which asks the hooks
  std::unique_ptr<GroupStepper> whole_;  // for large groups, with all threads
  SharedTools<GroupStepper> steppers_;   // for the others, one a thread
  std::atomic<bool> stopped_ = false;
  std::string ended_by_;  // why it cannot go on
  double t_ = 0;
  std::vector<ContactUnknown> last_;  // contacts of the last substeps
  std::vector<KnownNormal> normals_;  // of pairs that were near then
  std::vector<double> ways_;          // that bodies may go within the step in work
  StepRecord row_;
};

}  // namespace raygauge
