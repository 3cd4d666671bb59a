// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "raygauge/simulation.h"
#include "scene/simulation/friction_island.h"
#include "scene/simulation/near_pair.h"
#include "scene/simulation/shared_work.h"
#include "scene/simulation/simulated_body.h"

namespace raygauge {

/// A contact point of a problem: u_n + offset >= 0 is asked for.
struct ContactUnknown {
  int a = 0, b = 0;
  Eigen::Vector3d at, normal;
  double gap = 0;
  double offset = 0;
  std::optional<double> mu;
  Eigen::Vector3d impulse = Eigen::Vector3d::Zero();  ///< on a: a first guess, then the result
};

/// The contacts that belong together, by their numbers: those of bodies that react and meet.
std::vector<std::vector<std::size_t>> islands_of(const std::vector<ContactUnknown>& contacts,
                                                 const std::vector<SimulatedBody>& bodies);

/// Pushes both bodies of a contact, those that react, by its impulse.
void push_apart(const ContactUnknown& contact, std::vector<SimulatedBody>& bodies);

/// Contacts of many bodies, an island at a time: one that reacts joins its contacts, others do not. With
/// friction named for one of them, the problem of the island is that of FrictionSolver; otherwise contacts
/// have one unknown each.
class ContactProblem {
 public:
  ContactProblem(int dimension, FrictionSolver* friction, SimulationCounters& counters)
      : n_(dimension), friction_(friction), counters_(counters) {}

  /// From here on islands are shared with the other threads of a team. What is found does not depend on it.
  void share_with(ChunkTeam& team) { team_ = &team; }

  /// From here on no island is known.
  void forget() { known_.clear(); }

  /// Finds the impulses and pushes the bodies. The largest relative residual. An island that has been solved
  /// since forget() is not solved again.
  /// Where bodies jam, none of their contacts is asked for more than rest: they lose the offsets below 0.
  /// `roughly`: large islands are solved to a residual that tells which bodies meet, but is not to be kept.
  double solve(std::vector<ContactUnknown>& contacts, std::vector<SimulatedBody>& bodies,
               bool roughly = false);

  /// Whether the last solve() has left an island so.
  bool is_rough() const noexcept { return is_rough_; }

  /// Bodies that the last solve() found jammed all the same, and those that jam them; see jam_of(). Then what
  /// it has found is no solution.
  const std::vector<int>& jammed() const noexcept { return jammed_; }
  bool jams() const noexcept { return !jammed_.empty(); }

 private:
  struct Solved {
    std::pair<int, int> first;  // bodies of its first contact
    FrictionIsland island;      // as it was asked
    bool rests = false;         // offsets below 0 were left out
    Eigen::VectorXd r;
    double residual = 0;
    std::vector<int> jammed;
    bool was_known = false;
    bool is_rough = false;
  };

  void count(const std::vector<ContactUnknown*>& contacts);
  Solved solve_island(const std::vector<ContactUnknown*>& contacts, const std::vector<SimulatedBody>& bodies,
                      bool roughly) const;
  const Solved* known(const Solved& asked) const;
  FrictionIsland island_of(const std::vector<ContactUnknown*>& contacts,
                           const std::vector<SimulatedBody>& bodies) const;
  void solve_anew(const std::vector<ContactUnknown*>& contacts, const std::vector<SimulatedBody>& bodies,
                  bool roughly, Solved& one) const;
  double impulses(const std::vector<ContactUnknown*>& contacts, const FrictionIsland& island, bool roughly,
                  Eigen::VectorXd& r) const;

  int n_;
  FrictionSolver* friction_;
  SimulationCounters& counters_;
  ChunkTeam* team_ = nullptr;
  std::vector<Solved> known_;
  std::vector<int> jammed_;
  bool is_rough_ = false;
};

}  // namespace raygauge
