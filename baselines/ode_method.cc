// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/ode_method.h"

#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "baselines/pair_method.h"
#include "baselines/rigid_body.h"

namespace raygauge {
namespace {

using Kind = RigidBody::Kind;
using Eigen::Vector3d;

/// ODE itself, which wants to be started once.
void start() {
  static const bool kStarted = dInitODE2(0) != 0;
  static_cast<void>(kStarted);
  thread_local const bool kThread = dAllocateODEDataForThread(dAllocateMaskAll) != 0;
  static_cast<void>(kThread);
}

/// A geometry of ODE, with the arrays that a convex one refers to.
class OdeBody {
 public:
  explicit OdeBody(const RigidBody& body) {
    geometry_ = make(body);
    const Eigen::Matrix3d R = body.frame.linear();
    dMatrix3 rotation = {R(0, 0), R(0, 1), R(0, 2), 0,       R(1, 0), R(1, 1),
                         R(1, 2), 0,       R(2, 0), R(2, 1), R(2, 2), 0};
    const Vector3d t = body.frame.translation();
    dGeomSetPosition(geometry_, t.x(), t.y(), t.z());
    dGeomSetRotation(geometry_, rotation);
  }
  ~OdeBody() { dGeomDestroy(geometry_); }
  OdeBody(const OdeBody&) = delete;
  OdeBody& operator=(const OdeBody&) = delete;

  dGeomID geometry() const noexcept { return geometry_; }

  /// Cylinders and hulls need an ODE that is built with libccd: without it, it says of most pairs that they
  /// do not meet.
  static bool has(Kind kind) {
    if (kind == Kind::cylinder || kind == Kind::hull) return dCheckConfiguration("ODE_EXT_libccd") != 0;
    return kind != Kind::ellipsoid && kind != Kind::cone;
  }

 private:
  dGeomID make(const RigidBody& body) {
    switch (body.kind) {
      case Kind::ball:
        return dCreateSphere(nullptr, body.radius);
      case Kind::capsule:
        return dCreateCapsule(nullptr, body.radius, body.height);
      case Kind::box:
        return dCreateBox(nullptr, 2 * body.half.x(), 2 * body.half.y(), 2 * body.half.z());
      case Kind::cylinder:
        return dCreateCylinder(nullptr, body.radius, body.height);
      default:
        return make_hull(body);
    }
  }

  /// Of planes n·x = d, points, and faces as ODE has them: their number of points and which. ODE wants the
  /// origin inside.
  dGeomID make_hull(const RigidBody& body) {
    for (const Vector3d& p : body.vertices) points_.insert(points_.end(), p.begin(), p.end());
    for (std::size_t i = 0; i < body.triangles.size(); i += 3) {
      const auto corner = [&](std::size_t k) {
        return body.vertices[static_cast<std::size_t>(body.triangles[i + k])];
      };
      const Vector3d n = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
      planes_.insert(planes_.end(), {n.x(), n.y(), n.z(), n.dot(corner(0))});
      faces_.push_back(3);
      for (std::size_t k = 0; k < 3; ++k) faces_.push_back(static_cast<unsigned>(body.triangles[i + k]));
    }
    return dCreateConvex(nullptr, planes_.data(), static_cast<unsigned>(planes_.size() / 4), points_.data(),
                         static_cast<unsigned>(points_.size() / 3), faces_.data());
  }

  std::vector<dReal> planes_, points_;
  std::vector<unsigned> faces_;
  dGeomID geometry_ = nullptr;
};

/// The body about a point inside of it.
RigidBody centred(RigidBody body) {
  const Vector3d middle = body.inner_point();
  if (body.kind != Kind::hull) return body;
  const Vector3d own = body.frame.inverse() * middle;
  for (Vector3d& vertex : body.vertices) vertex -= own;
  body.frame.translation() = middle;
  return body;
}

class OdePair final : public BodyPair {
 public:
  OdePair(const RigidBody& first, const RigidBody& second)
      : first_(centred(first)), second_(centred(second)) {}

  PairAnswer answer(Quantity quantity, double /*tolerance*/) override {
    start();
    std::array<dContactGeom, 16> contacts{};
    const int found = dCollide(first_.geometry(), second_.geometry(), static_cast<int>(contacts.size()),
                               contacts.data(), sizeof(dContactGeom));
    if (quantity == Quantity::separated) return {found > 0 ? 0.0 : 1.0};
    if (found == 0) return {0.0};
    const auto deepest = std::max_element(contacts.begin(), contacts.begin() + found,
                                          [](const auto& a, const auto& b) { return a.depth < b.depth; });
    return {deepest->depth, -Vector3d(deepest->normal[0], deepest->normal[1], deepest->normal[2])};
  }

 private:
  OdeBody first_, second_;
};

}  // namespace

void register_ode_method(MethodRegistry& registry) {
  PairLibrary library;
  library.name = "ode";
  library.description = "whether two bodies of R^3 are separated, and their depth, by dCollide() of ODE";
  library.takes = "balls, capsules, boxes, cylinders and hulls that are not flat, of R^3";
  library.quantities = {Quantity::depth, Quantity::separated};
  library.make = [](const ConvexSet& one, const ConvexSet& two,
                    const Parameters& /*none*/) -> std::unique_ptr<BodyPair> {
    start();
    const auto first = RigidBody::of(one), second = RigidBody::of(two);
    if (!first || !second || !OdeBody::has(first->kind) || !OdeBody::has(second->kind)) return nullptr;
    return std::make_unique<OdePair>(*first, *second);
  };
  registry.add(pair_component(std::move(library)));
}

}  // namespace raygauge
