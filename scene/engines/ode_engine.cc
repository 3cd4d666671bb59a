// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <ode/ode.h>

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "raygauge/exceptions.h"
#include "scene/engines/physics_engine.h"

namespace raygauge {
namespace {

using Kind = RigidBody::Kind;

struct Rotation {
  explicit Rotation(const Eigen::Matrix3d& R) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) rows[4 * i + j] = R(i, j);
      rows[4 * i + 3] = 0;
    }
  }
  dMatrix3 rows;
};

Eigen::Vector3d vector_of(const dReal* v) { return {v[0], v[1], v[2]}; }

Eigen::Matrix3d matrix_of(const dReal* R) {
  Eigen::Matrix3d all;
  for (int i = 0; i < 3; ++i) all.row(i) = vector_of(R + static_cast<std::ptrdiff_t>(4) * i).transpose();
  return all;
}

/// What ODE refers to for as long as a hull lives: a mesh of triangles.
struct Mesh {
  std::vector<double> corners;
  std::vector<dTriIndex> triangles;
  dTriMeshDataID data = nullptr;

  explicit Mesh(const RigidBody& body) {
    for (const Eigen::Vector3d& vertex : body.vertices)
      corners.insert(corners.end(), {vertex.x(), vertex.y(), vertex.z()});
    triangles.assign(body.triangles.begin(), body.triangles.end());
    data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data, corners.data(), 3 * sizeof(double),
                                static_cast<int>(body.vertices.size()), triangles.data(),
                                static_cast<int>(triangles.size()), 3 * sizeof(dTriIndex));
  }
  Mesh(const Mesh&) = delete;
  Mesh& operator=(const Mesh&) = delete;
  ~Mesh() { dGeomTriMeshDataDestroy(data); }
};

/// ODE's quick step: 20 iterations of successive overrelaxation; error reduction and softness as they are.
class OdeEngine final : public PhysicsEngine {
 public:
  explicit OdeEngine(const EngineWorld& world) : given_(world) {
    dInitODE2(0);
    world_ = dWorldCreate();
    space_ = dHashSpaceCreate(nullptr);
    contacts_ = dJointGroupCreate(0);
    dWorldSetGravity(world_, world.gravity.x(), world.gravity.y(), world.gravity.z());
    for (std::size_t b = 0; b < world.bodies.size(); ++b) add(static_cast<int>(b), world.bodies[b]);
  }

  ~OdeEngine() override {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
    meshes_.clear();
    dCloseODE();
  }

  void drive(int body, const BodyState& state) override {
    place(bodies_[static_cast<std::size_t>(body)], state);
  }

  void step(double dt) override {
    dSpaceCollide(space_, this,
                  [](void* self, dGeomID a, dGeomID b) { static_cast<OdeEngine*>(self)->collide(a, b); });
    dWorldQuickStep(world_, dt);
    dJointGroupEmpty(contacts_);
  }

  BodyState state(int body) const override {
    dBodyID one = bodies_[static_cast<std::size_t>(body)];
    return {vector_of(dBodyGetPosition(one)), matrix_of(dBodyGetRotation(one)),
            vector_of(dBodyGetLinearVel(one)), vector_of(dBodyGetAngularVel(one))};
  }

 private:
  static void place(dBodyID body, const BodyState& state) {
    const Rotation rotation(state.R);
    dBodySetPosition(body, state.x.x(), state.x.y(), state.x.z());
    dBodySetRotation(body, rotation.rows);
    dBodySetLinearVel(body, state.v.x(), state.v.y(), state.v.z());
    dBodySetAngularVel(body, state.spin.x(), state.spin.y(), state.spin.z());
  }

  void add(int number, const EngineBody& body) {
    dBodyID one = body.moves ? dBodyCreate(world_) : nullptr;
    bodies_.push_back(one);
    if (body.mass > 0) {
      dMass mass;
      dMassSetParameters(&mass, body.mass, 0, 0, 0, body.moments[0], body.moments[1], body.moments[2], 0, 0,
                         0);
      dBodySetMass(one, &mass);
      dBodySetAutoDisableFlag(one, 0);
      if (given_.damping) {
        dBodySetLinearDamping(one,
                              given_.damping->linear * given_.step);  // a share of the velocity, each step
        dBodySetAngularDamping(one, given_.damping->angular * given_.step);
        dBodySetLinearDampingThreshold(one, 0);
        dBodySetAngularDampingThreshold(one, 0);
      }
    }
    if (one != nullptr && body.mass == 0) dBodySetKinematic(one);
    if (one != nullptr) place(one, body.start);
    if (body.plane) add_plane(number, body);
    for (const RigidBody& part : body.parts) add_part(number, part, one, body.start);
  }

