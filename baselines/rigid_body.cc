// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/rigid_body.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "engine/sets/hull_3d.h"
#include "engine/sets/spatial_shape.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/prepared_set.h"

namespace raygauge {
namespace {

using Kind = RigidBody::Kind;

Eigen::Vector3d eigen(const Vector3& v) { return {v.x, v.y, v.z}; }

void stand_along(RigidBody& body, const Eigen::Vector3d& center, const Eigen::Vector3d& axis) {
  body.frame.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis).toRotationMatrix();
  body.frame.translation() = center;
}

bool take_hull(const Eigen::MatrixXd& points, RigidBody& body) {
  const Hull3 hull = hull_3d(points, points.rowwise().mean());
  if (!hull.found) return false;
  body.kind = Kind::hull;
  std::vector<int> place(static_cast<std::size_t>(points.cols()), -1);
  for (const int corner : hull.triangles) {
    int& index = place[static_cast<std::size_t>(corner)];
    if (index < 0) {
      index = static_cast<int>(body.vertices.size());
      body.vertices.emplace_back(points.col(corner));
    }
    body.triangles.push_back(index);
  }
  return true;
}

bool take_round_body(const SpatialShape& shape, RigidBody& body) {
  const Eigen::Vector3d base = eigen(shape.base), top = eigen(shape.top);
  const bool is_cylinder = shape.base_radius == shape.top_radius;
  const bool is_frustum = !is_cylinder && shape.base_radius != 0 && shape.top_radius != 0;
  const double sign = shape.top_radius > shape.base_radius ? -1 : 1;
  body.kind = is_cylinder ? Kind::cylinder : is_frustum ? Kind::frustum : Kind::cone;
  body.radius = std::max(shape.base_radius, shape.top_radius);
  body.top_radius = std::min(shape.base_radius, shape.top_radius);
  body.height = (top - base).norm();
  stand_along(body, 0.5 * (base + top), sign * (top - base));
  return true;
}

void take_ellipsoid(const SpatialShape& shape, RigidBody& body) {
  Eigen::Matrix3d L;
  for (int j = 0; j < 3; ++j) L.col(j) = eigen(shape.axis.column[j]);
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(L, Eigen::ComputeFullU);
  Eigen::Matrix3d R = svd.matrixU();
  if (R.determinant() < 0) R.col(2) = -R.col(2);
  body.kind = Kind::ellipsoid;
  body.half = svd.singularValues();
  body.frame.linear() = R;
  body.frame.translation() = eigen(shape.center);
}

bool take(const ConvexSet& S, const SpatialShape& shape, RigidBody& body) {
  using Core = SpatialShape::Kind;
  if (shape.kind != Core::point && shape.kind != Core::segment && shape.radius > 0) return false;
  body.radius = shape.radius;
  body.frame.translation() = eigen(shape.center);
  switch (shape.kind) {
    case Core::point:
      return true;
    case Core::segment:
      body.kind = Kind::capsule;
      body.height = 2 * length(shape.axis.column[0]);
      stand_along(body, eigen(shape.center), eigen(shape.axis.column[0]));
      return true;
    case Core::box:
      body.kind = Kind::box;
      body.half = eigen(shape.axis.column[0]);
      return true;
    case Core::ellipsoid:
      take_ellipsoid(shape, body);
      return true;
    case Core::frustum:
      return take_round_body(shape, body);
    case Core::points:
      break;
  }
  body.frame = Eigen::Isometry3d::Identity();
  const PointSet* points = as_point_set(S);
  return points != nullptr && take_hull(points->points(), body);
}

}  // namespace

Eigen::Vector3d RigidBody::support(const Eigen::Vector3d& u) const {
  const Eigen::Vector3d v = frame.linear().transpose() * u;
  const double side = std::copysign(0.5 * height, v.z());
  const auto rim = [&](double r, double z) -> Eigen::Vector3d {  // of the disc of radius r at height z
    const double across = std::hypot(v.x(), v.y());
    return across > 0 ? Eigen::Vector3d(r * v.x() / across, r * v.y() / across, z) : Eigen::Vector3d(0, 0, z);
  };
  switch (kind) {
    case Kind::ball:
      return frame * (radius * v.normalized());
    case Kind::capsule:
      return frame * (side * Eigen::Vector3d::UnitZ() + radius * v.normalized());
    case Kind::box:
      return frame * Eigen::Vector3d(half.array() * v.array().sign());
    case Kind::ellipsoid:
      return frame * Eigen::Vector3d(half.cwiseProduct(half.cwiseProduct(v).normalized()));
    case Kind::cylinder:
    case Kind::cone:
    case Kind::frustum: {
      const Eigen::Vector3d foot = rim(radius, -0.5 * height);
      const Eigen::Vector3d top = rim(top_radius, 0.5 * height);
      return frame * (v.dot(top) > v.dot(foot) ? top : foot);
    }
    case Kind::hull:
      break;
  }
  const auto higher = [&v](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
    return p.dot(v) < q.dot(v);
  };
  return frame * *std::max_element(vertices.begin(), vertices.end(), higher);
}

Eigen::Vector3d RigidBody::inner_point() const {
  if (kind != Kind::hull) return frame.translation();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& vertex : vertices) sum += vertex;
  return frame * (sum / static_cast<double>(vertices.size()));
}

std::optional<RigidBody> RigidBody::of(const ConvexSet& S, Frusta frusta) {
  if (const auto* image = dynamic_cast<const AffineImage*>(&S); image != nullptr && S.dimension() == 3) {
    constexpr double kRigid = 1e-12;
    const Eigen::Matrix3d R = image->M();
    if (!(R.transpose() * R).isIdentity(kRigid) || R.determinant() < 0) return std::nullopt;
    auto body = of(*image->S(), frusta);
    if (!body) return std::nullopt;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = R;
    pose.translation() = image->t();
    body->frame = pose * body->frame;
    return body;
  }
  const SpatialShape* shape = S.spatial_shape();
  RigidBody body;
  if (S.dimension() != 3 || shape == nullptr || !take(S, *shape, body)) return std::nullopt;
  if (body.kind == Kind::frustum && frusta == Frusta::refused) return std::nullopt;
  return body;
}

}  // namespace raygauge
