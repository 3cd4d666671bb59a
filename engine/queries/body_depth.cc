// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/body_depth.h"

#include <algorithm>
#include <cmath>

#include "engine/kernels/kernel.h"
#include "engine/methods/bodies/tuning.h"
#include "engine/methods/spatial/active_pieces.h"
#include "engine/methods/spatial/gjk.h"

namespace raygauge {
namespace {

constexpr double kUp = 1 + 0x1p-52;
constexpr double kExact = 1e-14;  // the finest tolerance that distances are asked for

// Without the ball that is added: of a capsule the segment, of a ball its centre. A ball inside core + r B is
// one of radius r larger than one inside the core: for closed convex sets summands may be cancelled.
SpatialShape core_of(const SpatialShape& shape) {
  SpatialShape core = shape;
  core.inner_radius = std::max(0.0, shape.inner_radius - shape.radius * (1 + 0x1p-50));
  core.radius = 0;
  return core;
}

bool has_frustum(const SpatialPair& pair) { return has_discs(pair.shape(0)) || has_discs(pair.shape(1)); }

// The point of the difference of the cores that is nearest to the origin, in double-double arithmetic, by the
// algorithm of Gilbert, Johnson & Keerthi from what the distance in doubles found: of a centre and a core
// with a formula its projection, else the support point for the normal, and the vertices and curves that it
// is on.
PreciseVector3 nearest_of_cores(const SpatialPair& pair, const SpatialSolve& cores, PrecisePair& precise) {
  constexpr int kMostSteps = 16, kProjections = 3;
  const SpatialCombination& found = cores.answer().combination;
  const double* n = cores.normal();
  const PreciseVector3 normal = -raygauge::precise({n[0], n[1], pair.dimension() == 3 ? n[2] : 0.0});
  ActivePieces<PrecisePair> simplex;
  DoubleDouble height;
  simplex.point[0] = precise.support(normal, height);
  simplex.count = 1;
  if (found.count > 0) {
    PrecisePoint projected;
    projected.a1 = raygauge::precise(found.point[0].a1);
    projected.a2 = raygauge::precise(pair.frame().to_second(found.point[0].a2));
    for (int i = 0; i < kProjections && precise.project(projected); ++i) simplex.point[0] = projected;
  }
  for (int i = 0; i < std::min(found.count, 3); ++i) {
    PrecisePoint& piece = simplex.point[simplex.count];
    piece.index_1 = found.point[i].index_1;
    piece.index_2 = found.point[i].index_2;
    if (precise.follow(normal, piece)) ++simplex.count;
  }
  PreciseVector3 v;
  for (int step = 0; step < kMostSteps; ++step) {
    const SimplexFace<DoubleDouble> face = nearest_face_of(simplex);
    keep(face, simplex);
    v = combine(simplex, face);
    const double away = length(rounded(v));
    if (simplex.count == 4 || !(away > 0)) break;
    const PrecisePoint w = precise.support(v * DoubleDouble{-1 / away}, height);
    if (!((height + away).high > precise.error())) break;
    simplex.point[simplex.count++] = w;
  }
  return v;
}

}  // namespace

bool BodyDepth::bind(const ConvexSet& first, const ConvexSet& second, InstructionSet isa) {
  isa_ = isa;
  if (!pair_.bind(first, second, isa)) return false;
  for (int i = 0; i < 2; ++i) {
    radius_[i] = pair_.shape(i).radius;
    extent_[i] = pair_.shape(i).extent;
  }
  if (!has_balls()) return true;
  const SpatialShape* core[] = {&pair_.shape(0), &pair_.shape(1)};
  for (int i = 0; i < 2; ++i) {
    if (radius_[i] > 0) core[i] = &(core_[i] = core_of(*core[i]));
  }
  pair_.bind(*core[0], *core[1], pair_.dimension(), isa);
  cores_.bind(*core[0], *core[1], pair_.dimension(), isa);
  cores_.expect_overlap();
  return true;
}

// A ball in a pose is turned by an R whose RᵀR is 1 but for the defect.
bool BodyDepth::place(const PoseNumbers& first, const PoseNumbers& second) {
  ball_lower_ = ball_upper_ = {};
  const double defect[2] = {first.defect, second.defect};
  for (int i = 0; i < 2 && has_balls(); ++i) {
    const DoubleDouble change = two_product(radius_[i], defect[i]);
    ball_lower_ = ball_lower_ + radius_[i] - change;
    ball_upper_ = ball_upper_ + radius_[i] + change;
  }
  tiny_ = 0;
  return pair_.place(first, second) || is_tiny(first, second);
}

// Balls about the same point, whose cores are out of the range of squares.
bool BodyDepth::is_tiny(const PoseNumbers& first, const PoseNumbers& second) {
  constexpr double kTiny = 1e-60, kSmallest = 0x1p-1000;
  double size = extent_[0] + extent_[1] + kSmallest;
  for (int k = 0; k < pair_.dimension(); ++k)
    size += std::fabs((first.t != nullptr ? first.t[k] : 0.0) - (second.t != nullptr ? second.t[k] : 0.0));
  tiny_ = size * (1 + 0x1p-40);
  return tiny_ < kTiny * ball_lower_.high;
}

void BodyDepth::bound_tiny(double tolerance, BodyDepthAnswer& answer) const {
  answer.bounds = {down(ball_lower_ + -tiny_), up(ball_upper_ + tiny_)};
  answer.status = answer.bounds.close(tolerance) ? DistanceStatus::optimal : DistanceStatus::precision_limit;
  answer.normal = {-1, 0, 0};
  put_points({1, 0, 0}, {}, {}, answer);
}

void BodyDepth::put_points(const Vector3& normal, const Vector3& a1, const Vector3& a2,
                           BodyDepthAnswer& answer) const {
  pair_.frame().point_to_world(a1 + normal * radius_[0], &answer.point_1.x);
  pair_.frame().point_to_world(a2 - normal * radius_[1], &answer.point_2.x);
}

// By what the cores' distance has just found; the normal and the points are those that prove the better
// bounds.
void BodyDepth::bound_apart(BodyDepthAnswer& answer) {
  const SpatialAnswer& apart = cores_.answer();
  const bool is_first = !has_points_,
             nearer = answer.bounds.raise_lower(down(ball_lower_ + -apart.bounds.upper()));
  const bool lower = answer.bounds.reduce_upper(std::max(0.0, up(ball_upper_ + -apart.bounds.lower())));
  if (is_first || lower) {
    const double* n = cores_.normal();
    answer.normal = {n[0], n[1], pair_.dimension() == 3 ? n[2] : 0.0};
  }
  if (!is_first && !nearer) return;
  has_points_ = true;
  double a1[3] = {0, 0, 0}, a2[3] = {0, 0, 0};
  cores_.closest_points(a1, a2);
  answer.point_1 = {a1[0], a1[1], a1[2]};
  answer.point_2 = {a2[0], a2[1], a2[2]};
}

// What both balls add to h(u): Σ r |Rᵀu|.
DoubleDouble BodyDepth::ball_height(const PreciseVector3& u) const {
  const int n = pair_.dimension();
  DoubleDouble sum;
  for (int i = 0; i < 2; ++i) {
    const double* R = pair_.pose(i).R;
    PreciseVector3 v = u;
    const auto column = [&](int k) {
      const double* r = R + std::ptrdiff_t{k} * n;
      return dot(u, Vector3{r[0], r[1], n == 3 ? r[2] : 0.0});
    };
    if (R != nullptr) v = {column(0), column(1), n == 3 ? column(2) : DoubleDouble{}};
    sum = sum + sqrt(dot(v, v)) * radius_[i];
  }
  return sum;
}

// Distances are rounded to doubles, which is too coarse where the depth is a small part of them. With the
// normal of the distance, and the pieces of the bodies that it came from, the difference is taken in
// double-double arithmetic. A point v of the difference of the cores proves a lower bound: with w = -v/|v|
// and g(u) what the balls add,  h(u) >= u·v + g(u).  At an angle θ from w the first term is at least -|v| +
// |v| θ²/5, and as RRᵀ is 1 to δ, the second is at least g(w) - 1.01 θ Σ r δ: together no less than g(w) -
// |v| - 1.3 (Σ r δ)²/|v|.
void BodyDepth::refine_apart(BodyDepthAnswer& answer) {
  PrecisePair precise;
  if (!precise.bind(pair_)) return;
  const PreciseVector3 v = nearest_of_cores(pair_, cores_, precise);
  answer.support_queries += precise.queries();
  const DoubleDouble away = sqrt(dot(v, v));
  const double error = 2 * precise.error();
  if (!(away.high > 0)) return;
  const PreciseVector3 u = v * (DoubleDouble{-1} / away);
  const DoubleDouble balls = ball_height(u) / sqrt(dot(u, u));
  const double turned = radius_[0] * pair_.pose(0).defect + radius_[1] * pair_.pose(1).defect;
  answer.bounds.raise_lower(down(balls - away) - error - 1.31 * turned * turned / away.high);
  const DoubleDouble height = balls + precise.height(u) / sqrt(dot(u, u));
  if (answer.bounds.reduce_upper(std::max(0.0, up(height) + error))) answer.normal = -rounded(u);
}

// h(u) of the cores plus what the balls add is below 0 for the direction of before.
bool BodyDepth::has_parted(const PairStart& start, BodyDepthAnswer& answer) {
  const double* normal = recorded_normal(start, pair_.dimension());
  if (normal == nullptr) return false;
  const Vector3 u = -pair_.frame().to_body(normal);
  SpatialPoint point;
  pair_.support(u, point);
  const double height = dot(u, point.s), size = length(u) * (1 + 0x1p-50);
  answer.parted = height + (pair_.error() + up(ball_upper_)) * size * (1 + 0x1p-50) < 0;
  return answer.parted;
}

// Balls that meet about cores that do not. True where it is all: the cores are apart for certain.
bool BodyDepth::solve_apart(double tolerance, const PairStart* start, BodyDepthAnswer& answer) {
  if (!cores_.place(pair_.pose(0), pair_.pose(1))) return false;
  const auto is_close = [&] { return answer.bounds.close(tolerance, enough_); };
  double asked = tolerance;
  nearest_.clear();
  if (start != nullptr) nearest_ = *start;
  for (int attempt = 0; attempt < 2; ++attempt) {
    const bool known = cores_.distance(asked, &nearest_);
    answer.support_queries += cores_.pair().queries();
    answer.iterations += cores_.answer().iterations;
    if (attempt == 0 && (!known || cores_.answer().end != SpatialEnd::closed)) return false;
    if (!known || cores_.answer().end != SpatialEnd::closed) break;
    bound_apart(answer);
    if (is_close()) break;
    asked = std::max(
        kExact, tuned::kShareOfCores * tolerance * answer.bounds.upper() / cores_.answer().bounds.upper());
  }
  if (!is_close()) refine_apart(answer);
  normal_ = -pair_.frame().to_body(&answer.normal.x);
  answer.point_1 = answer.point_1 - answer.normal * radius_[0];
  answer.point_2 = answer.point_2 + answer.normal * radius_[1];
  answer.status = is_close() ? DistanceStatus::optimal : DistanceStatus::precision_limit;
  answer.support_queries += pair_.queries();
  return true;
}

// `world`: the search was in the frame of the world.
template <class Real>
void BodyDepth::take(DepthSearch<Real>& search, bool world, BodyDepthAnswer& answer) {
  answer.iterations += search.iterations();
  answer.bounds.raise_lower(down(ball_lower_ + std::max(search.lower(), floor_)));
  if (!answer.bounds.reduce_upper(up(ball_upper_ + search.upper()))) return;
  Vector3 n = rounded(search.normal()), a1, a2;
  if (pair_.dimension() == 2) n.z = 0;
  n = n * (1 / length(n));
  normal_ = world ? pair_.frame().to_body(&n.x) : n;
  has_points_ = search.lower() > 0 && search.contact(n, a1, a2);
  if (has_points_) put_points(normal_, a1, a2, answer);
}

// A pair of points of the cores that are near each other, or any: of the simplex near the origin that their
// distance ends with.
void BodyDepth::find_near_points(BodyDepthAnswer& answer, Vector3& a1, Vector3& a2) {
  SpatialAnswer apart;
  spatial_distance(pair_, kExact, {}, {}, apart);
  answer.support_queries += pair_.queries();
  const SpatialCombination& found = apart.combination;
  a1 = a2 = {};
  double sum = 0;
  for (int i = 0; i < found.count; ++i) {
    a1 = a1 + found.point[i].a1 * found.weight[i];
    a2 = a2 + found.point[i].a2 * found.weight[i];
    sum += found.weight[i];
  }
  if (std::fabs(sum - 1) < 0x1p-45) {
    a1 = a1 * (1 / sum);
    a2 = a2 * (1 / sum);
    return;
  }
  SpatialPoint point;
  pair_.support({1, 0, 0}, point);
  a1 = point.a1;
  a2 = point.a2;
}

void BodyDepth::record(WarmStart& warm) {
  warm.count = 0;
  if (source_ == Source::none && has_balls()) {
    warm.count = nearest_.count;
    warm.point_A = nearest_.point_A;
    warm.point_Q = nearest_.point_Q;
  }
  if (source_ != Source::quick || !has_points_) return;
  const auto corner_of = [this](const DepthPoint<double>& point) {
    return pair_.corner_of(point.u, {point.s, point.a1, point.a2, point.index_1, point.index_2});
  };
  quick_.record(corner_of, warm.polytope);
}

// Whether that is all. A polytope about the origin proves that the cores meet.
bool BodyDepth::search_again(double tolerance, const DepthMemory& memory, const Stopwatch& watch,
                             BodyDepthAnswer& answer) {
  SpatialOracle oracle(pair_);
  const bool closed = quick_.run_again(
      oracle, memory, {tolerance, 0, down(ball_lower_), up(ball_upper_), true, enough_}, watch);
  if (!closed) return false;
  source_ = Source::quick;
  take(quick_, false, answer);
  if (!answer.bounds.close(tolerance, enough_) || !has_points_) return false;
  answer.support_queries += pair_.queries();
  answer.status = DistanceStatus::optimal;
  pair_.frame().to_world(-normal_, &answer.normal.x);
  return true;
}

void BodyDepth::search(double tolerance, const PairStart* start, const Stopwatch& watch,
                       BodyDepthAnswer& answer) {
  const double* normal = start != nullptr ? recorded_normal(*start, pair_.dimension()) : nullptr;
  const Vector3 given = normal != nullptr ? -pair_.frame().to_body(normal) : pair_.between_centers();
  const Vector3 u = dot(given, given) > 0 ? given * (1 / length(given)) : Vector3{1, 0, 0};
  const double ball_lower = down(ball_lower_), ball_upper = up(ball_upper_);
  SpatialOracle oracle(pair_);
  source_ = Source::quick;
  DepthEnd end = quick_.run(oracle, u, {tolerance, floor_, ball_lower, ball_upper, true, enough_}, watch);
  take(quick_, false, answer);
  answer.support_queries += pair_.queries();
  PreciseOracle precise;
  if ((end == DepthEnd::rounding || end == DepthEnd::flat) && precise.bind(pair_)) {
    Vector3 world;
    pair_.frame().to_world(quick_.normal(), &world.x);
    if (pair_.dimension() == 2) world.z = quick_.normal().z;
    source_ = Source::precise;
    end = precise_.run(precise, raygauge::precise(world),
                       {tolerance, floor_, ball_lower, ball_upper, false, enough_}, watch);
    take(precise_, true, answer);
    answer.support_queries += precise.queries();
  }
  answer.status = answer.bounds.close(tolerance, enough_) ? DistanceStatus::optimal
                  : end == DepthEnd::closed               ? DistanceStatus::precision_limit
                                                          : status_of(end);
}

void BodyDepth::solve(double tolerance, const DepthStart& start, const Stopwatch& watch,
                      BodyDepthAnswer& answer) {
  answer = {};
  has_points_ = false;
  source_ = Source::none;
  floor_ = 0;
  if (tiny_ > 0) return bound_tiny(tolerance, answer);
  if (start.pair != nullptr && start.pair->overlap && has_parted(*start.pair, answer)) return;
  if (start.polytope != nullptr && !start.polytope->empty() &&
      search_again(tolerance, *start.polytope, watch, answer))
    return;
  const bool were_apart = has_balls() && start.pair != nullptr && start.pair->count > 0;  // most likely still
  if (were_apart && solve_apart(tolerance, start.pair, answer)) return;
  if (leave_boxes(tolerance, answer) || leave_hull(tolerance, answer)) return;
  if (start.is_guess) {
    answer.parted = true;
    return;
  }
  // It leaves no polytope to go on from, which takes half as long; but beside a frustum not so long.
  if ((!start.is_kept || has_frustum(pair_)) && leave_polytopes(tolerance, answer)) return;
  const bool may_be_apart = has_balls() && !meet_deep(pair_);
  if (may_be_apart && !were_apart && solve_apart(tolerance, start.pair, answer)) return;
  // Of a convex core without the origin, v apart from it, the depth is -|v|.
  Vector3 a1, a2;
  if (may_be_apart && cores_.answer().end != SpatialEnd::intersecting) {
    find_near_points(answer, a1, a2);
    floor_ = -(length(a1 - a2) * kUp + 2 * pair_.error());
  }
  search(tolerance, start.pair, watch, answer);
  if (!has_points_) {
    find_near_points(answer, a1, a2);
    put_points(normal_, a1, a2, answer);
  }
  pair_.frame().to_world(-normal_, &answer.normal.x);
}

// A search has outward normals of S1 - S2, in the frame of the first body or of the world.
void BodyDepth::add_near_normals(double relative, double angle, std::vector<Vector3>& normals) const {
  if (source_ == Source::none) return;
  const std::size_t first = normals.size();
  if (source_ == Source::hull) {
    add_near_planes(relative, angle, normals);
  } else if (source_ == Source::boxes) {
    add_near_facets(boxes_, relative, angle, normals);
  } else if (source_ == Source::polytopes) {
    add_near_facets(polytopes_, relative, angle, normals);
  } else if (source_ == Source::frustum) {
    add_near_facets(frustum_, relative, angle, normals);
  } else if (source_ == Source::quick) {
    quick_.add_near_normals(relative, angle, normals);
  } else {
    precise_.add_near_normals(relative, angle, normals);
  }
  for (std::size_t i = first; i < normals.size(); ++i) {
    Vector3 world = -normals[i];
    if (source_ != Source::precise) pair_.frame().to_world(-normals[i], &world.x);
    if (pair_.dimension() == 2) world.z = 0;
    normals[i] = world;
  }
}

}  // namespace raygauge
