// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// The rungs of a Ladder that are none of the general methods, but for the first two.
#include <algorithm>
#include <limits>

#include "engine/numerics/floating_point.h"
#include "engine/queries/ladder.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

// The answer where two objects share a point; the counters stay.
void set_overlap(DistanceResult& result) {
  result.status = DistanceStatus::contains_origin;
  result.distance = result.lower = result.upper = 0;
  result.normal.resize(0);
  result.contact_point.resize(0);
}

// The normal is the gradient: solvers copy it.
ObjectEffects without_gradient(ObjectEffects effects) {
  return static_cast<ObjectEffects>(static_cast<unsigned>(effects) &
                                    ~static_cast<unsigned>(ObjectEffects::gradient));
}

// The Euclidean distance, in the metric of a ball of this radius.
void scale_to_radius(double radius, DistanceResult& result) {
  constexpr double kUp = 1 + 0x1p-50, kDown = 1 - 0x1p-50;
  if (radius == 1) return;
  result.lower = std::min(result.lower / radius * kDown, std::numeric_limits<double>::max());
  result.upper = result.upper / radius * kUp;
  result.distance = result.upper;
  result.normal /= radius;
}

}  // namespace

MeshDistanceSolver& Ladder::mesh_solver() {
  if (meshes_ == nullptr) {
    DistanceOptions options = options_;
    options.method = DistanceMethod::automatic;
    meshes_ = std::make_unique<MeshDistanceSolver>(options);
    meshes_->set_stop([this] { return stop_ && stop_(); });
  }
  return *meshes_;
}

// The trees' search. A warm start keeps the nearest triangles, and no normal: none holds for the whole mesh.
bool Ladder::Solve::mesh(Ladder& ladder, Ask& ask) {
  if (ask.question == Question::growth)
    throw InvalidParameterError("the growth distance of a mesh is not defined: ask for it of convex parts");
  MeshWarmStart triangles;
  if (ask.warm != nullptr && ask.warm->dimension == 3 && ask.warm->count == 1)
    triangles = {ask.warm->point_A[0], ask.warm->point_Q[0]};
  MeshDistanceSolver& solver = ladder.mesh_solver();
  ObjectDistance& answer = ladder.answer_;
  if (ask.question == Question::separation) {
    const Separation known = solver.separation(ask.first, ask.second, &triangles);
    answer.distance.counters = {};
    answer.distance.counters.support_queries = solver.counters().precise_pairs;
    ladder.conclude(known, Bounds());
    ladder.separation_.normal.resize(0);
  } else {
    const double radius = radius_of_ball(*ask.metric);
    if (!(radius > 0) || ask.metric->dimension() != 3)
      throw InvalidParameterError("a mesh has Euclidean distances: the metric must be a ball of R^3 about 0");
    const ObjectDistance& found =
        solver.solve(ask.first, ask.second, without_gradient(ask.object_effects), &triangles);
    answer.distance = found.distance;
    answer.closest_point_1 = found.closest_point_1;
    answer.closest_point_2 = found.closest_point_2;
    answer.closest_point_evaluations = found.closest_point_evaluations;
    answer.gradient_evaluations = 0;
    scale_to_radius(radius, answer.distance);
  }
  if (ask.warm == nullptr) return true;
  ask.warm->dimension = 3;
  ask.warm->normal = {};
  ask.warm->count = 1;
  ask.warm->point_A = {triangles.triangle_1};
  ask.warm->point_Q = {triangles.triangle_2};
  return true;
}

// Closed forms, for any metric.
bool Ladder::Solve::half_space(Ladder& ladder, Ask& ask) {
  HalfSpaceQuery& query = ladder.half_space_;
  if (ask.question == Question::growth) {
    throw InvalidParameterError(
        "growth distance: a half-space has no centre to be scaled about; ask for its distance or depth");
  }
  query.bind(ask.first, ask.second);
  if (ask.question == Question::distance) {
    query.distance(*ask.metric, ladder.options_, ask.object_effects, ladder.answer_);
    return true;
  }
  const Separation known = query.separation(ladder.options_);
  ladder.answer_.distance.counters = {};
  ladder.answer_.distance.counters.support_queries = query.support_queries();
  ladder.conclude(known, Bounds());
  if (known == Separation::separated) ladder.separation_.normal = query.direction();
  return true;
}

