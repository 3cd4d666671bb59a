// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <vector>

#include "raygauge/simulation.h"
#include "scene/simulation/near_pair.h"
#include "scene/simulation/simulated_body.h"
#include "scene/simulation/simulation_part.h"

namespace raygauge {

/// Which parts may meet: the candidates of a scene, and those of them whose balls and boxes meet as they
/// move.
class PartSweep {
 public:
  /// The ball around a part, and how far it may move.
  struct Swept {
    Eigen::Vector3d middle;
    double radius = 0, travel = 0;
  };

  /// All candidates of a scene. Everything must outlive it.
  PartSweep(const Scene& scene, const Dynamics& dynamics, const std::vector<SimulatedBody>& bodies,
            const std::vector<SimulatedPart>& parts, SimulationCounters& counters);

  /// The same candidates, of a group's own copies of bodies and parts.
  PartSweep(const PartSweep& all, const std::vector<SimulatedBody>& bodies,
            const std::vector<SimulatedPart>& parts, SimulationCounters& counters);

  /// From here on there are these bodies alone.
  void take(const std::vector<int>& members);

  /// From here on there are the bodies that react alone, each of which moves by its `ways` at most.
  void take_reacting(const std::vector<double>& ways);

  /// The numbers of the parts of these bodies.
  const std::vector<int>& scope() const noexcept { return scope_; }

  /// Those that may come closer than `beyond` within dt, in the order of the candidates; the same for the
  /// ways that were given.
  const std::vector<CandidatePair*>& sweep(double t, double dt, double beyond);
  const std::vector<CandidatePair*>& sweep(double beyond);

  /// The candidate of two parts, or nullptr.
  CandidatePair* find(int part_a, int part_b);

  const Swept& of(int part) const { return swept_[static_cast<std::size_t>(part)]; }

  /// How far both parts may move, added up.
  double travels(const CandidatePair& candidate) const {
    return of(candidate.part_a).travel + of(candidate.part_b).travel;
  }

  /// No point of a part moves farther within dt, as its body moves.
  double travel(int part, double t, double dt) const;

 private:
  // Around the ball of a part and its way.
  struct SweptBox {
    Eigen::Vector3d low, high;
    int part;
  };

  const SimulatedPart& part(int number) const { return parts_[static_cast<std::size_t>(number)]; }
  void number_candidates();
  Eigen::Vector3d middle(int part) const;
  bool may_meet(int a, int b, double beyond);

  const Dynamics& dynamics_;
  const std::vector<SimulatedBody>& bodies_;
  const std::vector<SimulatedPart>& parts_;
  SimulationCounters& counters_;
  int n_;
  std::shared_ptr<std::vector<CandidatePair>>
      candidates_;                             // by their parts; groups share them, none the same
  std::vector<std::size_t> first_candidates_;  // of each part as the first, and their count
  std::vector<std::vector<int>> parts_of_;     // each body
  std::vector<int> scope_;                     // parts of the members
  std::vector<Swept> swept_;                   // of each part
  std::vector<std::optional<Eigen::AlignedBox3d>> standing_;  // around each part that stands
  std::vector<SweptBox> boxes_;                               // by where they begin
  std::vector<CandidatePair*> may_meet_;                      // of the last sweep
};

}  // namespace raygauge
