// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "engine/queries/depth_query.h"
#include "engine/queries/general_methods.h"
#include "engine/queries/growth_body.h"
#include "engine/queries/half_space_query.h"
#include "engine/queries/pose_gradients.h"
#include "engine/queries/spatial_query.h"
#include "engine/sets/parameters.h"
#include "raygauge/queries/mesh_distance.h"
#include "raygauge/sets/ball.h"

namespace raygauge {

enum class Question : std::uint8_t {
  gauge = 1,       ///< d_Q(A)
  distance = 2,    ///< d_Q(A2 - A1)
  growth = 4,      ///< the growth distance of two objects
  separation = 8,  ///< whether two objects are apart: the growth distance up to a bound on one side of 1
};

/// A question, and what the rungs have made of it so far.
struct Ask {
  /// Throws DimensionMismatchError for a pose that is not of its set's space.
  Ask(Question what, const Posed& one, const Posed& two, WarmStart* start)
      : question(what), first(one), second(two), warm(start) {
    for (const Posed* body : {&first, &second}) {
      if (body->pose != nullptr && body->pose->dimension() != body->dimension()) [[unlikely]]
        check_dimension("pose", "its rotation", body->pose->dimension(), body->dimension());
    }
  }

  Question question;
  Posed first, second;  ///< A and Q of a gauge; A1 and A2 of all others
  WarmStart* warm;
  const ConvexSet* metric = nullptr;                            ///< of a distance: Q
  Effects effects = Effects::none;                              ///< of a gauge
  ObjectEffects object_effects = ObjectEffects::none;           ///< of a distance
  PoseGradient* pose_gradient = nullptr;                        ///< growth: wanted
  bool about_origin = false;                                    ///< growth: A1 is scaled about the origin
  double threshold = Goal().threshold;                          ///< growth: see Problem
  double time_limit = std::numeric_limits<double>::infinity();  ///< what the options' limit leaves

  /// Rungs that have been asked and have no answer: fixed-size code for the Euclidean distance, and all those
  /// of the growth distance.
  bool is_distance_open = false, is_growth_open = false;
  bool is_known = false;  ///< the growth distance, to the tolerance
  ProvenBounds proven;    ///< by fixed-size code that has no answer
};

/// All methods, and which of them is asked when: the one table that distances, distances of objects, growth
/// distances, separations and scenes go by is kRungs in ladder.cc. The workspace behind all solvers.
class Ladder {
 public:
  /// Throws InvalidParameterError for an option outside its range.
  explicit Ladder(const DistanceOptions& options) { set_options(options); }

  const DistanceOptions& options() const noexcept { return options_; }
  void set_options(const DistanceOptions& options);
  void set_stop(std::function<bool()> stop) { stop_ = std::move(stop); }

  /// Bounds of a distance or a depth of bodies that are so close need no more work, whatever the tolerance.
  /// 0: the tolerance alone counts.
  void set_enough(double gap) noexcept {
    enough_ = gap;
    bodies_.set_enough(gap);
    depth_.set_enough(gap);
  }
  double enough() const noexcept { return enough_; }

  /// Of the last distance, or of a formula that needs no ladder.
  ObjectDistance& answer() noexcept { return answer_; }

  /// Each answer lives until the next question.
  const DistanceResult& gauge(Ask& ask);
  ObjectDistance& distance(Ask& ask);
  const DistanceResult& growth(Ask& ask);
  const SeparationResult& separation(Ask& ask);

  /// The table in Markdown: the README of this folder has it.
  static std::string table();

 private:
  struct Rung;
  struct Due;
  struct Solve;
  enum class Group : std::uint8_t { bodies, general, open };
  static const Rung kRungs[];

  template <Question kQuestion, Group kGroup>
  bool climb(Ask& ask);
  template <Question kQuestion>
  void answer(Ask& ask);
  template <Question kQuestion>
  void go_on(Ask& ask);
  void ask_general_methods(Ask& ask);
  void climb_general(const ConvexSet& A, const ConvexSet& Q, const Ask& ask, SupportPairs* pairs);
  void tighten(const Ask& ask);
  void find_depth(const Ask& ask);
  void find_pose_gradient(const Ask& ask);
  void find_growth_gradient(const Ask& ask);
  MeshDistanceSolver& mesh_solver();
  const SpatialPair* known_pair(const Ask& ask) const;
  double time_left() const;
  bool conclude();
  void conclude(Separation outcome, Bounds growth);

  DistanceOptions options_;
  double enough_ = 0;
  std::function<bool()> stop_;
  Stopwatch stopwatch_;  // over all general methods that take part
  SpatialQuery bodies_;
  HalfSpaceQuery half_space_;
  std::unique_ptr<MeshDistanceSolver> meshes_;  // once there was one: it has a ladder of its own
  GeneralMethods methods_;
  ObjectDistance answer_;
  SeparationResult separation_;
  DistanceResult outer_;  // of a question while another one is asked for it

  DepthQuery depth_;
  PairStart depth_start_;
  bool has_depth_start_ = false;
  bool guesses_overlap_ = false;  // for the next depth
  PoseGradients pose_gradients_;

  SupportPairs pairs_;
  PosedCenter center_1_, center_2_;
  std::unique_ptr<const Ball> ball_;  // of the Euclidean distance
};

// Each is true where it has answered the question.
struct Ladder::Solve {
  static bool by_passes(Ladder& ladder, Ask& ask);
  static bool body_distance(Ladder& ladder, Ask& ask);
  static bool body_growth(Ladder& ladder, Ask& ask);
  static bool mesh(Ladder& ladder, Ask& ask);
  static bool half_space(Ladder& ladder, Ask& ask);
  static bool common_point(Ladder& ladder, Ask& ask);
  static bool depth(Ladder& ladder, Ask& ask);
  static bool overlap(Ladder& ladder, Ask& ask);
  static bool growth_into(Ladder& ladder, Ask& ask);
  static bool distance(Ladder& ladder, Ask& ask);
  template <MethodId kId, Start kStart>
  static bool by(Ladder& ladder, Ask& /*ask*/) {
    return ladder.methods_.ask(kId, kStart);
  }
};

}  // namespace raygauge
