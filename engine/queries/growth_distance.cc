// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/growth_distance.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/queries/growth_body.h"
#include "engine/queries/method_chain.h"
#include "engine/queries/spatial_query.h"
#include "engine/sets/parameters.h"
#include "engine/sets/posed_view.h"

namespace raygauge {
namespace {

constexpr double kNoThreshold = std::numeric_limits<double>::quiet_NaN();

}  // namespace

struct GrowthDistanceSolver::Centers {
  PosedCenter A, Q;
};

DistanceOptions GrowthDistanceSolver::newton_options() {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  return options;
}

GrowthDistanceSolver::GrowthDistanceSolver(const DistanceOptions& options)
    : methods_(std::make_unique<MethodChain>(options)),
      spatial_(std::make_unique<SpatialQuery>()),
      centers_(std::make_unique<Centers>()) {}

GrowthDistanceSolver::~GrowthDistanceSolver() = default;
GrowthDistanceSolver::GrowthDistanceSolver(GrowthDistanceSolver&&) noexcept = default;
GrowthDistanceSolver& GrowthDistanceSolver::operator=(GrowthDistanceSolver&&) noexcept = default;

void GrowthDistanceSolver::set_stop(std::function<bool()> stop) { methods_->set_stop(std::move(stop)); }

// A is scaled about its centre, Q about the origin or its own. By fixed-size code where that has the answer.
const DistanceResult& GrowthDistanceSolver::solve_about(const Posed& A, const Posed& Q, bool about_origin,
                                                        double threshold, WarmStart* warm) {
  if (spatial_->growth(A, Q, about_origin, methods_->options(), threshold, warm, spatial_result_)) {
    return spatial_result_;
  }
  const InPose in_pose_A(A), in_pose_Q(Q);
  centers_->A.assign(A);
  if (about_origin) {
    centers_->Q.assign_origin(A.dimension());
  } else {
    centers_->Q.assign(Q);
  }
  const GrowthBody body(in_pose_A.set(), centers_->A.point(), in_pose_Q.set(), centers_->Q.point(),
                        !about_origin);
  const PointView ray(centers_->A.point(), A.dimension(), centers_->Q.point());
  Aim aim;
  aim.threshold = threshold;
  return methods_->solve(Posed(ray), Posed(body), Effects::none, warm, aim);
}

const DistanceResult& GrowthDistanceSolver::solve(const ConvexSet& A, const ConvexSet& Q) {
  return solve(Posed(A), Posed(Q));
}

const DistanceResult& GrowthDistanceSolver::solve(const Posed& A, const Posed& Q, WarmStart* warm) {
  check_dimension("growth distance", "Q", Q.dimension(), A.dimension());
  return solve_about(A, Q, true, kNoThreshold, warm);
}

const DistanceResult& GrowthDistanceSolver::solve_about_centers(const Posed& A1, const Posed& A2,
                                                                WarmStart* warm) {
  check_dimension("growth distance", "A2", A2.dimension(), A1.dimension());
  return solve_about(A2, A1, false, kNoThreshold, warm);
}

const SeparationResult& GrowthDistanceSolver::separation(const ConvexSet& A1, const ConvexSet& A2) {
  return separation(Posed(A1), Posed(A2));
}

const SeparationResult& GrowthDistanceSolver::separation(const Posed& A1, const Posed& A2, WarmStart* warm) {
  check_dimension("separation", "A2", A2.dimension(), A1.dimension());
  const DistanceResult& growth = solve_about(A2, A1, false, 1.0, warm);
  separation_.lower = growth.lower;
  separation_.upper = growth.upper;
  separation_.counters = growth.counters;
  separation_.outcome = Separation::undecided;
  if (growth.lower > 1) separation_.outcome = Separation::separated;
  if (growth.upper < 1) separation_.outcome = Separation::intersecting;
  if (separation_.outcome == Separation::separated) {
    separation_.normal = growth.normal;
  } else {
    separation_.normal.resize(0);
  }
  return separation_;
}

}  // namespace raygauge
