// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "engine/threads/shared_tools.h"
#include "raygauge/simulation.h"
#include "scene/simulation/near_pair.h"
#include "scene/simulation/pair_looks.h"
#include "scene/simulation/pair_proofs.h"
#include "scene/simulation/part_sweep.h"
#include "scene/simulation/shared_work.h"
#include "scene/simulation/simulated_body.h"
#include "scene/simulation/simulation_part.h"

namespace raygauge {

/// Which parts are near each other, and what is proven of them over a substep. One a simulation.
class NearPairs {
 public:
  NearPairs(const Scene& scene, const Dynamics& dynamics, const std::vector<SimulatedBody>& bodies,
            std::vector<SimulatedPart>& parts, ContactScales scales, SimulationCounters& counters);

  /// From here on the work of a step is shared with the other threads of a team, `threads` with the caller.
  /// What is found does not depend on it.
  void share_with(ChunkTeam& team, int threads);

  /// Of the same pairs, for a group of bodies at a time, which another thread's does not share.
  NearPairs(const NearPairs& all, const std::vector<SimulatedBody>& bodies, std::vector<SimulatedPart>& parts,
            SimulationCounters& counters);

  ~NearPairs();
  NearPairs(const NearPairs&) = delete;
  NearPairs& operator=(const NearPairs&) = delete;

  /// The pairs that may meet within dt, where the bodies are now, with their contacts.
  std::vector<NearPair>& find(double t, double dt);

  int dimension() const noexcept { return n_; }
  const ContactScales& scales() const noexcept { return scales_; }

  /// From here on there are these bodies alone, `members` in rising order, and these normals of pairs that
  /// were near. Throws InvalidParameterError for parts of another scene.
  void begin(const std::vector<int>& members, const std::vector<KnownNormal>& known);

  /// The normals of the pairs that the last find() returned: what the next begin() is to know.
  std::vector<KnownNormal> end();

  /// Sets these normals, and unsets them.
  void recall(const std::vector<KnownNormal>& known);
  void forget(const std::vector<KnownNormal>& known);

  /// Bodies that react and may meet where each moves by `ways` at most, in pairs, before a step of length dt.
  std::vector<std::pair<int, int>> meeting(double t, double dt, const std::vector<double>& ways);

  /// Calls work(k, tools) for every near pair k of the last find(), on any thread.
  template <class Work>
  void for_each_near(const Work& work) {
    for_each(near_.size(), work);
  }

  /// How pairs are looked at.
  const PairLooks& looks() const noexcept { return looks_; }

  /// A lower bound on the signed distance at the end of their motions.
  double distance_at(const NearPair& pair, double end, PairTools& tools);

  /// The time up to which it is proven that no pair comes closer than -δ, as the bodies' motions have them.
  /// At most `end`. Pairs that are not in contact come as close as `arrival` at most.
  double proven_until(double t, double end);

  /// The near pair that ended the last proof, or null: one that is not near, or none. Where it is in contact
  /// its way bends, the less the shorter it is.
  NearPair* ended_proof() noexcept { return ended_proof_; }

  /// As the bodies' motions have them, no pair comes closer within [t, end], which lies within one piece of
  /// each: proven, at most 0, and -infinity where nothing is. Up to δ/4 or 1 % it is the least signed
  /// distance.
  double least_distance(double t, double end);

  /// Whether all that the last proof was about stayed apart.
  bool nothing_touched() const noexcept { return nothing_touched_; }

 private:
  const SimulatedPart& part(int number) const { return parts_[static_cast<std::size_t>(number)]; }
  const NearPair* touching(const CandidatePair& candidate) const;  // in contact or leaving; nullptr: apart
  bool is_known_proven(const CandidatePair& candidate) const;
  void hand_motions();
  void add_tools();
  void take_counters();

  // Some at a time: a chunk takes some µs more than it takes to hand it out.
  template <class Work>
  void for_each(std::size_t count, const Work& work, bool wake = false) {
    constexpr std::size_t kChunk = 4;
    share_work(team_, count, kChunk, wake, [&](std::size_t first, std::size_t last) {
      tools_.lend([&](PairTools& tools) {
        for (std::size_t k = first; k < last; ++k) work(k, tools);
      });
    });
    take_counters();
  }

  const std::vector<SimulatedBody>& bodies_;
  std::vector<SimulatedPart>& parts_;
  ContactScales scales_;
  SimulationCounters& counters_;
  int n_;
  PartSweep sweep_;
  PairLooks looks_;
  PairProofs proofs_;
  std::vector<NearPair> near_, before_;    // of the last find(), and of the one before it
  std::vector<const PartContact*> found_;  // of each candidate of a sweep
  std::vector<CandidatePair*> in_doubt_;   // those of a sweep where a proof takes work
  std::vector<double> proven_;             // of these
  SharedTools<PairTools> tools_;
  ChunkTeam* team_ = nullptr;
  bool nothing_touched_ = true;
  NearPair* ended_proof_ = nullptr;
};

}  // namespace raygauge
