// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/queries/part_solver.h"

#include <algorithm>
#include <limits>

namespace raygauge {
namespace {

constexpr double kOutward = 1 + 1e-13;
constexpr double kFirstTolerance = 1e-6;
constexpr double kNoThreshold = std::numeric_limits<double>::quiet_NaN();

DistanceOptions mesh_options(double tolerance) {
  DistanceOptions options;
  options.tolerance = tolerance;
  return options;
}

DistanceOptions newton_options(double tolerance) {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  options.tolerance = tolerance;
  return options;
}

void copy(const double* numbers, int n, SmallVector& v) {
  v.resize(n);
  if (n == 3) {
    Eigen::Vector3d::Map(v.data()) = Eigen::Vector3d::Map(numbers);
  } else {
    v = SmallVector::Map(numbers, n);
  }
}

void say_overlap(PairAnswer& answer) {
  answer.upper = 0;
  answer.status = DistanceStatus::contains_origin;
}

}  // namespace

PartSolver::PartSolver()
    : tolerance_(kFirstTolerance),
      distance_(newton_options(kFirstTolerance)),
      separation_(newton_options(kFirstTolerance)),
      growth_(newton_options(kFirstTolerance)),
      meshes_(mesh_options(kFirstTolerance)) {}

void PartSolver::set_tolerance(double tolerance) {
  if (tolerance == tolerance_) return;
  tolerance_ = tolerance;
  distance_ = ObjectDistanceSolver(newton_options(tolerance));
  growth_ = GrowthDistanceSolver(newton_options(tolerance));
  meshes_ = MeshDistanceSolver(mesh_options(tolerance));
  last_is_mesh_ = false;
}

// The solve by fixed-size code about two parts where they stand; nullptr where there is none.
SpatialSolve* PartSolver::fixed_solve(const PlacedPair& pair, PartNumbers parts) {
  const ConvexSet &first = pair.a().set(parts.a), &second = pair.b().set(parts.b);
  if (first_ != &first || second_ != &second) {
    first_ = &first;
    second_ = &second;
    bound_ = fixed_.bind(first, second, InstructionSet::automatic);
  }
  return bound_ && fixed_.place(pair.a().numbers(), pair.b().numbers()) ? &fixed_ : nullptr;
}

// Parts that overlapped before are asked first whether they still do: a growth distance, stopped at 1, proves
// it for a small part of what it costs a distance of smooth sets to end at 0.
bool PartSolver::still_overlap(PlacedPair& pair, PartNumbers parts, PartMemory& memory,
                               SceneCounters& counters) {
  if (!memory.overlapped) return false;
  const SeparationResult& found =
      separation_.separation(pair.a().posed(parts.a), pair.b().posed(parts.b), &memory.growth);
  counters.support_queries += found.counters.support_queries;
  return found.outcome == Separation::intersecting;
}

bool PartSolver::distance_by_fixed_code(const PlacedPair& pair, PartNumbers parts, bool closest_points,
                                        PartMemory& memory, PairAnswer& answer, SceneCounters& counters) {
  if (!pair.euclidean()) return false;
  SpatialSolve* solve = fixed_solve(pair, parts);
  if (solve == nullptr || !solve->distance(tolerance_, &memory.distance)) return false;
  counters.support_queries += solve->pair().queries();
  const SpatialAnswer& found = solve->answer();
  memory.overlapped = found.end == SpatialEnd::intersecting;
  if (memory.overlapped) {
    say_overlap(answer);
    return true;
  }
  const int n = pair.dimension();
  answer.lower = found.bounds.lower();
  answer.value = answer.upper = found.bounds.upper();
  copy(solve->normal(), n, answer.normal);
  copy(solve->normal(), n, memory.normal);
  answer.rate = kOutward;
  if (!closest_points) return true;
  answer.point_a.resize(n);
  answer.point_b.resize(n);
  solve->closest_points(answer.point_a.data(), answer.point_b.data());
  ++counters.closest_points;
  return true;
}

void PartSolver::distance(PlacedPair& pair, PartNumbers parts, bool closest_points, PartMemory& memory,
                          PairAnswer& answer, SceneCounters& counters) {
  ++counters.distance_solves;
  last_is_mesh_ = pair.is_mesh(parts);
  if (last_is_mesh_) return mesh_distance(pair, parts, closest_points, memory, answer, counters);
  if (still_overlap(pair, parts, memory, counters)) return say_overlap(answer);
  if (distance_by_fixed_code(pair, parts, closest_points, memory, answer, counters)) return;
  solve(pair, parts, closest_points ? ObjectEffects::closest_points : ObjectEffects::none, memory, answer,
        counters);
}

// The normal is that of the nearest triangles: no plane across it need lie between the parts, and none is
// kept. The distance falls by no more than the parts move, in whatever direction.
void PartSolver::mesh_distance(PlacedPair& pair, PartNumbers parts, bool closest_points, PartMemory& memory,
                               PairAnswer& answer, SceneCounters& counters) {
  const auto effects = closest_points ? ObjectEffects::closest_points : ObjectEffects::none;
  const ObjectDistance& found =
      meshes_.solve(pair.a().posed(parts.a), pair.b().posed(parts.b), effects, &memory.mesh);
  const DistanceResult& distance = found.distance;
  counters.closest_points += found.closest_point_evaluations;
  counters.support_queries += distance.counters.support_queries;
  answer.lower = distance.lower;
  answer.value = answer.upper = distance.upper;
  answer.status = distance.status;
  answer.rate = kOutward;
  answer.point_a = found.closest_point_1;
  answer.point_b = found.closest_point_2;
  answer.normal = distance.normal;
}

// By the general solver.
const ObjectDistance& PartSolver::solve(PlacedPair& pair, PartNumbers parts, ObjectEffects effects,
                                        PartMemory& memory, PairAnswer& answer, SceneCounters& counters) {
  const ObjectDistance& found = distance_.solve(pair.a().posed(parts.a), pair.b().posed(parts.b),
                                                pair.unit_ball(), effects, &memory.distance);
  const DistanceResult& distance = found.distance;
  counters.closest_points += found.closest_point_evaluations;
  counters.support_queries += distance.counters.support_queries;
  memory.overlapped = distance.status == DistanceStatus::contains_origin;
  answer.lower = distance.lower;
  answer.upper = distance.upper;
  answer.value = distance.distance;
  answer.status = distance.status;
  answer.point_a = found.closest_point_1;
  answer.point_b = found.closest_point_2;
  if (!(distance.lower > 0)) return found;
  answer.rate = distance.normal.norm() * kOutward;
  answer.normal = distance.normal;
  if (distance.normal.size() == pair.dimension()) memory.normal = distance.normal;
  return found;
}

void PartSolver::signed_distance(PlacedPair& pair, PartNumbers parts, PartMemory& memory, PairAnswer& answer,
                                 SceneCounters& counters) {
  ++counters.distance_solves;
  const ObjectDistance& found =
      solve(pair, parts, ObjectEffects::closest_points | ObjectEffects::gradient | ObjectEffects::depth,
            memory, answer, counters);
  counters.gradients += found.gradient_evaluations;
  answer.gradient = found.gradient_1;
  const ObjectDepth& depth = found.depth;
  if (depth.evaluations == 0) return;
  ++counters.depths;
  counters.support_queries += depth.support_queries;
  answer.depth_lower = depth.lower;
  answer.depth_upper = depth.upper;
  answer.point_a = depth.point_1;
  answer.point_b = depth.point_2;
}

Separation PartSolver::separation(PlacedPair& pair, PartNumbers parts, PartMemory& memory,
                                  SceneCounters& counters) {
  ++counters.separation_solves;
  if (pair.is_mesh(parts)) {
    last_is_mesh_ = false;  // no distance
    const Separation known =
        meshes_.separation(pair.a().posed(parts.a), pair.b().posed(parts.b), &memory.mesh);
    counters.support_queries += meshes_.counters().precise_pairs;
    return known;
  }
  const SeparationResult& found =
      separation_.separation(pair.a().posed(parts.a), pair.b().posed(parts.b), &memory.growth);
  counters.support_queries += found.counters.support_queries;
  if (found.outcome == Separation::separated) memory.normal = found.normal;
  return found.outcome;
}

void PartSolver::growth(PlacedPair& pair, PartNumbers parts, PartMemory& memory, PairAnswer& answer,
                        SceneCounters& counters) {
  ++counters.growth_solves;
  SpatialSolve* solve = fixed_solve(pair, parts);
  if (solve != nullptr && solve->growth(false, tolerance_, kNoThreshold, &memory.growth)) {
    counters.support_queries += solve->pair().queries();
    answer.lower = solve->answer().bounds.lower();
    answer.upper = solve->answer().bounds.upper();
    answer.value = std::min(answer.upper, std::numeric_limits<double>::max());
    if (answer.upper == 0) answer.status = DistanceStatus::contains_origin;
    return;
  }
  const DistanceResult& found =
      growth_.solve_about_centers(pair.a().posed(parts.a), pair.b().posed(parts.b), &memory.growth);
  counters.support_queries += found.counters.support_queries;
  answer.lower = found.lower;
  answer.upper = found.upper;
  answer.value = found.distance;
  answer.status = found.status;
}

}  // namespace raygauge
