// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "raygauge/methods/options.h"
#include "raygauge/methods/result.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/convex_set.h"
#include "raygauge/sets/pose.h"

namespace raygauge {

/// Two bodies in poses, or a set and a gauge. Nothing is copied; sets and poses must outlive the call.
struct PosedPair {
  Posed first, second;
};

/// Gives pair i, in thread 0, 1, … of the batch, which solves it before it asks for another: sets and poses
/// that are made for the pair may be kept in one place per thread. What it throws ends the batch.
using PairSource = std::function<PosedPair(std::size_t i, int thread)>;

/// Output arrays of the caller; entry i is for pair i. Empty arrays are not computed; any other has room for
/// all pairs. Arrays of vectors hold n numbers a pair, NaN where there is no such vector (the bodies meet).
struct BatchAnswers {
  std::span<double> distance;          ///< as in DistanceResult ...
  std::span<double> lower, upper;      ///< ... its certified bounds ...
  std::span<DistanceStatus> status;    ///< ... and how the solve ended
  std::span<double> normal;            ///< DistanceResult::normal
  std::span<double> closest_points_1;  ///< distances alone
  std::span<double> closest_points_2;
  std::span<double> contact_points;       ///< gauge distances alone: DistanceResult::contact_point
  std::span<std::int64_t> pivots;         ///< basis changes
  std::span<GradientKind> gradient_kind;  ///< distances in R^2 and R^3 alone: ObjectDistance::pose_gradient
  std::span<double> pose_gradients_1;     ///< 3 n - 3 numbers a pair: of its Twist what counts in R^n
  std::span<double> pose_gradients_2;
};

/// Output arrays of separations, of the caller: entry i is for pair i.
struct SeparationAnswers {
  std::span<Separation> outcome;
  std::span<double> normal;  ///< empty, or n numbers a pair: as SeparationResult::normal, NaN without
};

/// The largest number of threads of a batch.
inline constexpr int kMostBatchThreads = 4096;

/// Distances of many pairs of bodies in one call, on threads. Every answer is that of the solver for
/// the pair alone, whatever the number of threads. An error names its pair, counted from 0: "problem 3: …".
///
/// One batch object per caller; it keeps the solvers of its threads from one call to the next, and a repeated
/// call allocates nothing.
class PairBatch {
 public:
  /// `threads` share the pairs, options.threads for 0; each solve stays on one. Throws InvalidParameterError
  /// for an option outside its range.
  explicit PairBatch(const DistanceOptions& options, int threads = 0);
  ~PairBatch();
  PairBatch(PairBatch&&) noexcept;
  PairBatch& operator=(PairBatch&&) noexcept;

  /// Every thread asks it before each pair and during solves; once it returns true no pair is begun. It must
  /// be safe to call from all threads at once.
  void set_stop(std::function<bool()> stop);

  /// The distance of each pair in the metric of Q. `warm` is empty, or has one entry a pair that is updated.
  /// Throws DimensionMismatchError where a body does not live in Q's space, and InvalidParameterError for an
  /// array of another size; nothing is solved then.
  void distances(std::span<const PosedPair> pairs, const ConvexSet& Q, const BatchAnswers& answers,
                 std::span<WarmStart> warm = {});

  /// The growth distance of each pair about both centres. All bodies live in one space; throws as above.
  void growth_distances(std::span<const PosedPair> pairs, const BatchAnswers& answers,
                        std::span<WarmStart> warm = {});

  /// Whether the bodies of each pair are separated, as GrowthDistanceSolver::separation proves it; pairs that
  /// a stop left out are `undecided`. Boxes, balls, capsules and hulls of up to 32 points of R^3 are first
  /// asked in vectors of several pairs, in doubles: their normals are other ones than those of single tests,
  /// each proven. All bodies live in one space; throws as distances(), but pairs before the one in error may
  /// have their answers.
  void separations(std::span<const PosedPair> pairs, const SeparationAnswers& answers);

  /// The same of `count` pairs in R^n. A pair that the vectors leave open is asked for again.
  void separations(std::size_t count, const PairSource& pairs, int n, const SeparationAnswers& answers);

  /// The distance of each of `count` pairs in the metric of Q; with ObjectEffects::depth, of bodies that
  /// meet, minus the depth with its bounds, normal and points. Throws as above and what `pairs` throws.
  void distances(std::size_t count, const PairSource& pairs, const ConvexSet& Q, const BatchAnswers& answers,
                 ObjectEffects effects = ObjectEffects::none);

  /// d_Q(A) of each of `count` pairs of a set A and a gauge Q of R^n. With `along_path` a pair starts from
  /// what the one before it left, except for each pair whose number is a multiple of 16.
  void gauge_distances(std::size_t count, const PairSource& pairs, int n, const BatchAnswers& answers,
                       bool along_path = false);

 private:
  struct Team;
  template <class Source>
  void separate(std::size_t count, const Source& pairs, int n, const SeparationAnswers& answers);

  std::unique_ptr<Team> team_;
};

}  // namespace raygauge