// Objects that share a point meet without growing.
bool Ladder::Solve::common_point(Ladder& ladder, Ask& ask) {
  const Separation known = ladder.bodies_.separation(ask.first, ask.second, ladder.options_);
  ask.is_distance_open = ladder.bodies_.was_asked();
  if (ask.question == Question::growth) {
    if (known == Separation::intersecting) ask.proven.bounds.reduce_upper(1);
    return false;
  }
  if (known == Separation::undecided) return false;
  DistanceResult& growth = ladder.answer_.distance;
  if (!ask.is_known) growth.counters = {};
  ladder.conclude(known, ask.is_known ? Bounds(growth.lower, growth.upper) : ask.proven.bounds);
  if (known == Separation::separated) ladder.separation_.normal = ladder.bodies_.normal();
  return true;
}

// A depth above 0 proves that there is no distance, and takes less time than the general methods.
bool Ladder::Solve::depth(Ladder& ladder, Ask& ask) {
  ObjectDistance& answer = ladder.answer_;
  answer.distance.seconds = DistanceResult::kUnset;
  ladder.find_depth(ask);
  ladder.depth_start_.overlap = false;
  if (!(answer.depth.lower > 0)) return false;
  set_overlap(answer.distance);
  answer.distance.sigma = DistanceResult::kUnset;
  answer.distance.counters = {};
  answer.distance.origin_weights.clear();
  answer.closest_point_evaluations = answer.gradient_evaluations = 0;
  answer.closest_point_1.resize(0);
  answer.closest_point_2.resize(0);
  return true;
}

// Whether two bodies share a point, or one holds the origin, is a question without a metric.
bool Ladder::Solve::overlap(Ladder& ladder, Ask& ask) {
  DistanceOptions options = ladder.options_;
  options.method = DistanceMethod::automatic;
  options.max_iterations = 0;
  DistanceResult& result = ladder.answer_.distance;
  const int n = ask.first.dimension();
  const Ball origin(Vector::Zero(n), 0.0);
  const auto [S, T] = NearestPoint::difference(ask.first.set);
  const bool gauge = ask.question == Question::gauge, difference = gauge && T != nullptr;
  if (difference && ask.first.pose != nullptr) return false;
  const Separation known = difference ? ladder.bodies_.separation(Posed(*T), Posed(*S), options)
                           : gauge    ? ladder.bodies_.separation(Posed(origin), ask.first, options)
                                      : ladder.bodies_.separation(ask.first, ask.second, options);
  if (!ladder.bodies_.was_asked()) return false;
  result.counters.support_queries += ladder.bodies_.support_queries();
  result.seconds = ladder.stopwatch_.seconds();
  if (known != Separation::intersecting) return false;
  set_overlap(result);
  if (double* contact = result.room_for_contact(ask.effects, n)) {
    std::fill_n(contact, n, 0.0);
    ++result.counters.witness_evaluations;
  }
  return true;
}

// Objects that meet when each is scaled by less than 1 share a point, whatever the metric.
bool Ladder::Solve::growth_into(Ladder& ladder, Ask& ask) {
  Ask other(Question::growth, ask.first, ask.second, nullptr);
  other.threshold = 1;
  other.time_limit = ladder.time_left();
  std::swap(ladder.answer_.distance, ladder.outer_);
  ladder.growth(other);
  std::swap(ladder.answer_.distance, ladder.outer_);
  if (!(ladder.outer_.upper < 1)) return false;
  set_overlap(ladder.answer_.distance);
  return true;
}

