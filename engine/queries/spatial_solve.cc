// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/spatial_solve.h"

#include <algorithm>
#include <cmath>

#include "engine/methods/spatial/closed_form_distance.h"
#include "engine/methods/spatial/contact_distance.h"
#include "engine/methods/spatial/flat_pair.h"
#include "engine/methods/spatial/inner_ball.h"
#include "engine/methods/spatial/precise_distance.h"
#include "engine/methods/spatial/precise_growth.h"
#include "engine/methods/spatial/spatial_growth.h"
#include "engine/methods/spatial/tuning.h"

namespace raygauge {
namespace {

constexpr double kLeastSquare = 1e-200;  // of a normal that a start may have
constexpr double kClose = 0x1p-40;       // of a size
constexpr double kUnitSquare = 0x1p-50;  // how far from 1 the square of a unit vector may be

// Needles of an ellipsoid: support points of doubles crowd around the contact, and double-double Newton steps
// find it at once; not of many points, whose passes in that arithmetic take longer.
bool is_smooth_needle(const SpatialPair& pair, std::ptrdiff_t points) {
  constexpr double kThin = 1e-4;
  constexpr std::ptrdiff_t kMostPoints = 100;
  return points <= kMostPoints && (has_curved_surface(pair.shape(0)) || has_curved_surface(pair.shape(1))) &&
         pair.inner_radius() < kThin * (pair.shape(0).extent + pair.shape(1).extent);
}

// Whether the contact is found by Newton steps on pieces.
bool has_pieces(const SpatialPair& pair) { return pair.is_curved() && pair.dimension() == 3; }

// Newton steps from the normal of before, with the pieces that it was on. False where they lead nowhere: then
// nothing of that start is used.
bool go_on_from_pieces(SpatialPair& pair, double tolerance, const PairStart* warm, SpatialStart& start,
                       SpatialAnswer& answer) {
  constexpr double kPreciseGap = 64;  // of error(): a gap that double-double steps close
  if (warm == nullptr || warm->dimension != 3 || warm->count <= 0 || !start.has_normal) return false;
  answer.begin_steps();
  answer.hint = start.normal * (1 / length(start.normal));
  SpatialCombination& pieces = answer.combination;
  const int count = std::min(warm->count, 4);
  double height = -__builtin_inf();
  for (int i = 0; i < count; ++i) {
    SpatialPoint& piece = pieces.point[i];
    piece.index_1 = warm->point_A[static_cast<std::size_t>(i)];
    piece.index_2 = warm->point_Q[static_cast<std::size_t>(i)];
    pair.find_named(answer.hint, piece);
    pieces.weight[i] = 1.0 / count;
    height = std::max(height, dot(answer.hint, piece.s));
  }
  pieces.count = count;
  start.has_normal = false;
  if (height + pair.radius() > tuned::kNearCurved * pair.size()) return false;  // it is of another place
  contact_distance(pair, tolerance, answer);
  start.has_normal = answer.end != SpatialEnd::open || answer.bounds.gap() <= kPreciseGap * pair.error();
  return start.has_normal;
}

// Whether a vertex of the start is beyond the plane that was between the bodies.
bool is_beyond_plane(const SpatialPair& pair, const SpatialStart& start, const PairStart& warm) {
  const double* normal = recorded_normal(warm, pair.dimension());
  if (normal == nullptr) return false;
  const Vector3 u = -pair.frame().to_body(normal);
  const double room = (pair.radius() - pair.error()) * length(u);
  SpatialPoint point;
  for (int i = 0; i < start.count; ++i) {
    if (pair.vertex(start.index_1[i], start.index_2[i], point) && dot(u, point.s) + room > 0) return true;
  }
  return false;
}

// Bodies whose depth is that of boxes, or mostly follows from the distance of their cores.
bool has_quick_depth(const SpatialPair& pair) {
  const auto is_box = [&](int i) { return pair.shape(i).kind == SpatialShape::Kind::box; };
  return pair.radius() > 0 || (is_box(0) && is_box(1));
}

}  // namespace

bool SpatialSolve::bind(const ConvexSet& first, const ConvexSet& second, InstructionSet isa) {
  first_ = &first;
  isa_ = isa;
  return pair_.bind(first, second, isa);
}

void SpatialSolve::bind(const SpatialShape& first, const SpatialShape& second, int n, InstructionSet isa) {
  first_ = nullptr;
  isa_ = isa;
  pair_.bind(first, second, n, isa);
}

// Whether the start has vertices.
bool SpatialSolve::begin_with_vertices(const PairStart* warm) {
  const bool known = warm != nullptr && warm->dimension == pair_.dimension() && pair_.has_vertices();
  if (!known || warm->count <= 0) return false;
  record_.start.count = std::min(warm->count, 4);
  std::copy_n(warm->point_A.begin(), 4, record_.start.index_1);
  std::copy_n(warm->point_Q.begin(), 4, record_.start.index_2);
  return true;
}

void SpatialSolve::begin_with_normal(const PairStart* warm) {
  if (warm == nullptr) return;
  const double* normal = recorded_normal(*warm, pair_.dimension());
  if (normal == nullptr) return;
  record_.start.normal = -pair_.frame().to_body(normal);
  const double square = dot(record_.start.normal, record_.start.normal);
  record_.start.has_normal = square > kLeastSquare && square < 1 / kLeastSquare;
}

// All but the normal.
void SpatialSolve::record(PairStart* warm) const {
  warm->dimension = pair_.dimension();
  warm->normal = {0, 0, 0};
  warm->count = 0;
  if (!pair_.has_vertices() && !has_pieces(pair_)) return;
  warm->count = record_.answer.combination.count;
  for (std::size_t i = 0; i < static_cast<std::size_t>(warm->count); ++i) {
    warm->point_A[i] = record_.answer.combination.point[i].index_1;
    warm->point_Q[i] = record_.answer.combination.point[i].index_2;
  }
}

void SpatialSolve::closest_points(double* point_1, double* point_2) const {
  const SpatialCombination& combination = record_.answer.combination;
  Vector3 a1, a2;
  for (int i = 0; i < combination.count; ++i) {
    a1 = a1 + combination.point[i].a1 * combination.weight[i];
    a2 = a2 + combination.point[i].a2 * combination.weight[i];
  }
  const Vector3 way = a2 - a1;
  const double size = pair_.radius() > 0 ? length(way) : 0.0;
  if (size > 0) {
    a1 = a1 + way * (pair_.shape(0).radius / size);
    a2 = a2 - way * (pair_.shape(1).radius / size);
  }
  pair_.frame().point_to_world(a1, point_1);
  pair_.frame().point_to_world(a2, point_2);
}

// Near hulls of many points: the facet of their difference between the centres is found by fewer support
// points than the nearest one, and is mostly that one.
void SpatialSolve::step_on_cores(double tolerance) {
  const bool has_start = record_.start.count > 0 || record_.start.has_normal;
  const bool may_begin_at_portal =
      pair_.has_vertices() && pair_.radius() == 0 &&
      points() > (has_start ? tuned::kFewPointsFromStart : tuned::kFewPointsOfHulls);
  spatial_distance(
      pair_, tolerance, record_.start,
      may_begin_at_portal ? SpatialNearness{tuned::kNearFacets, tuned::kTouchingFacets} : SpatialNearness{},
      record_.answer);
  if (!may_begin_at_portal || record_.answer.end != SpatialEnd::open ||
      !(record_.answer.bounds.upper() > tuned::kTouchingFacets * pair_.size())) {
    return;
  }
  constexpr double kExact = 1e-15;
  SpatialAnswer portal;
  spatial_growth(pair_, kExact, std::nan(""), record_.start, portal);
  const int iterations = record_.answer.iterations + portal.iterations;
  record_.start.count = portal.combination.count;
  for (int i = 0; i < record_.start.count; ++i) {
    record_.start.index_1[i] = portal.combination.point[i].index_1;
    record_.start.index_2[i] = portal.combination.point[i].index_2;
  }
  spatial_distance(pair_, tolerance, record_.start, {.at_rounding = true}, record_.answer);
  record_.answer.iterations += iterations;
}

// Whether the answer is final, after precise steps where it is not in doubles.
bool SpatialSolve::settle(double tolerance) {
  const Bounds& known = record_.answer.bounds;
  const bool enough = known.lower() > 0 && known.agree() && known.gap() <= enough_;
  if (record_.answer.end == SpatialEnd::open && enough) record_.answer.end = SpatialEnd::closed;
  if (record_.answer.end == SpatialEnd::open) precise_distance(pair_, tolerance, record_.answer);
  return record_.answer.end == SpatialEnd::closed || record_.answer.end == SpatialEnd::intersecting;
}

// Balls and capsules have formulas, which name where to go on in double-double arithmetic. Curved bodies that
// are near are left to Newton steps; the long way is for what these do not close.
bool SpatialSolve::find_distance(double tolerance, const PairStart* warm) {
  if (closed_form_distance(pair_, tolerance, record_.answer)) return true;
  if (record_.answer.combination.count > 0 && settle(tolerance)) return true;
  const bool newton = has_pieces(pair_);
  if (newton && go_on_from_pieces(pair_, tolerance, warm, record_.start, record_.answer) && settle(tolerance))
    return true;
  if (newton) {
    spatial_distance(pair_, tolerance, record_.start, {near_curved_, 0}, record_.answer);
    if (record_.answer.end == SpatialEnd::open) contact_distance(pair_, tolerance, record_.answer);
    if (settle(tolerance)) return true;
  }
  step_on_cores(tolerance);
  if (record_.answer.end == SpatialEnd::open && newton) contact_distance(pair_, tolerance, record_.answer);
  return settle(tolerance);
}

// For bodies that no other steps set apart.
bool SpatialSolve::find_overlap() {
  PrecisePair precise;
  if (record_.answer.bounds.lower() > 0 || !precise.bind(pair_)) return false;
  bool overlap = inner_ball(pair_, precise, {}, 0) > 0;
  if (!overlap && make_prism_of_flat(pair_, false)) overlap = inner_ball(pair_, precise, {}, 0) > 0;
  if (overlap) record_.answer.end = SpatialEnd::intersecting;
  return overlap;
}

// The normal of the lower bound, of length one, in the world.
inline void SpatialSolve::turn_normal() {
  const SpatialAnswer& answer = record_.answer;
  const double square = dot(answer.normal, answer.normal);
  const bool is_unit = std::fabs(square - 1) <= kUnitSquare;  // nearly always: no root to wait for
  const Vector3 normal = answer.normal * (is_unit ? -1.0 : -1 / std::sqrt(square));
  pair_.frame().normal_to_world(normal, answer.bounds.lower() < kClose * pair_.size(), record_.normal);
}

bool SpatialSolve::distance(double tolerance, PairStart* warm, bool* likely_overlap) {
  record_.begin();
  const bool has_vertices = begin_with_vertices(warm);
  if (!has_vertices) begin_with_normal(warm);
  if (likely_overlap != nullptr && has_vertices && has_quick_depth(pair_) &&
      is_beyond_plane(pair_, record_.start, *warm)) {
    *likely_overlap = true;
    return false;
  }
  if (!find_distance(tolerance, warm) && !find_overlap()) {
    if (record_.answer.bounds.lower() > 0) turn_normal();
    return false;
  }
  const bool apart = record_.answer.end == SpatialEnd::closed;
  if (warm != nullptr) record(warm);
  if (!apart) return true;
  turn_normal();
  if (warm != nullptr) std::copy_n(record_.normal, 3, warm->normal.begin());
  return true;
}

bool SpatialSolve::find_growth(bool about_origin, double tolerance, double threshold) {
  if (about_origin && !pair_.scale_first_about_origin(*first_)) return false;
  if (!about_origin && pair_.is_concentric()) {
    record_.answer.bounds.reduce_upper(0);  // a factor of 0
    record_.answer.end = SpatialEnd::closed;
    return true;
  }
  if (!about_origin && std::isnan(threshold) && is_smooth_needle(pair_, points())) {
    precise_growth(pair_, tolerance, record_.answer);
    if (record_.answer.end != SpatialEnd::open) return true;
  }
  spatial_growth(pair_, tolerance, threshold, record_.start, record_.answer);
  if (record_.answer.end == SpatialEnd::open && !about_origin) {
    precise_growth(pair_, tolerance, record_.answer);
  }
  if (record_.answer.end == SpatialEnd::open && !about_origin) go_on_in_ball(tolerance, threshold);
  return record_.answer.end != SpatialEnd::open;
}

// Where bodies know of no ball inside, or are flat, one that is looked for may be what is missing.
void SpatialSolve::go_on_in_ball(double tolerance, double threshold) {
  constexpr double kEnough = 1e-4;  // of the size
  PrecisePair precise;
  const bool flat = make_prism_of_flat(pair_, true);
  if ((!flat && pair_.inner_radius() > 0) || !precise.bind(pair_)) return;
  pair_.set_inner_radius(inner_ball(pair_, precise, -precise.between_centers(), kEnough * pair_.size()));
  if (pair_.inner_radius() > 0)
    spatial_growth(pair_, tolerance, threshold, flat ? SpatialStart() : record_.start, record_.answer);
}

bool SpatialSolve::growth(bool about_origin, double tolerance, double threshold, PairStart* warm,
                          bool fine_normal) {
  record_.begin();
  record_.start.fine_normal = fine_normal;
  const bool balls = is_point(pair_.shape(0)) && is_point(pair_.shape(1));  // the first direction is the last
  if (!balls && (!begin_with_vertices(warm) || record_.start.count != 3)) begin_with_normal(warm);
  if (!find_growth(about_origin, tolerance, threshold)) return false;
  if (warm == nullptr) return true;
  record(warm);
  if (record_.answer.bounds.lower() > 0)
    pair_.frame().normal_to_world(-record_.answer.normal, false, warm->normal.data());
  return true;
}

void SpatialSolve::growth_normal(double* normal) const {
  const double along = dot(record_.answer.normal, pair_.between_centers());
  pair_.frame().normal_to_world(record_.answer.normal * (-record_.answer.bounds.lower() / along), false,
                                normal);
}

}  // namespace raygauge
