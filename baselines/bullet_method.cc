// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/bullet_method.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConeShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <memory>
#include <utility>

#include "baselines/pair_method.h"
#include "baselines/rigid_body.h"

namespace raygauge {
namespace {

using Shape = std::unique_ptr<btConvexShape>;
using Kind = RigidBody::Kind;

btVector3 bullet(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

btTransform bullet(const Eigen::Isometry3d& pose) {
  const Eigen::Matrix3d R = pose.linear();
  return btTransform(
      btMatrix3x3(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2)),
      bullet(Eigen::Vector3d(pose.translation())));
}

/// h(u) = |(a_i u_i)|, the support point (a_i^2 u_i)/h(u).
class Ellipsoid final : public btConvexInternalShape {
 public:
  explicit Ellipsoid(const btVector3& semi_axes) : semi_axes_(semi_axes) {
    m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
  }

  btVector3 localGetSupportingVertexWithoutMargin(const btVector3& u) const override {
    const btVector3 scaled = semi_axes_ * u;
    const btScalar h = scaled.length();
    return h > 0 ? semi_axes_ * scaled / h : btVector3(semi_axes_.x(), 0, 0);
  }

  void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* u, btVector3* points,
                                                         int count) const override {
    for (int i = 0; i < count; ++i) points[i] = localGetSupportingVertexWithoutMargin(u[i]);
  }

  void calculateLocalInertia(btScalar /*mass*/, btVector3& inertia) const override { inertia.setZero(); }
  const char* getName() const override { return "ellipsoid"; }

 private:
  btVector3 semi_axes_;
};

Shape hull_of(const RigidBody& body) {
  auto hull = std::make_unique<btConvexHullShape>();
  for (const Eigen::Vector3d& vertex : body.vertices) hull->addPoint(bullet(vertex), false);
  hull->recalcLocalAabb();
  return hull;
}

Shape shape_of(const RigidBody& body, double margin) {
  Shape shape;
  switch (body.kind) {
    case Kind::ball:  // the margin of these two is their radius
      return std::make_unique<btSphereShape>(body.radius);
    case Kind::capsule:
      return std::make_unique<btCapsuleShapeZ>(body.radius, body.height);
    case Kind::box:
      shape = std::make_unique<btBoxShape>(bullet(body.half));
      break;
    case Kind::ellipsoid:
      shape = std::make_unique<Ellipsoid>(bullet(body.half));
      break;
    case Kind::cylinder:
      shape = std::make_unique<btCylinderShapeZ>(btVector3(body.radius, body.radius, 0.5 * body.height));
      break;
    case Kind::cone:
      shape = std::make_unique<btConeShapeZ>(body.radius, body.height);
      break;
    case Kind::frustum:
    case Kind::hull:
      shape = hull_of(body);
      break;
  }
  shape->setMargin(margin);
  return shape;
}

class BulletPair final : public BodyPair {
 public:
  BulletPair(const RigidBody& first, const RigidBody& second, double margin)
      : first_(shape_of(first, margin)), second_(shape_of(second, margin)) {
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
  Shape first_, second_;
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
