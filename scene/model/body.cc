// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/meshes/box_tree.h"
#include "engine/numerics/floating_point.h"
#include "engine/sets/spatial_shape.h"
#include "raygauge/exceptions.h"
#include "raygauge/meshes/mesh.h"
#include "raygauge/sets/half_space.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/prepared_set.h"
#include "scene/model/part_tree.h"

namespace raygauge {
namespace {

// What the computation of a radius may lose, with room to spare.
constexpr double kOutward = 1 + 1e-13;

// Directions to the faces, edges and corners of a cube. No direction of 3-space makes an angle with the
// nearest of them whose cosine is below 0.8864 (that of the point equally far from (1,0,0), (1,1,0) and
// (1,1,1): 1/√(1 + (√2-1)² + (√3-√2)²)).
constexpr double kLeastCosine = 0.8864;

double radius_by_points(const PointSet& S, const SmallVector& center) {
  double squared = 0;
  SmallVector p(center.size());
  for (std::ptrdiff_t i = 0; i < S.size(); ++i) {
    S.copy_point(i, p.data());
    squared = std::max(squared, (p - center).squaredNorm());
  }
  return std::sqrt(squared);
}

// How far S reaches from the centre along u, |u| = 1.
double extent(const ConvexSet& S, const SmallVector& center, const SmallVector& u) {
  SmallVector point(u.size());
  return S.support_unchecked(u.data(), point.data()) - u.dot(center);
}

double radius_by_directions(const ConvexSet& S, const SmallVector& center) {
  double farthest = 0;
  for (int code = 0; code < 27; ++code) {
    SmallVector u(3);
    const int digit[3] = {code % 3, code / 3 % 3, code / 9};
    u << digit[0] - 1, digit[1] - 1, digit[2] - 1;
    if (u.isZero(0)) continue;
    farthest = std::max(farthest, extent(S, center, u / u.norm()));
  }
  return farthest / kLeastCosine;
}

// Magnitudes of a ball's points and what support functions of that size may lose.
double rounding_of(const SmallVector& magnitude) {
  const int n = static_cast<int>(magnitude.size());
  return 4 * ConvexSet::rounding_error(n) * magnitude.sum();
}

// What a turn about the origin moves of S: S = core + radius B, and the ball B is the same from all sides.
double reach_of_core(const ConvexSet& S, double reach) {
  const SpatialShape* shape = S.spatial_shape();
  if (shape == nullptr || !(shape->radius > 0)) return reach;
  return std::min({reach, shape->extent, std::max(0.0, reach - shape->radius)}) * kOutward;
}

// Hulls of so many points are climbed: from here on a step costs less than a pass over the points.
std::shared_ptr<const ConvexSet> prepared_if_it_pays(const std::shared_ptr<const ConvexSet>& S) {
  constexpr std::ptrdiff_t kFewest = 1000;
  const auto* points = dynamic_cast<const PointSet*>(S.get());
  const bool pays = points != nullptr && points->size() >= kFewest && PreparedSet::has_hulls();
  return pays ? std::make_shared<PreparedSet>(*points) : S;
}

// use(p) for the corners of all triangles.
template <class Use>
void for_each_corner(const Mesh& mesh, const Use& use) {
  for (std::int32_t i = 0; i < mesh.size(); ++i) {
    for (const Vector3& p : mesh.tree().triangle(i).corner) use(Eigen::Vector3d(p.x, p.y, p.z));
  }
}

void measure(const ConvexSet& S, SmallVector& magnitude) {
  if (const Mesh* mesh = as_mesh(S)) {
    magnitude.setZero();
    for_each_corner(*mesh, [&](const Eigen::Vector3d& p) { magnitude = magnitude.cwiseMax(p.cwiseAbs()); });
    magnitude.array() += mesh->radius();
  } else {
    S.magnitude_unchecked(magnitude.data());
  }
}

BoundingBall ball_of(const Mesh& mesh) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(kInfinity), high = -low;
  for_each_corner(mesh, [&](const Eigen::Vector3d& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  });
  const Eigen::Vector3d center = low + 0.5 * (high - low);
  double square = 0;
  for_each_corner(mesh,
                  [&](const Eigen::Vector3d& p) { square = std::max(square, (p - center).squaredNorm()); });
  return {SmallVector(center), std::sqrt(square) + mesh.radius()};
}

// All parts, about this point; many of them in a tree, too.
void enclose(Body& body, const SmallVector& center) {
  body.ball.center = center;
  for (const BodyPart& part : body.parts) {
    const double radius = (part.ball.center - center).norm() + part.ball.radius;
    body.ball.radius = std::max(body.ball.radius, radius * kOutward);
  }
  if (body.parts.size() >= PartTree::kFewest) body.tree = std::make_shared<PartTree>(body.parts);
}

// About the point of the plane that is nearest to the body's origin.
void take_half_space(const std::shared_ptr<const ConvexSet>& set, const HalfSpace& half_space, Body& body) {
  BodyPart part;
  part.set = set;
  part.magnitude = half_space.normal();
  part.ball.center = half_space.offset() / part.magnitude.squaredNorm() * part.magnitude;
  part.ball.radius = part.reach = part.core_reach = kInfinity;
  part.turned_magnitude = kInfinity;
  body.ball = part.ball;
  body.reach = body.core_reach = kInfinity;
  body.parts.push_back(std::move(part));
}

}  // namespace

