// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/growth_distance.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/queries/growth_solve.h"
#include "engine/queries/spatial_query.h"
#include "engine/sets/object_pair.h"
#include "engine/sets/parameters.h"
#include "engine/sets/posed_view.h"
#include "raygauge/sets/ball.h"

namespace raygauge {
namespace {

constexpr double kNoThreshold = std::numeric_limits<double>::quiet_NaN();

}  // namespace

struct GrowthDistanceSolver::Workspace {
  explicit Workspace(const DistanceOptions& options) : methods(options) {}

  MethodChain methods;
  SpatialQuery spatial;
  GrowthSolve growth;
  DistanceResult result;
  SeparationResult separation;
  std::unique_ptr<const Ball> ball;  // of the Euclidean distance, where the general methods were asked for it

  const DistanceResult& solve_about(const Posed& A, const Posed& Q, bool about_origin, WarmStart* warm);
  void go_on(const Posed& A, const Posed& Q, bool about_origin, double threshold, const ProvenBounds& proven,
             WarmStart* warm);
  void separate(const Posed& A1, const Posed& A2, WarmStart* warm);
  [[gnu::always_inline]] bool conclude();
  void conclude_by_methods(const Posed& A1, const Posed& A2);
  void conclude(Separation outcome, const Vector& normal);
};

// A is scaled about its centre, Q about the origin or its own. By fixed-size code where that has the answer.
const DistanceResult& GrowthDistanceSolver::Workspace::solve_about(const Posed& A, const Posed& Q,
                                                                   bool about_origin, WarmStart* warm) {
  const DistanceOptions& options = methods.options();
  if (spatial.growth(A, Q, about_origin, options, kNoThreshold, warm, result)) return result;
  ProvenBounds proven = spatial.proven();
  // Objects that share a point meet without growing.
  if (!about_origin && spatial.separation(Q, A, options) == Separation::intersecting)
    proven.upper = std::min(proven.upper, 1.0);
  go_on(A, Q, about_origin, kNoThreshold, proven, warm);
  return result;
}

// The general methods, from what fixed-size code has proven.
void GrowthDistanceSolver::Workspace::go_on(const Posed& A, const Posed& Q, bool about_origin,
                                            double threshold, const ProvenBounds& proven, WarmStart* warm) {
  Aim aim;
  aim.threshold = threshold;
  result = growth.solve(A, Q, about_origin, aim, warm, methods);
  tighten(proven, A.dimension(), methods.options().tolerance, result);
}

// By the bounds on the growth distance.
inline bool GrowthDistanceSolver::Workspace::conclude() {
  separation.lower = result.lower;
  separation.upper = result.upper;
  separation.counters = result.counters;
  separation.outcome = result.lower > 1   ? Separation::separated
                       : result.upper < 1 ? Separation::intersecting
                                          : Separation::undecided;
  if (separation.outcome == Separation::separated) {
    separation.normal = result.normal;
  } else {
    separation.normal.resize(0);
  }
  return separation.outcome != Separation::undecided;
}

void GrowthDistanceSolver::Workspace::separate(const Posed& A1, const Posed& A2, WarmStart* warm) {
  const DistanceOptions& options = methods.options();
  const bool found = spatial.growth(A2, A1, false, options, 1.0, warm, result);
  if (found && conclude()) return;
  const ProvenBounds proven = found ? ProvenBounds() : spatial.proven();
  // What the growth distance leaves open the Euclidean one may decide, in twice the precision.
  const Separation known = spatial.separation(A1, A2, options);
  if (known != Separation::undecided) {
    if (!found) result = DistanceResult(), result.lower = proven.lower, result.upper = proven.upper;
    return conclude(known, known == Separation::separated ? spatial.normal() : Vector());
  }
  if (!found) go_on(A2, A1, false, 1.0, proven, warm);
  if (!conclude() && options.max_iterations == 0 && result.status != DistanceStatus::time_limit)
    conclude_by_methods(A1, A2);
}

// By another proof.
void GrowthDistanceSolver::Workspace::conclude(Separation outcome, const Vector& normal) {
  conclude();
  separation.outcome = outcome;
  if (outcome == Separation::separated) separation.lower = std::max(result.lower, 1.0);
  if (outcome == Separation::intersecting) separation.upper = std::min(result.upper, 1.0);
  separation.normal = normal;
}

void GrowthDistanceSolver::Workspace::conclude_by_methods(const Posed& A1, const Posed& A2) {
  const int n = A1.dimension();
  if (!ball || ball->dimension() != n) ball = std::make_unique<const Ball>(Vector::Zero(n), 1.0);
  const InPose in_pose_1(A1), in_pose_2(A2);
  const ObjectPair pair(in_pose_2.set(), in_pose_1.set(), false);
  Aim aim;
  if (methods.options().time_limit < std::numeric_limits<double>::infinity())
    aim.time_limit = methods.options().time_limit - result.seconds;
  const DistanceResult& distance = methods.solve(Posed(pair), Posed(*ball), Effects::none, nullptr, aim);
  if (distance.status == DistanceStatus::contains_origin) conclude(Separation::intersecting, {});
  if (distance.lower > 0) conclude(Separation::separated, distance.normal);
}

DistanceOptions GrowthDistanceSolver::newton_options() {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  return options;
}

GrowthDistanceSolver::GrowthDistanceSolver(const DistanceOptions& options)
    : workspace_(std::make_unique<Workspace>(options)) {}

GrowthDistanceSolver::~GrowthDistanceSolver() = default;
GrowthDistanceSolver::GrowthDistanceSolver(GrowthDistanceSolver&&) noexcept = default;
GrowthDistanceSolver& GrowthDistanceSolver::operator=(GrowthDistanceSolver&&) noexcept = default;

void GrowthDistanceSolver::set_stop(std::function<bool()> stop) {
  workspace_->methods.set_stop(std::move(stop));
}

const DistanceResult& GrowthDistanceSolver::solve(const ConvexSet& A, const ConvexSet& Q) {
  return solve(Posed(A), Posed(Q));
}

const DistanceResult& GrowthDistanceSolver::solve(const Posed& A, const Posed& Q, WarmStart* warm) {
  check_dimension("growth distance", "Q", Q.dimension(), A.dimension());
  return workspace_->solve_about(A, Q, true, warm);
}

const DistanceResult& GrowthDistanceSolver::solve_about_centers(const Posed& A1, const Posed& A2,
                                                                WarmStart* warm) {
  check_dimension("growth distance", "A2", A2.dimension(), A1.dimension());
  return workspace_->solve_about(A2, A1, false, warm);
}

const SeparationResult& GrowthDistanceSolver::separation(const ConvexSet& A1, const ConvexSet& A2) {
  return separation(Posed(A1), Posed(A2));
}

const SeparationResult& GrowthDistanceSolver::separation(const Posed& A1, const Posed& A2, WarmStart* warm) {
  check_dimension("separation", "A2", A2.dimension(), A1.dimension());
  workspace_->separate(A1, A2, warm);
  return workspace_->separation;
}

}  // namespace raygauge
