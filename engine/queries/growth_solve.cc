// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/growth_solve.h"

#include "engine/sets/posed_view.h"

namespace raygauge {

const DistanceResult& GrowthSolve::solve(const Posed& A, const Posed& Q, bool about_origin, const Aim& aim,
                                         WarmStart* warm, MethodChain& methods) {
  const InPose in_pose_A(A), in_pose_Q(Q);
  A_.assign(A);
  if (about_origin) {
    Q_.assign_origin(A.dimension());
  } else {
    Q_.assign(Q);
  }
  const GrowthBody body(in_pose_A.set(), A_.point(), in_pose_Q.set(), Q_.point(), !about_origin);
  const PointView ray(A_.point(), A.dimension(), Q_.point());
  return methods.solve(Posed(ray), Posed(body), Effects::none, warm, aim);
}

}  // namespace raygauge
