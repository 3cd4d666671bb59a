// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <memory>
#include <vector>

#include "baselines/bullet_shapes.h"
#include "scene/engines/physics_engine.h"

namespace raygauge {
namespace {

Eigen::Vector3d eigen(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

Eigen::Matrix3d eigen(const btMatrix3x3& R) {
  Eigen::Matrix3d all;
  for (int k = 0; k < 3; ++k) all.row(k) = eigen(R[k]).transpose();
  return all;
}

btTransform bullet(const BodyState& state) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = state.R;
  pose.translation() = state.x;
  return raygauge::bullet(pose);
}

using Shapes = std::vector<std::unique_ptr<btCollisionShape>>;

/// Its shape; what that is made of is kept in `shapes`, too.
btCollisionShape* shape_of(const EngineBody& body, Shapes& shapes) {
  if (body.plane) {
    const Eigen::Vector3d normal = body.plane->head<3>();
    shapes.push_back(std::make_unique<btStaticPlaneShape>(raygauge::bullet(normal), (*body.plane)[3]));
    return shapes.back().get();
  }
  const bool plain = body.parts.size() == 1 && body.parts.front().frame.matrix().isIdentity(0);
  auto compound = std::make_unique<btCompoundShape>();
  for (const RigidBody& part : body.parts) {
    shapes.push_back(bullet_shape(part, std::nullopt));
    if (plain) return shapes.back().get();
    compound->addChildShape(raygauge::bullet(part.frame), shapes.back().get());
  }
  shapes.push_back(std::move(compound));
  return shapes.back().get();
}

/// Bullet multiplies numbers of both bodies; in place of these each contact gets those of its pair.
bool take_law(btManifoldPoint& point, const btCollisionObjectWrapper* a, int /*part*/, int /*index*/,
              const btCollisionObjectWrapper* b, int /*part*/, int /*index*/) {
  const btCollisionObject *one = a->getCollisionObject(), *two = b->getCollisionObject();
  const auto& world = *static_cast<const EngineWorld*>(one->getUserPointer());
  const auto law = world.law(one->getUserIndex(), two->getUserIndex());
  point.m_combinedFriction = law ? law->friction.value_or(0) : 0;
  point.m_combinedRestitution = law ? law->restitution.value_or(0) : 0;
  return true;
}

/// Only pairs that have a law are looked at.
struct LawFilter final : btOverlapFilterCallback {
  bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override {
    const auto* one = static_cast<const btCollisionObject*>(a->m_clientObject);
    const auto* two = static_cast<const btCollisionObject*>(b->m_clientObject);
    if (one->isStaticOrKinematicObject() && two->isStaticOrKinematicObject()) return false;
    const auto& world = *static_cast<const EngineWorld*>(one->getUserPointer());
    return world.law(one->getUserIndex(), two->getUserIndex()).has_value();
  }
};

/// Sequential impulses, 10 iterations a step. Bodies never fall asleep.
class BulletEngine final : public PhysicsEngine {
 public:
  explicit BulletEngine(const EngineWorld& world) : dispatcher_(&configuration_) {
    gContactAddedCallback = take_law;
    pairs_.setOverlapFilterCallback(&filter_);
    world_.setGravity(raygauge::bullet(world.gravity));
    for (const EngineBody& body : world.bodies) add(body, world);
  }

  ~BulletEngine() override {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }

  void drive(int body, const BodyState& state) override { of(body).setWorldTransform(bullet(state)); }

  void step(double dt) override { world_.stepSimulation(dt, 0); }

  BodyState state(int body) const override {
    const btRigidBody& one = *bodies_[static_cast<std::size_t>(body)];
    const btTransform& at = one.getWorldTransform();
    return {eigen(at.getOrigin()), eigen(at.getBasis()), eigen(one.getLinearVelocity()),
            eigen(one.getAngularVelocity())};
  }

 private:
  btRigidBody& of(int body) { return *bodies_[static_cast<std::size_t>(body)]; }

  void add(const EngineBody& body, const EngineWorld& world) {
    btRigidBody::btRigidBodyConstructionInfo info(body.mass, nullptr, shape_of(body, shapes_),
                                                  raygauge::bullet(body.moments));
    info.m_startWorldTransform = bullet(body.start);
    if (world.damping) {  // v (1 - d)^dt
      info.m_linearDamping = 1 - std::exp(-world.damping->linear);
      info.m_angularDamping = 1 - std::exp(-world.damping->angular);
    }
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& one = *bodies_.back();
    one.setUserIndex(static_cast<int>(bodies_.size()) - 1);
    one.setUserPointer(const_cast<EngineWorld*>(&world));
    one.setActivationState(DISABLE_DEACTIVATION);
    int flags = one.getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK;
    if (body.moves && body.mass == 0) flags |= btCollisionObject::CF_KINEMATIC_OBJECT;
    one.setCollisionFlags(flags);
    if (body.mass > 0) {
      one.setLinearVelocity(raygauge::bullet(body.start.v));
      one.setAngularVelocity(raygauge::bullet(body.start.spin));
    }
    world_.addRigidBody(&one);
  }

  LawFilter filter_;
  btHashedOverlappingPairCache pairs_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broad_{&pairs_};
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broad_, &solver_, &configuration_};
  Shapes shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

}  // namespace
}  // namespace raygauge

extern "C" raygauge::PhysicsEngine* raygauge_create_engine(const raygauge::EngineWorld& world) {
  return new raygauge::BulletEngine(world);
}
