// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/grasp_wrenches.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <string>

#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

using Eigen::Vector3d;

constexpr int kMostEdges = 1000000;

void check(const GraspContact& contact, std::size_t i) {
  const std::string place = "grasp wrenches: contact " + std::to_string(i) + ": ";
  if (!contact.point.allFinite() || !contact.normal.allFinite() || !std::isfinite(contact.friction))
    throw NonFiniteError(place + "a number is not finite");
  if (!(contact.normal.stableNorm() > 0)) throw InvalidParameterError(place + "the normal is zero");
  if (contact.friction < 0) throw InvalidParameterError(place + "friction must not be negative");
}

}  // namespace

GraspWrenches::GraspWrenches(const std::vector<GraspContact>& contacts, GraspForces forces, int edges)
    : ConvexSet(6), forces_(forces), edges_(edges) {
  if (contacts.empty()) throw EmptySetError("grasp wrenches: no contact");
  if (edges != 0 && (edges < 3 || edges > kMostEdges))
    throw InvalidParameterError("grasp wrenches: edges must be 0 or 3 to 1000000, got " +
                                std::to_string(edges));
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    check(contacts[i], i);
    Cone cone{contacts[i].point, contacts[i].normal.stableNormalized(), {}, {}, contacts[i].friction};
    cone.first = cone.n.unitOrthogonal();
    cone.second = cone.n.cross(cone.first);
    cones_.push_back(cone);
  }
  for (int k = 0; k < edges; ++k) {
    const double angle = 2 * EIGEN_PI * k / edges;
    corners_.emplace_back(std::cos(angle), std::sin(angle));
  }
}

// The force of normal force 1 whose tangential part has the direction of x first + y second, or the nearest
// of the k directions.
Vector3d GraspWrenches::force_at(const Cone& cone, double x, double y) const {
  if (edges_ > 0) {
    const double turns = std::atan2(y, x) / (2 * EIGEN_PI) * edges_;
    const int k = static_cast<int>(std::lround(turns + edges_)) % edges_;
    const Eigen::Vector2d& corner = corners_[static_cast<std::size_t>(k)];
    return cone.n + cone.friction * (corner[0] * cone.first + corner[1] * cone.second);
  }
  const double length = std::hypot(x, y);
  if (!(length > 0)) return cone.n + cone.friction * cone.first;
  return cone.n + cone.friction * (x / length * cone.first + y / length * cone.second);
}

double GraspWrenches::do_support(const double* u, double* point) const {
  const Vector3d force = Vector3d::Map(u), torque = Vector3d::Map(u + 3);
  Eigen::Map<Eigen::Matrix<double, 6, 1>> out(point);
  out.setZero();
  double best = -std::numeric_limits<double>::infinity();
  const Cone* outermost = nullptr;
  Vector3d of_outermost;
  for (const Cone& cone : cones_) {
    const Vector3d w = force + torque.cross(cone.p);
    const double x = w.dot(cone.first), y = w.dot(cone.second);
    const Vector3d f = force_at(cone, x, y);
    const double height = w.dot(f);
    if (forces_ == GraspForces::each) {
      if (!(height > 0)) continue;
      out.head<3>() += f;
      out.tail<3>() += cone.p.cross(f);
    } else if (outermost == nullptr || height > best) {
      best = height;
      outermost = &cone;
      of_outermost = f;
    }
  }
  if (outermost != nullptr) out << of_outermost, outermost->p.cross(of_outermost);
  return force.dot(out.head<3>()) + torque.dot(out.tail<3>());
}

void GraspWrenches::do_center(double* point) const {
  Eigen::Map<Eigen::Matrix<double, 6, 1>> out(point);
  out.setZero();
  const double share = forces_ == GraspForces::each ? 0.5 : 1.0 / static_cast<double>(cones_.size());
  for (const Cone& cone : cones_) {
    const Vector3d f = share * cone.n;
    out.head<3>() += f;
    out.tail<3>() += cone.p.cross(f);
  }
}

// A torque is a difference of products, which may be much smaller than they are.
void GraspWrenches::do_magnitude(double* magnitude) const {
  Eigen::Map<Eigen::Matrix<double, 6, 1>> out(magnitude);
  out.setZero();
  for (const Cone& cone : cones_) {
    const double force = 1 + 2 * cone.friction;
    const Vector3d p = cone.p.cwiseAbs();
    Eigen::Matrix<double, 6, 1> own;
    own << force, force, force, p[1] + p[2], p[2] + p[0], p[0] + p[1];
    own.tail<3>() *= force;
    if (forces_ == GraspForces::each) {
      out += own;
    } else {
      out = out.cwiseMax(own);
    }
  }
}

}  // namespace raygauge
