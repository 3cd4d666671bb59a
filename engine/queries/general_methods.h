// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "engine/methods/column_generation/column_generation.h"
#include "engine/methods/column_generation/origin_question.h"
#include "engine/methods/nearest_point/nearest_point.h"
#include "engine/methods/newton/newton.h"
#include "engine/methods/spatial/spatial_gauge.h"
#include "engine/methods/tangent_plane/tangent_plane.h"
#include "engine/methods/zheng_yamane/zheng_yamane.h"
#include "engine/sets/object_pair.h"

namespace raygauge {

/// The methods for any sets, in the order of GeneralMethods::methods_.
enum class MethodId : std::uint8_t {
  spatial_gauge,
  nearest_point,
  newton,
  quad_newton,
  origin_question,
  zheng_yamane,
  column_generation,
  tangent_plane,
};

/// Where a method begins: at the direction of the problem, at its own, where Newton steps in doubles ended,
/// or at the normal of the bounds so far.
enum class Start : std::uint8_t { given, afresh, of_newton, of_bounds };

/// What the methods for any sets make of one problem d_Q(A), each asked in its turn by a Ladder. The bounds
/// are the best of all, counters are those of all.
class GeneralMethods {
 public:
  /// Of a new problem, which must outlive the solve, as must `result`.
  void begin(const Problem& problem, DistanceResult& result);

  /// One turn; true where the solve is over. No method is asked twice from the same start.
  bool ask(MethodId id, Start start);

  void finish();

  DistanceMethod chosen() const noexcept { return chosen_; }  ///< of this solve, by the options or the sets
  const Problem& problem() const noexcept { return *problem_; }
  const DistanceResult& result() const noexcept { return *result_; }
  bool has_normal() const noexcept;
  bool is_newton_near_origin() const noexcept { return newton_.direction() == nullptr; }

  /// Where A = A2 - A1 was asked through `pairs`, and they are apart: the closest points; false where the
  /// method knows of none.
  bool closest_points(const SupportPairs& pairs, Vector& of_A1, Vector& of_A2);

 private:
  Method& method(MethodId id) noexcept { return *methods_[static_cast<std::size_t>(id)]; }
  const double* direction(Start start);
  bool is_new(MethodId id, const Problem& from, Start start);
  void keep(Method& method, bool done);
  void use(const WeightedPoints& combination, bool is_new);
  void adopt_kept();
  void account(const DistanceCounters& of_method);
  bool is_finished() const noexcept;

  SpatialGauge spatial_gauge_;
  NearestPoint nearest_point_;
  Newton<double> newton_;
  Newton<Quad> quad_newton_;
  OriginQuestion origin_question_;
  ZhengYamane zheng_yamane_;
  ColumnGeneration column_generation_;
  TangentPlane tangent_plane_;
  const std::array<Method*, 8> methods_ = {&spatial_gauge_,     &nearest_point_,   &newton_,
                                           &quad_newton_,       &origin_question_, &zheng_yamane_,
                                           &column_generation_, &tangent_plane_};

  // Of the solve at hand.
  const Problem* problem_ = nullptr;
  DistanceResult* result_ = nullptr;
  DistanceMethod chosen_ = DistanceMethod::column_generation;
  DistanceCounters counters_;
  std::uint64_t asked_ = 0;            // a bit for every method with a start
  bool has_bounds_ = false;            // the result
  const Method* concluded_ = nullptr;  // whose combination proves the upper bound; nullptr: combination_
  const WeightedPoints* combination_ = nullptr;
  DistanceResult refined_;  // of a method that comes after others
  DistanceResult kept_;     // the best bounds of those that gave up before the result had any
  WeightedPoints refined_combination_, kept_combination_;
  AlignedBuffer<double> start_;
};

}  // namespace raygauge