bool Ladder::Solve::distance(Ladder& ladder, Ask& ask) {
  const int n = ask.first.dimension();
  std::unique_ptr<const Ball>& ball = ladder.ball_;
  if (!ball || ball->dimension() != n) ball = std::make_unique<const Ball>(Vector::Zero(n), 1.0);
  Ask other(Question::distance, ask.first, ask.second, nullptr);
  other.metric = ball.get();
  other.is_distance_open = ask.is_distance_open;
  other.is_growth_open = true;
  other.time_limit = ladder.time_left();
  std::swap(ladder.answer_.distance, ladder.outer_);
  ladder.distance(other);
  std::swap(ladder.answer_.distance, ladder.outer_);
  const DistanceResult &growth = ladder.answer_.distance, &found = ladder.outer_;
  const bool meet = found.status == DistanceStatus::contains_origin;
  if (!meet && !(found.lower > 0)) return false;
  ladder.conclude(meet ? Separation::intersecting : Separation::separated, {growth.lower, growth.upper});
  if (!meet) ladder.separation_.normal = found.normal;
  return true;
}

double Ladder::time_left() const {
  const double limit = options_.time_limit;
  return limit < kInfinity ? limit - answer_.distance.seconds : limit;
}

void Ladder::find_pose_gradient(const Ask& ask) {
  PoseGradient& gradient = answer_.pose_gradient;
  const SpatialPair* pair = known_pair(ask);
  const bool by_ball = pair != nullptr || radius_of_ball(*ask.metric) > 0;
  const SpatialCombination* end =
      pair != nullptr && answer_.depth.evaluations == 0 ? &bodies_.combination() : nullptr;
  pose_gradients_.begin(ask.first, ask.second, pair, end, options_.instruction_set);
  const bool by_half_space = pair == nullptr && (as_half_space(ask.first.set) != nullptr ||
                                                 as_half_space(ask.second.set) != nullptr);
  if (by_ball && answer_.depth.evaluations > 0 && !by_half_space)
    depth_.other_normals(answer_.depth, pose_gradients_.other_normals());
  pose_gradients_.of_distance(answer_, by_ball, gradient);
  if (gradient.kind != GradientKind::none) ++answer_.pose_gradient_evaluations;
}

// Curved bodies have normals that are off by the root of the gap, which may hide what is in contact: then
// they are asked for a finer one.
void Ladder::find_growth_gradient(const Ask& ask) {
  constexpr double kFine = 1e-12;
  const DistanceResult& growth = answer_.distance;
  PoseGradient& gradient = *ask.pose_gradient;
  const SpatialPair* pair = known_pair(ask);
  const SpatialCombination* end = pair != nullptr && ask.is_known ? &bodies_.combination() : nullptr;
  pose_gradients_.begin(ask.first, ask.second, pair, end, options_.instruction_set);
  pose_gradients_.of_growth(growth, ask.about_origin, gradient);
  const bool is_known = gradient.kind == GradientKind::unique || gradient.kind == GradientKind::one_sided;
  if (is_known || end == nullptr || !(growth.lower > 0)) return;
  if (growth.upper - growth.lower <= kFine * growth.upper) return;
  DistanceOptions options = options_;
  options.tolerance = kFine;
  if (!bodies_.growth(ask.second, ask.first, ask.about_origin, options, ask.threshold, nullptr, outer_,
                      true)) {
    const ProvenBounds& proven = bodies_.proven();
    outer_.lower = proven.bounds.lower();
    outer_.upper = outer_.distance = proven.bounds.upper();
    outer_.normal = Vector::Map(proven.normal, ask.first.dimension());
  }
  pose_gradients_.of_growth(outer_, ask.about_origin, gradient);
  if (gradient.kind == GradientKind::none) pose_gradients_.of_growth(growth, ask.about_origin, gradient);
}

// The distance of bodies that meet has recorded the vertices that it ended at.
void Ladder::find_depth(const Ask& ask) {
  DepthStart start;
  if (has_depth_start_) {
    depth_start_.count = ask.warm->count;
    depth_start_.point_A = ask.warm->point_A;
    depth_start_.point_Q = ask.warm->point_Q;
    start = {&depth_start_, &ask.warm->polytope};
  }
  start.is_kept = ask.warm != nullptr;
  start.is_guess = guesses_overlap_;
  depth_.solve(ask.first, ask.second, *ask.metric, options_, stop_, start, answer_.distance.seconds,
               answer_.depth);
  if (ask.warm != nullptr && answer_.depth.evaluations > 0) depth_.record(answer_.depth, *ask.warm);
}

}  // namespace raygauge
