// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/similar_set.h"

#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/prepared_set.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge {

using SetPointer = std::shared_ptr<const ConvexSet>;

SetPointer similar_set(const SetPointer& S, double scale, const SmallVector& shift) {
  const Eigen::VectorXd t = shift;
  const auto moved = [&](const auto& point) { return Eigen::VectorXd(scale * point + t); };
  const ConvexSet* set = S.get();
  if (const auto* ball = dynamic_cast<const Ball*>(set))
    return std::make_shared<Ball>(moved(ball->center()), scale * ball->radius());
  if (const auto* box = dynamic_cast<const Box*>(set))
    return std::make_shared<Box>(moved(box->lower()), moved(box->upper()));
  if (const auto* capsule = dynamic_cast<const Capsule*>(set))
    return std::make_shared<Capsule>(moved(capsule->p()), moved(capsule->q()), scale * capsule->radius());
  if (const auto* cylinder = dynamic_cast<const Cylinder*>(set))
    return std::make_shared<Cylinder>(moved(cylinder->p()), moved(cylinder->q()), scale * cylinder->radius());
  if (const auto* cone = dynamic_cast<const TruncatedCone*>(set)) {
    return std::make_shared<TruncatedCone>(moved(cone->base()), scale * cone->base_radius(),
                                           moved(cone->top()), scale * cone->top_radius());
  }
  if (const auto* ellipsoid = dynamic_cast<const Ellipsoid*>(set))
    return std::make_shared<Ellipsoid>(moved(ellipsoid->center()), scale * ellipsoid->factor());
  if (const PointSet* points = as_point_set(*S)) {
    const Eigen::MatrixXd image = (scale * points->points()).colwise() + t;
    if (dynamic_cast<const PreparedSet*>(set) != nullptr) return std::make_shared<PreparedSet>(image);
    return std::make_shared<PointSet>(image);
  }
  const int n = S->dimension();
  return std::make_shared<AffineImage>(S, scale * Eigen::MatrixXd::Identity(n, n), t);
}

}  // namespace raygauge
