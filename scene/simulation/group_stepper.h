// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "raygauge/simulation.h"
#include "scene/simulation/contact_problem.h"
#include "scene/simulation/contact_roles.h"
#include "scene/simulation/impulse_memory.h"
#include "scene/simulation/near_pairs.h"
#include "scene/simulation/simulation_part.h"

namespace raygauge {

/// Bodies that react and may meet each other within a step, and what their step begins with.
struct BodyGroup {
  std::vector<int> bodies;
  std::vector<ContactUnknown> last;  ///< contacts of the substep before
  std::vector<KnownNormal> normals;  ///< of the pairs that were near then
};

/// What a step of a group has given.
struct GroupStep {
  bool done = false;  ///< false: it was stopped
  std::vector<SimulatedBody> bodies;
  std::vector<std::vector<MotionPiece>> pieces;  ///< of each of them
  std::vector<ContactRecord> contacts;
  StepRecord row;
  std::vector<ContactUnknown> last;
  std::vector<KnownNormal> normals;
};

/// Takes steps of groups of bodies, each as if there were no others. One a thread; it knows nothing of the
/// group before.
class GroupStepper {
 public:
  GroupStepper(const Dynamics& dynamics, const NearPairs& pairs, const std::vector<SimulatedBody>& bodies,
               std::vector<SimulatedPart> parts, FrictionSolver* friction, std::function<bool()> stop);

  /// As NearPairs::share_with(): for a group that is large.
  void share_with(ChunkTeam& team, int threads);

  /// From the states of its bodies among all `bodies`. `number`: of the step, for its records.
  GroupStep step(const BodyGroup& group, const std::vector<SimulatedBody>& bodies, double from, double to,
                 std::int64_t number);

  /// What was counted since the last call.
  SimulationCounters take_counters();

 private:
  SimulatedBody& body(int number) { return bodies_[static_cast<std::size_t>(number)]; }
  const SimulatedBody& body(int number) const { return bodies_[static_cast<std::size_t>(number)]; }
  void copy_active(const std::vector<SimulatedBody>& from, std::vector<SimulatedBody>& to) const;
  void save(std::vector<SimulatedBody>& to) const { copy_active(bodies_, to); }
  void restore(const std::vector<SimulatedBody>& from) { copy_active(from, bodies_); }
  bool go_on(double to);
  double longest_substep(double to) const;
  void follow_motion(int number);
  bool bounce();
  bool move(double dt);
  void move_unproven(double dt);
  double end_of(double dt) const;
  double shorter_than(double dt, double proven, int trial);
  bool settle(double dt);
  bool push_and_move(double dt, bool roughly);
  bool catch_closing(double dt);
  bool corrected(double dt);
  double correction(const NearPair& pair, double dt, PairTools& tools);
  bool limit_energy(std::vector<ContactUnknown>& contacts, std::vector<double> allowed);
  void limit_pushes(double end);
  void commit(double end);
  void record_contacts(const std::vector<ContactUnknown>& contacts, bool impact);

  const Dynamics& dynamics_;
  int n_;
  ContactScales scales_;
  std::vector<SimulatedBody> bodies_;  // of all of the scene, of which those in active_ are in work
  std::vector<SimulatedPart> parts_;
  std::function<bool()> stop_;
  SimulationCounters counters_;
  NearPairs pairs_;
  ContactRoles roles_;
  ContactProblem problem_;
  std::vector<SimulatedBody> before_;  // the substep in work
  std::vector<SimulatedBody> free_;    // before its impulses
  std::vector<SimulatedBody> limited_;
  std::vector<std::vector<MotionPiece>> pieces_;
  std::vector<int> driven_;  // bodies that do not react, ...
  std::vector<int> moved_;   // ... and those of them that do not stand
  std::vector<int> active_;  // those of the group
  GroupStep result_;
  std::int64_t number_ = 0;
  double t_ = 0;
  double end_of_step_ = 0;
  std::vector<NearPair>* near_ = nullptr;
  std::vector<double> more_;              // that near pairs are to be asked for
  std::vector<ContactUnknown> contacts_;  // of the substep in work
  ImpulseMemory last_;                    // of the problem before
  std::vector<bool> pushed_;              // bodies with an impulse of contacts_
  double residual_ = 0;                   // of the contact problem of the substep in work
  double bent_dt_ = 0;                    // the last substep that was shortened because contacts bend
};

}  // namespace raygauge
