// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/simulation/pair_looks.h"

namespace raygauge {

/// What is proven of two parts over a substep, in which their motions are of one piece each.
class PairProofs {
 public:
  /// What was seen at a time.
  struct TimedLook {
    double time;
    PartContact contact;
  };

  /// All must outlive it.
  PairProofs(const PairLooks& looks, const std::vector<SimulatedPart>& parts, ContactScales scales,
             int dimension)
      : looks_(looks), parts_(parts), scales_(scales), n_(dimension) {}

  /// The time up to which they keep apart, or, of a pair that touches (`near`), overlap by most_overlap() at
  /// most. At most `end`.
  double until(const CandidatePair& candidate, const NearPair* near, double t, double end,
               PairTools& tools) const;

  /// How deep a pair that touches may come. The rest of δ is left for pairs that begin deeper than others
  /// end.
  double most_overlap(const NearPair& pair) const;

  /// A lower bound on their signed distance between two looks. Bounds of at least `enough` are not improved.
  double least(const CandidatePair& candidate, const TimedLook& first, const TimedLook& last, double enough,
               int halvings, PairTools& tools) const;

 private:
  const SimulatedPart& part(int number) const { return parts_[static_cast<std::size_t>(number)]; }
  double overlap_until(const CandidatePair& candidate, const Eigen::Vector3d& normal, double from, double to,
                       double most, PairTools& tools) const;

  const PairLooks& looks_;
  const std::vector<SimulatedPart>& parts_;
  ContactScales scales_;
  int n_;
};

}  // namespace raygauge