BoundingBall bounding_ball(const ConvexSet& S) {
  const int n = S.dimension();
  BoundingBall ball{SmallVector(n), 0};
  if (const Mesh* mesh = as_mesh(S)) {
    ball = ball_of(*mesh);
    ball.radius = ball.radius * kOutward + kUnderflow;
    return ball;
  }
  SmallVector u = SmallVector::Zero(n), half(n), point(n), magnitude(n);
  for (int k = 0; k < n; ++k) {
    u[k] = 1;
    const double above = S.support_unchecked(u.data(), point.data());
    u[k] = -1;
    const double below = -S.support_unchecked(u.data(), point.data());
    u[k] = 0;
    ball.center[k] = below + (above - below) / 2;
    half[k] = (above - below) / 2;
  }
  S.magnitude_unchecked(magnitude.data());
  ball.radius = half.norm();
  if (const PointSet* points = as_point_set(S)) {
    ball.radius = radius_by_points(*points, ball.center);
  } else if (n == 3) {
    ball.radius = std::min(ball.radius, radius_by_directions(S, ball.center));
  }
  ball.radius = ball.radius * kOutward + rounding_of(magnitude);
  return ball;
}

double turned_magnitude(const SmallVector& magnitude) {
  return 2 * std::sqrt(static_cast<double>(magnitude.size())) * magnitude.norm() * kOutward;
}

Body make_body(std::string name, const std::vector<std::shared_ptr<const ConvexSet>>& parts,
               MotionPointer motion) {
  if (parts.empty()) throw EmptySetError("body '" + name + "' has no part");
  if (motion == nullptr) throw InvalidParameterError("body '" + name + "' has no motion");
  Body body;
  body.name = std::move(name);
  body.motion = std::move(motion);
  const int n = body.dimension();
  SmallVector sum = SmallVector::Zero(n);
  for (const auto& given : parts) {
    const auto set = prepared_if_it_pays(given);
    if (set == nullptr) throw InvalidParameterError("body '" + body.name + "': a part is null");
    if (set->dimension() != n) {
      throw DimensionMismatchError("body '" + body.name + "': a part lives in R^" +
                                   std::to_string(set->dimension()) + ", the motion in R^" +
                                   std::to_string(n));
    }
    if (const HalfSpace* half_space = as_half_space(*set)) {
      if (parts.size() > 1)
        throw InvalidParameterError("body '" + body.name + "': a half-space must be its only part");
      take_half_space(set, *half_space, body);
      return body;
    }
    BodyPart part;
    part.set = set;
    part.ball = bounding_ball(*set);
    part.reach = (part.ball.center.norm() + part.ball.radius) * kOutward;
    part.core_reach = reach_of_core(*set, part.reach);
    part.magnitude.resize(n);
    measure(*set, part.magnitude);
    part.turned_magnitude = turned_magnitude(part.magnitude);
    body.core_reach = std::max(body.core_reach, part.core_reach);
    body.reach = std::max(body.reach, part.reach);
    sum += part.ball.center;
    body.parts.push_back(std::move(part));
  }
  enclose(body, sum / static_cast<double>(parts.size()));
  return body;
}

}  // namespace raygauge
