// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/bullet_method.h"

#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <memory>
#include <utility>

#include "baselines/bullet_shapes.h"
#include "baselines/pair_method.h"

namespace raygauge {
namespace {

class BulletPair final : public BodyPair {
 public:
  BulletPair(const RigidBody& first, const RigidBody& second, double margin)
      : first_(bullet_shape(first, margin)), second_(bullet_shape(second, margin)) {
    input_.m_transformA = bullet(first.frame);
    input_.m_transformB = bullet(second.frame);
  }

  PairAnswer answer(Quantity quantity, double /*tolerance*/) override {
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver epa;
    btGjkPairDetector detector(first_.get(), second_.get(), &simplex, &epa);
    btPointCollector found;
    detector.getClosestPoints(input_, found, nullptr);
    PairAnswer answer;
    if (!found.m_hasResult) return answer;
    const btVector3& to_first = found.m_normalOnBInWorld;
    answer.value = quantity == Quantity::depth ? -found.m_distance : found.m_distance;  // it is a signed one
    answer.direction = -Eigen::Vector3d(to_first.x(), to_first.y(), to_first.z());
    return answer;
  }

 private:
  std::unique_ptr<btConvexShape> first_, second_;
  btGjkPairDetector::ClosestPointInput input_;
};

}  // namespace

void register_bullet_method(MethodRegistry& registry) {
  PairLibrary library;
  library.name = "bullet";
  library.description = "distance and depth of two bodies of R^3 by the pair detector (GJK, EPA) of Bullet " +
                        bullet_library_version() + ", double precision";
  library.parameters = {
      {"margin",
       0.0,
       0.0,
       1.0,
       "Bullet's collision margin, absolute; Bullet's own is 0.04, which makes cones, ellipsoids "
       "and hulls larger",
       {}}};
  library.takes = kRigidBodies;
  library.quantities = {Quantity::distance, Quantity::depth, Quantity::separated};
  library.make = [](const ConvexSet& one, const ConvexSet& two,
                    const Parameters& parameters) -> std::unique_ptr<BodyPair> {
    const auto first = RigidBody::of(one), second = RigidBody::of(two);
    if (!first || !second) return nullptr;
    return std::make_unique<BulletPair>(*first, *second, real_parameter(parameters, "margin"));
  };
  registry.add(pair_component(std::move(library)));
}

std::string bullet_library_version() {
  return std::to_string(BT_BULLET_VERSION / 100) + "." + std::to_string(BT_BULLET_VERSION % 100);
}

}  // namespace raygauge
