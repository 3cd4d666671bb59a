// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "engine/methods/bodies/depth_oracle.h"
#include "engine/methods/bodies/inner_polytope.h"
#include "engine/methods/bodies/open_facets.h"
#include "engine/methods/bodies/proven_cap.h"
#include "engine/methods/bodies/tuning.h"
#include "engine/numerics/stopwatch.h"
#include "raygauge/methods/result.h"

namespace raygauge {

enum class DepthEnd : std::uint8_t {
  closed,    ///< the bounds meet
  flat,      ///< D has no interior, but for rounding: only the upper bound means anything
  rounding,  ///< a better polytope is lost in rounding
  limit,     ///< of facets
  time,      ///< the watch
};

inline DistanceStatus status_of(DepthEnd end) noexcept {
  if (end == DepthEnd::closed) return DistanceStatus::optimal;
  if (end == DepthEnd::limit) return DistanceStatus::iteration_limit;
  return end == DepthEnd::time ? DistanceStatus::time_limit : DistanceStatus::precision_limit;
}

/// The depth  min h_D(u)/h_Q(u)  over all directions u, by the expanding polytope method (van den Bergen,
/// "Proximity queries and penetration depth computation on 3D game objects", 2001). The least offset/h_Q(n)
/// over the facets of a polytope inside D is a lower bound for all directions at once, which InnerPolytope
/// proves; h_D(u)/h_Q(u) of any direction is an upper bound. The facet that is least is expanded until they
/// meet, so that the minimum is a global one. Of curved bodies a face that touches D is found from the pieces
/// that the corners of a facet are on, and ProvenCap spares the facets beside it.
template <class Real>
class DepthSearch {
 public:
  using Vector = BasicVector3<Real>;

  /// What is known of D beforehand, and when a gap is closed: `tolerance` times the depth of D plus a ball
  /// that D lacks, of radius ball_lower to ball_upper.
  struct Goal {
    double tolerance = 1e-6;
    double floor = 0;  ///< proven: the depth of D is not below it
    double ball_lower = 0, ball_upper = 0;
    bool is_first = false;  ///< what rounding hides is searched again in more precise arithmetic
    double enough = 0;      ///< a gap of this size is closed, too
  };

  DepthEnd run(DepthOracle<Real>& oracle, const Vector& start, const Goal& goal, const Stopwatch& watch);

  /// From the polytope of a D that was about the same, not empty. False where the bounds do not meet, and the
  /// search has to begin anew.
  bool run_again(DepthOracle<Real>& oracle, const DepthMemory& memory, const Goal& goal,
                 const Stopwatch& watch);

  /// The polytope of the last run, if it is another one than `memory`, from which that began.
  /// corner_of(point) says how it is found again.
  template <class CornerOf>
  void record(const CornerOf& corner_of, DepthMemory& memory) {
    if (iterations_ > tuned::kStepsWorthRecording || !polytope_.is_joined())
      polytope_.record(corner_of, memory);
  }

  /// Of D alone, without the ball; -infinity where nothing is proven.
  double lower() const noexcept { return lower_; }
  double upper() const noexcept { return upper_; }

  /// The direction that proves upper(), of length 1 in about.
  const Vector& normal() const noexcept { return normal_; }

  /// The points of both bodies whose difference is t u, where the ray along u leaves the polytope: for
  /// normal() t is between both bounds. False where D is flat, or the origin is not inside the polytope.
  bool contact(const Vector3& u, Vector3& a1, Vector3& a2) const;

  /// Adds to `normals` those of facets that are as near as the least one, to the share `relative` of the
  /// depth and the ball, and differ from normal() and each other by more than `angle`; at most as many as
  /// make 64.
  void add_near_normals(double relative, double angle, std::vector<Vector3>& normals) const;

  int iterations() const noexcept { return iterations_; }

 private:
  void restart(DepthOracle<Real>& oracle, const Goal& goal);
  bool begin(const Vector& start);
  DepthEnd expand(const Stopwatch& watch);
  bool closes(double lower) const;
  double closing() const;
  bool is_lost() const;
  void probe(const Vector& u, DepthPoint<Real>& point, bool is_unit);
  int probe_both(const Vector& u, const Vector& from, DepthPoint<Real>* point);
  double value_of(const DepthFacet<Real>& facet) const;
  bool find_cap(std::int32_t least, const DepthPoint<Real>& found);
  void take_likely_face();
  void reopen_facets();
  std::int32_t evaluate_new_facets();
  void open_new_facets();
  bool settles(std::int32_t i, double enough);
  std::int32_t walk_to_exit(const Vector3& u) const;

  InnerPolytope<Real> polytope_;
  ProvenCaps caps_;          // of faces as near as the bound
  OpenFacets open_;          // that may have to be expanded
  OpenFacets::Least least_;  // of them
  std::vector<double>
      value_;           // of every facet: what is proven beside it: its offset/h_Q(n), or that of a cap
  double settled_ = 0;  // the least of those that close the gap as it was when they were made
  DepthOracle<Real>* oracle_ = nullptr;
  Goal goal_;
  double lower_ = 0, upper_ = std::numeric_limits<double>::infinity();
  Vector normal_;
  int iterations_ = 0, bent_trials_ = 0;
  std::int32_t near_ = 0;  // the facet that was looked at last
  bool solid_ = false;
};

extern template class DepthSearch<double>;
extern template class DepthSearch<DoubleDouble>;

}  // namespace raygauge
