// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/simulation/near_pair.h"
#include "scene/simulation/simulated_body.h"
#include "scene/simulation/simulation_part.h"

namespace raygauge {

/// How pairs of parts are looked at, and what need not be looked at again.
class PairLooks {
 public:
  /// All must outlive it.
  PairLooks(const std::vector<SimulatedBody>& bodies, const std::vector<SimulatedPart>& parts,
            ContactScales scales, int dimension)
      : bodies_(bodies), parts_(parts), scales_(scales), n_(dimension) {}

  /// The contact of two parts within a band, where the bodies are now. nullptr: they are farther apart than
  /// `beyond`, which is more than the band by so much that a look would say so too. Of bodies that lie still
  /// it is known.
  const PartContact* now(CandidatePair& candidate, double band, double beyond, PairTools& tools) const;

  /// The same where their motions are at time t.
  PartContact at(const CandidatePair& candidate, double t, double band, PairTools& tools) const;

  /// Whether it is known, of where they are now, that they are farther apart than `beyond`.
  bool is_known_apart(const CandidatePair& candidate, double beyond) const;

  /// Whether both parts lie still within this substep, at a signed distance of `least` or more.
  bool stays(const CandidatePair& candidate, double least) const;

  /// A lower bound on the signed distance at time t of their motions, by planes across the normal where they
  /// are now, or as either body turns it: true but for rounding. -infinity of a half-space.
  double between_planes_at(const NearPair& pair, double t) const;

 private:
  const SimulatedPart& part(int number) const { return parts_[static_cast<std::size_t>(number)]; }
  Placement place_of(int number) const;
  void look(const CandidatePair& candidate, const Placement& at_a, const Placement& at_b, double band,
            PartContact& contact, PairTools& tools) const;
  bool is_known_now(const CandidatePair& candidate) const;
  bool is_known_beyond(const CandidatePair& candidate, const Placement& at_a, const Placement& at_b,
                       double beyond) const;
  double between_planes(int part_a, int part_b, const Eigen::Vector3d& normal, const Placement& at_a,
                        const Placement& at_b) const;

  const std::vector<SimulatedBody>& bodies_;
  const std::vector<SimulatedPart>& parts_;
  ContactScales scales_;
  int n_;
};

}  // namespace raygauge