  void add_plane(int number, const EngineBody& body) {
    const Eigen::Vector3d n = body.start.R * body.plane->head<3>();
    const double c = (*body.plane)[3] + n.dot(body.start.x);
    name(dCreatePlane(space_, n.x(), n.y(), n.z(), c), number);
  }

  void add_part(int number, const RigidBody& part, dBodyID body, const BodyState& start) {
    dGeomID geom = geometry_of(part);
    name(geom, number);
    Eigen::Isometry3d frame = part.frame;
    if (body != nullptr) {
      dGeomSetBody(geom, body);
      const Rotation rotation(frame.linear());
      dGeomSetOffsetPosition(geom, frame.translation().x(), frame.translation().y(), frame.translation().z());
      dGeomSetOffsetRotation(geom, rotation.rows);
      return;
    }
    const Eigen::Vector3d at = start.x + start.R * frame.translation();
    const Rotation rotation(start.R * frame.linear());
    dGeomSetPosition(geom, at.x(), at.y(), at.z());
    dGeomSetRotation(geom, rotation.rows);
  }

  dGeomID geometry_of(const RigidBody& part) {
    switch (part.kind) {
      case Kind::ball:
        return dCreateSphere(space_, part.radius);
      case Kind::capsule:
        return dCreateCapsule(space_, part.radius, part.height);
      case Kind::box:
        return dCreateBox(space_, 2 * part.half.x(), 2 * part.half.y(), 2 * part.half.z());
      case Kind::cylinder:
        return dCreateCylinder(space_, part.radius, part.height);
      case Kind::hull:
        meshes_.push_back(std::make_unique<Mesh>(part));
        return dCreateTriMesh(space_, meshes_.back()->data, nullptr, nullptr, nullptr);
      case Kind::ellipsoid:
      case Kind::cone:
      case Kind::frustum:
        break;
    }
    throw InvalidParameterError("engine: ode has no ellipsoids and no cones");
  }

  static void name(dGeomID geom, int number) {
    const auto index = static_cast<std::intptr_t>(number);
    dGeomSetData(geom, reinterpret_cast<void*>(index));  // NOLINT(performance-no-int-to-ptr): never followed
  }
  static int number_of(dGeomID geom) {
    return static_cast<int>(reinterpret_cast<std::intptr_t>(dGeomGetData(geom)));
  }

  void collide(dGeomID a, dGeomID b) {
    constexpr int kMost = 16;
    const int one = number_of(a), two = number_of(b);
    const auto reacts = [this](int k) { return given_.bodies[static_cast<std::size_t>(k)].mass > 0; };
    if (one == two || !(reacts(one) || reacts(two))) return;
    const auto law = given_.law(one, two);
    if (!law) return;
    dContact found[kMost];
    const int count = dCollide(a, b, kMost, &found[0].geom, sizeof(dContact));
    for (int k = 0; k < count; ++k) {
      dSurfaceParameters& surface = found[k].surface;
      surface = dSurfaceParameters{};
      surface.mode = dContactApprox1;  // friction bounded by the normal force
      surface.mu = law->friction.value_or(0);
      if (law->restitution) {
        surface.mode |= dContactBounce;
        surface.bounce = *law->restitution;
      }
      dJointID joint = dJointCreateContact(world_, contacts_, &found[k]);
      dJointAttach(joint, dGeomGetBody(a), dGeomGetBody(b));
    }
  }

  const EngineWorld& given_;
  dWorldID world_ = nullptr;
  dSpaceID space_ = nullptr;
  dJointGroupID contacts_ = nullptr;
  std::vector<dBodyID> bodies_;  ///< none: it stands
  std::vector<std::unique_ptr<Mesh>> meshes_;
};

}  // namespace
}  // namespace raygauge

extern "C" raygauge::PhysicsEngine* raygauge_create_engine(const raygauge::EngineWorld& world) {
  return new raygauge::OdeEngine(world);
}
