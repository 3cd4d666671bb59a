// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "engine/methods/bodies/body_oracles.h"
#include "engine/methods/bodies/frustum_depth.h"
#include "engine/methods/bodies/polytope_depth.h"
#include "engine/methods/bodies/zonotope_depth.h"
#include "engine/numerics/stopwatch.h"
#include "engine/proof/bounds.h"
#include "engine/queries/spatial_solve.h"
#include "raygauge/methods/result.h"

namespace raygauge {

/// What is known of the Euclidean depth of two bodies of R^2 or R^3; vectors in the world.
struct BodyDepthAnswer {
  Bounds bounds;
  DistanceStatus status = DistanceStatus::precision_limit;
  Vector3 normal;            ///< of length 1: the way for the first body to get out
  Vector3 point_1, point_2;  ///< of the bodies: point_2 - point_1 is depth times the normal, to the gap
  std::int64_t support_queries = 0;
  int iterations = 0;
  bool parted = false;  ///< proven apart by the normal of before, or a guess has failed; nothing is said then
};

/// Rounded outward.
inline double down(const DoubleDouble& x) { return x.rounded() - std::fabs(x.high) * 0x1p-52; }
inline double up(const DoubleDouble& x) { return x.rounded() + std::fabs(x.high) * 0x1p-52; }

/// What a solve of the pair has recorded, or nothing.
struct DepthStart {
  const PairStart* pair = nullptr;
  const DepthMemory* polytope = nullptr;
  bool is_guess = false;  ///< the bodies may be apart: what takes long is not begun
  bool is_kept = false;   ///< what is found will be asked of the next solve, too
};

/// The depth of two bodies by fixed-size code. Of both the cores and the radius r of the sum of their balls:
/// where the cores are apart, the depth is r less their distance; where they meet, it is that of the cores
/// plus r, for  h(u) = h_cores(u) + r|u|.  In doubles first, then in double-double arithmetic.
class BodyDepth {
 public:
  /// The sets, which must outlive the solves. False if one of them has no SpatialShape.
  bool bind(const ConvexSet& first, const ConvexSet& second, InstructionSet isa);
  /// A depth whose bounds are so close is not refined, whatever its tolerance.
  void set_enough(double gap) noexcept {
    enough_ = gap;
    cores_.set_enough(gap / 4);
  }
  /// Where they are; the numbers must outlive the solves.
  bool place(const PoseNumbers& first, const PoseNumbers& second);

  /// Of bodies that are not known to be apart. Where an overlap was recorded, one look along its normal comes
  /// first: most bodies that part do so across it.
  void solve(double tolerance, const DepthStart& start, const Stopwatch& watch, BodyDepthAnswer& answer);

  /// The polytope that was found, or the vertices that are the nearest of cores that are apart. None where
  /// they are not vertices.
  void record(WarmStart& warm);

  /// Of the last solve: other directions of the world that are as short, see DepthSearch::add_near_normals.
  void add_near_normals(double relative, double angle, std::vector<Vector3>& normals) const;

 private:
  enum class Source : std::uint8_t { none, hull, boxes, polytopes, frustum, quick, precise };
  bool has_balls() const noexcept { return radius_[0] > 0 || radius_[1] > 0; }
  bool has_parted(const PairStart& start, BodyDepthAnswer& answer);
  bool solve_apart(double tolerance, const PairStart* start, BodyDepthAnswer& answer);
  void bound_apart(BodyDepthAnswer& answer);
  DoubleDouble ball_height(const PreciseVector3& u) const;
  void refine_apart(BodyDepthAnswer& answer);
  bool is_tiny(const PoseNumbers& first, const PoseNumbers& second);
  void bound_tiny(double tolerance, BodyDepthAnswer& answer) const;
  bool search_again(double tolerance, const DepthMemory& memory, const Stopwatch& watch,
                    BodyDepthAnswer& answer);
  bool leave_hull(double tolerance, BodyDepthAnswer& answer);
  bool leave_boxes(double tolerance, BodyDepthAnswer& answer);
  bool leave_polytopes(double tolerance, BodyDepthAnswer& answer);
  template <class Known>
  bool leave_known(const Known& known, Source source, const Vector3& from, double tolerance,
                   BodyDepthAnswer& answer);
  void add_near_planes(double relative, double angle, std::vector<Vector3>& normals) const;
  template <class Known>
  void add_near_facets(const Known& known, double relative, double angle,
                       std::vector<Vector3>& normals) const;
  void search(double tolerance, const PairStart* start, const Stopwatch& watch, BodyDepthAnswer& answer);
  template <class Real>
  void take(DepthSearch<Real>& search, bool world, BodyDepthAnswer& answer);
  void put_points(const Vector3& normal, const Vector3& a1, const Vector3& a2, BodyDepthAnswer& answer) const;
  void find_near_points(BodyDepthAnswer& answer, Vector3& a1, Vector3& a2);

  SpatialShape core_[2];  // without their balls, if there is one
  double radius_[2] = {0, 0}, extent_[2] = {0, 0};
  DoubleDouble ball_lower_, ball_upper_;  // of the sum of both balls, in their poses
  InstructionSet isa_ = InstructionSet::automatic;
  SpatialSolve cores_;
  SpatialPair pair_;  // the cores
  DepthSearch<double> quick_;
  DepthSearch<DoubleDouble> precise_;
  Vector3 normal_;              // of the answer, in the frame of the first body, outward of S1 - S2
  HullSurface::Nearest plane_;  // of a hull that both bodies are proven by
  ZonotopeDepth boxes_;
  PolytopeDepth polytopes_;
  FrustumDepth frustum_;
  PolytopeFaces box_;  // the facets of the one that is a box, or the ends of a segment
  double enough_ = 0;
  double tiny_ = 0;               // at least |s| on the difference of cores that are as good as one point
  double floor_ = 0;              // proven of the depth of the cores
  PairStart nearest_;             // of the cores, where these are apart
  bool has_points_ = false;       // of the answer
  Source source_ = Source::none;  // searched last
};

}  // namespace raygauge
