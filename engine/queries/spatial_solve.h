// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/spatial/spatial_distance.h"
#include "engine/methods/spatial/tuning.h"
#include "raygauge/methods/result.h"

namespace raygauge {

/// Solves about two bodies of R^2 or R^3 by fixed-size code. What is made of the sets stays from one solve to
/// the next: place() is all that a body in motion costs. Everything else that a solve computes is in a record
/// that is new for each. A solve that returns false has no answer that is as precise as was asked for; the
/// bounds of answer() hold nevertheless.
class SpatialSolve {
 public:
  /// The sets of what follows, which must outlive it. False if one of them has no SpatialShape, or they live
  /// in other spaces.
  bool bind(const ConvexSet& first, const ConvexSet& second, InstructionSet isa);

  /// The same of shapes in R^n; nothing is scaled about the origin then.
  void bind(const SpatialShape& first, const SpatialShape& second, int n, InstructionSet isa);

  /// Curved bodies most likely meet, if they are near: steps in doubles, which prove it, are not left early.
  void expect_overlap() noexcept { near_curved_ = 1e-8; }

  /// A distance whose bounds are so close is as precise as is asked for, whatever its tolerance.
  void set_enough(double gap) noexcept { enough_ = gap; }

  /// Their poses, whose numbers must outlive the solves. False if sizes are out of range.
  bool place(const PoseNumbers& first, const PoseNumbers& second) { return pair_.place(first, second); }

  /// The Euclidean distance. Where true, answer().end is `closed`, and closest_points() hold, or
  /// `intersecting`. Bodies with interior points in common are `intersecting`, down to rounding errors of
  /// double-double arithmetic; so are those in a common plane (make_prism_of_flat).
  /// Where `likely_overlap` is given, the plane of before no longer separates the bodies and a depth takes
  /// little time, that is set, and nothing is found.
  bool distance(double tolerance, PairStart* warm, bool* likely_overlap = nullptr);

  /// The growth distance: the least factor by which both bodies have to be scaled, each about its centre, or
  /// the first one about the origin of the world, to touch. Ends early where it is proven to be on one side
  /// of `threshold`; NaN: never. `fine_normal`: the normal has to be as exact as the bounds, for gradients.
  bool growth(bool about_origin, double tolerance, double threshold, PairStart* warm,
              bool fine_normal = false);

  const SpatialAnswer& answer() const noexcept { return record_.answer; }
  const SpatialPair& pair() const noexcept { return pair_; }
  int dimension() const noexcept { return pair_.dimension(); }
  /// Points that one pass over both bodies looks at.
  std::ptrdiff_t points() const noexcept { return points_of(pair_.shape(0)) + points_of(pair_.shape(1)); }

  /// The normal that proves the lower bound of the last distance where that is above 0, of length one, in the
  /// world: n numbers.
  const double* normal() const noexcept { return record_.normal; }

  /// The same of the last growth distance where that is above 0, scaled as DistanceResult::normal is.
  void growth_normal(double* normal) const;

  /// The closest points of the bodies in the world, n numbers each.
  void closest_points(double* point_1, double* point_2) const;

 private:
  // All that a solve knows. What is behind a count or a flag, such as the points of a combination, is written
  // whole before that is raised, and is not read before: clearing it would take as long as some of the
  // solves.
  struct Record {
    SpatialStart start;
    SpatialAnswer answer;
    double normal[3] = {0, 0, 0};

    void begin() noexcept {
      start.has_normal = false;
      start.count = 0;
      answer.begin();
      normal[2] = 0;  // of R^2
    }
  };

  static std::ptrdiff_t points_of(const SpatialShape& shape) noexcept {
    return shape.kind == SpatialShape::Kind::points ? shape.size : 0;
  }
  bool find_distance(double tolerance, const PairStart* warm);
  void step_on_cores(double tolerance);
  bool settle(double tolerance);
  bool find_overlap();
  void turn_normal();
  bool find_growth(bool about_origin, double tolerance, double threshold);
  void go_on_in_ball(double tolerance, double threshold);
  bool begin_with_vertices(const PairStart* warm);
  void begin_with_normal(const PairStart* warm);
  void record(PairStart* warm) const;

  SpatialPair pair_;
  Record record_;
  const ConvexSet* first_ = nullptr;
  InstructionSet isa_ = InstructionSet::automatic;
  double enough_ = 0;
  double near_curved_ = tuned::kNearCurved;  // of the size: where other steps are faster
};

}  // namespace raygauge
