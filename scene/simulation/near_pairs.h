// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <vector>

#include "engine/threads/shared_tools.h"
#include "raygauge/scene/continuous.h"
#include "raygauge/simulation.h"
#include "scene/simulation/contact_finder.h"
#include "scene/simulation/shared_work.h"
#include "scene/simulation/simulated_body.h"
#include "scene/simulation/simulation_part.h"

namespace raygauge {

/// What a step does with two parts that are near each other.
enum class PairRole : std::uint8_t {
  apart,    ///< it takes care that they do not touch before its end
  contact,  ///< they belong to the contact problem
  leaving,  ///< they touch and separate
};

/// Two parts that may meet within a step.
struct NearPair {
  int part_a = 0, part_b = 0;
  int a = 0, b = 0;  ///< bodies
  ContactLaw law;
  PartContact contact;
  double closing = 0;  ///< the highest speed at which a point of the contact closes, before the step
  PairRole role = PairRole::apart;
  double correction = 0;  ///< <= 0: what the end of the step was closer than its contact problem said
};

/// Distances that matter, in units of the scene.
struct ContactScales {
  double delta = 0;                                       ///< δ
  double touching() const noexcept { return delta / 2; }  ///< from here on bodies touch
  double arrival() const noexcept { return delta / 4; }   ///< the distance at which an impact is computed
};

/// What one thread needs to look at pairs. It counts for itself.
struct PairTools {
  PairTools(int dimension, double miss);
  ~PairTools();

  Pose pose_a, pose_b;
  ContactFinder finder;
  ContinuousSolver solver;
  std::unique_ptr<class PairSolver> planes;
  SimulationCounters counters;
};

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

  /// A lower bound on the signed distance at the end of their motions.
  double distance_at(const NearPair& pair, double end, PairTools& tools);

  /// The same by planes across the normal where they are now, or as either body turns it: sooner known, not
  /// as close, and true but for rounding. -infinity of a half-space.
  double plane_distance_at(const NearPair& pair, double end) const;

  /// The time up to which it is proven that no pair comes closer than -δ, as the bodies' motions have them.
  /// At most `end`. Pairs that are not in contact come as close as `arrival` at most.
  double proven_until(double t, double end);

  /// Whether a pair in contact ended the last proof: its way bends, the less the shorter it is.
  bool contact_ended_proof() const noexcept { return contact_ended_proof_; }

  /// As the bodies' motions have them, no pair comes closer within [t, end], which lies within one piece of
  /// each: proven, at most 0, and -infinity where nothing is. Up to δ/4 or 1 % it is the least signed
  /// distance.
  double least_distance(double t, double end);

  /// Whether all that the last proof was about stayed apart.
  bool nothing_touched() const noexcept { return nothing_touched_; }

 private:
  // What a look() found, and of what; or that planes across its normal are so far apart now (no band).
  struct KnownLook {
    Placement at_a, at_b;
    Eigen::Vector3d previous;  // normal
    double band = -1;
    PartContact contact;

    bool is_of(const Placement& a, const Placement& b) const;
  };

  struct Candidate {
    int part_a, part_b;
    ContactLaw law;
    Eigen::Vector3d normal = Eigen::Vector3d::UnitX();  ///< of the last find(), where it was near
    int near = -1;                                      ///< its number among the near pairs
    std::unique_ptr<KnownLook> known;                   ///< the last one, of few candidates
  };

  struct TimedLook {
    double time;
    PartContact contact;
  };

  // The ball around a part, and how far it may move.
  struct Swept {
    Eigen::Vector3d middle;
    double travel = 0;
    Eigen::Vector3d low, high;  // of a box around the ball and its way
  };

  void take_travels(double t, double dt);
  void sweep(double beyond);
  void sweep(double t, double dt, double beyond);
  bool may_meet(const Candidate& candidate, double beyond);
  void number_candidates();
  Candidate* candidate_of(int part_a, int part_b);
  double between_planes(int part_a, int part_b, const Eigen::Vector3d& normal, const Placement& at_a,
                        const Placement& at_b) const;
  Eigen::Vector3d middle(int part) const;
  double travel(int part, double t, double dt) const;
  void look(const Candidate& candidate, const Placement& at_a, const Placement& at_b, double band,
            PartContact& contact, PairTools& tools);
  const SimulatedPart& part(int number) const { return parts_[static_cast<std::size_t>(number)]; }
  double overlap_until(const Candidate& candidate, const Eigen::Vector3d& normal, double from, double to,
                       double most, PairTools& tools);
  bool is_apart(const Candidate& candidate) const;
  bool is_known_proven(const Candidate& candidate) const;
  double most_overlap(const NearPair& pair) const;
  double proven_pair(const Candidate& candidate, double t, double end, PairTools& tools);
  Placement place_of(int number) const;
  const PartContact* contact_now(Candidate& candidate, double band, double beyond, PairTools& tools);
  bool is_known_beyond(const Candidate& candidate, const Placement& at_a, const Placement& at_b,
                       double beyond) const;
  bool stays_away(const Candidate& candidate) const;
  bool stays(const Candidate& candidate, double least) const;
  PartContact look_at(const Candidate& candidate, double t, double band, PairTools& tools);
  double least_of(const Candidate& candidate, const TimedLook& first, const TimedLook& last, double enough,
                  int halvings, PairTools& tools);
  double free_until(const Body& a, const Body& b, double from, double to, double contact, PairTools& tools);
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

  const Dynamics& dynamics_;
  const std::vector<SimulatedBody>& bodies_;
  std::vector<SimulatedPart>& parts_;
  ContactScales scales_;
  SimulationCounters& counters_;
  int n_;
  std::shared_ptr<std::vector<Candidate>> candidates_;  // by their parts; groups share them, none the same
  std::vector<std::size_t> first_candidates_;           // of each part as the first, and their count
  std::vector<std::vector<int>> parts_of_;              // each body
  std::vector<int> scope_;                              // parts of the members
  std::vector<Swept> swept_;                            // of each part
  std::vector<std::optional<Eigen::AlignedBox3d>> standing_;  // around each part that stands
  std::vector<int> order_;                                    // of the parts, by where their boxes begin
  std::vector<Candidate*> may_meet_;                          // of the last sweep
  std::vector<NearPair> near_, before_;                       // of the last find(), and of the one before it
  std::vector<const PartContact*> found_;                     // of each of may_meet_
  std::vector<Candidate*> in_doubt_;                          // of may_meet_, where a proof takes work
  std::vector<double> proven_;                                // of these
  SharedTools<PairTools> tools_;
  ChunkTeam* team_ = nullptr;
  bool nothing_touched_ = true;
  bool contact_ended_proof_ = false;
};

}  // namespace raygauge
