// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/bullet_shapes.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConeShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>

namespace raygauge {
namespace {

using Shape = std::unique_ptr<btConvexInternalShape>;
using Kind = RigidBody::Kind;

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

Shape shape_of(const RigidBody& body) {
  switch (body.kind) {
    case Kind::ball:
      return std::make_unique<btSphereShape>(body.radius);
    case Kind::capsule:
      return std::make_unique<btCapsuleShapeZ>(body.radius, body.height);
    case Kind::box:
      return std::make_unique<btBoxShape>(bullet(body.half));
    case Kind::ellipsoid:
      return std::make_unique<Ellipsoid>(bullet(body.half));
    case Kind::cylinder:
      return std::make_unique<btCylinderShapeZ>(btVector3(body.radius, body.radius, 0.5 * body.height));
    case Kind::cone:
      return std::make_unique<btConeShapeZ>(body.radius, body.height);
    case Kind::frustum:
    case Kind::hull:
      break;
  }
  return hull_of(body);
}

}  // namespace

btVector3 bullet(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

btTransform bullet(const Eigen::Isometry3d& pose) {
  const Eigen::Matrix3d R = pose.linear();
  return btTransform(
      btMatrix3x3(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2)),
      bullet(Eigen::Vector3d(pose.translation())));
}

std::unique_ptr<btConvexShape> bullet_shape(const RigidBody& body, std::optional<double> margin) {
  Shape shape = shape_of(body);
  if (body.kind == Kind::ball || body.kind == Kind::capsule) return shape;
  if (margin) {
    shape->setMargin(*margin);
  } else {
    btVector3 low, high;
    shape->getAabb(btTransform::getIdentity(), low, high);
    const btVector3 half = (high - low) / 2;
    const bool inside = body.kind == Kind::box || body.kind == Kind::cylinder;
    shape->setSafeMargin(half[half.minAxis()] - (inside ? 0 : shape->getMargin()));
  }
  return shape;
}

}  // namespace raygauge
