// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <utility>

#include "engine/lp/weighted_points.h"
#include "engine/methods/column_generation/column_generation.h"
#include "engine/methods/column_generation/origin_question.h"
#include "engine/methods/nearest_point/nearest_point.h"
#include "engine/methods/newton/newton.h"
#include "engine/methods/problem.h"
#include "engine/methods/spatial/spatial_gauge.h"
#include "engine/methods/tangent_plane/tangent_plane.h"
#include "engine/methods/zheng_yamane/zheng_yamane.h"
#include "engine/numerics/aligned_buffer.h"
#include "raygauge/queries/warm_start.h"
#include "raygauge/sets/pose.h"

namespace raygauge {

/// What a query asks beyond d_Q(A): see Problem.
struct Aim {
  double threshold = std::numeric_limits<double>::quiet_NaN();
  SupportPairs* pairs = nullptr;
  /// Seconds left of the options' time limit, where the query has used some of it.
  double time_limit = std::numeric_limits<double>::infinity();
};

/// All methods, and who hands over to whom: the list kTurns in method_chain.cc. One solve's answer is that of
/// one method; counters and seconds are those of all that took part. The workspace behind DistanceSolver,
/// ObjectDistanceSolver and GrowthDistanceSolver.
class MethodChain {
 public:
  /// Throws InvalidParameterError for an option outside its range.
  explicit MethodChain(const DistanceOptions& options) { set_options(options); }

  const DistanceOptions& options() const noexcept { return options_; }
  void set_options(const DistanceOptions& options);
  void set_stop(std::function<bool()> stop) { stop_ = std::move(stop); }
  const std::function<bool()>& stop() const noexcept { return stop_; }

  /// d_Q(A); A and Q live in one space. `start`: a direction u to begin with, or nullptr.
  const DistanceResult& solve(const ConvexSet& A, const ConvexSet& Q, Effects effects,
                              const double* start = nullptr, const Aim& aim = {});

  /// The same for sets in poses, from and for a warm start, which may be null.
  const DistanceResult& solve(const Posed& A, const Posed& Q, Effects effects, WarmStart* warm,
                              const Aim& aim = {});

  /// After a solve with Aim::pairs: the points of A and their weights in the combination that proves the
  /// upper bound; false if there is none.
  bool contact_combination(WeightedPoints& combination) const;

  /// For A = A2 - A1: the nearest points of the last solve, where its method knows them apart; false where
  /// not.
  bool nearest_points(Vector& of_A1, Vector& of_A2) const;

 private:
  enum class Concluded : std::uint8_t {
    column_generation,
    zheng_yamane,
    nearest_point,
    spatial_gauge,
    newton,
    quad_newton,
    origin_question
  };

  /// One entry of the list: a method, when it is asked, and how. `solve` is true where the solve is over.
  struct Turn {
    bool (MethodChain::*is_due)(const Problem&) const;
    bool (MethodChain::*solve)(const Problem&);
  };
  static const Turn kTurns[];

  bool is_newton_asked_for_with_start(const Problem& problem) const;
  bool is_newton_asked_for(const Problem&) const { return chosen_ == DistanceMethod::newton; }
  bool is_zheng_yamane_asked_for(const Problem&) const { return chosen_ == DistanceMethod::zheng_yamane; }
  bool is_newton_untried(const Problem&) const { return chosen_ != DistanceMethod::newton; }
  bool has_normal(const Problem& problem) const;
  bool is_distant(const Problem&) const { return result_.lower > 0; }
  bool may_hold_origin(const Problem& problem) const;
  bool is_newton_near_origin(const Problem& problem) const;
  bool is_near_origin(const Problem&) const { return !(result_.lower > 0); }
  bool always(const Problem&) const { return true; }

  bool by_spatial_gauge(const Problem& problem);
  bool by_nearest_point(const Problem& problem);
  bool by_nearest_point_afresh(const Problem& problem);
  bool by_newton(const Problem& problem);
  bool by_newton_afresh(const Problem& problem);
  bool by_quad_newton_after_newton(const Problem& problem);
  bool by_zheng_yamane(const Problem& problem);
  bool by_column_generation(const Problem& problem);
  bool by_tangent_plane(const Problem& problem);
  bool by_origin_question(const Problem& problem);
  bool refined_by_newton(const Problem& problem);
  bool refined_by_quad_newton(const Problem& problem);
  bool refined_by_quad_newton_afresh(const Problem& problem);
  bool by_overlap(const Problem& problem);

  template <class Method>
  bool answers(Method& method, Concluded name, const Problem& problem);
  template <class Method>
  void refine(Method& method, Concluded name, const Problem& problem);
  void keep_newton_bounds(Effects effects);
  void account(const DistanceCounters& of_method);
  bool is_finished() const;

  DistanceOptions options_;
  std::function<bool()> stop_;
  DistanceResult result_;
  ColumnGeneration column_generation_;
  TangentPlane tangent_plane_;
  OriginQuestion origin_question_;
  bool is_origin_asked_ = false;  // in this solve
  bool is_newton_tried_ = false;  // the same
  ZhengYamane zheng_yamane_;
  NearestPoint nearest_point_;
  SpatialGauge spatial_gauge_;
  Newton<double> newton_;
  Newton<Quad> quad_newton_;
  Concluded concluded_ = Concluded::column_generation;
  DistanceMethod chosen_ = DistanceMethod::column_generation;  // the method of this solve

  AlignedBuffer<double> start_;

  Stopwatch stopwatch_;        // over all methods that take part
  DistanceCounters counters_;  // of all of them
};

}  // namespace raygauge
