// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/page/plane_patch.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "engine/numerics/floating_point.h"

namespace raygauge::cli {
namespace {

constexpr std::size_t kLooks = 64;    // at the way of each body
constexpr double kBeyond = 0.75;      // of the size of the scene: half an edge of the patch
constexpr double kThickness = 0.06;   // of a strip
constexpr double kSmallest = 1e-300;  // of a scene of one point

/// The box of the balls of all bounded bodies on their ways.
Eigen::AlignedBox<double, Eigen::Dynamic> box_of(const Scene& scene) {
  Eigen::AlignedBox<double, Eigen::Dynamic> box(scene.dimension());
  const std::size_t step = scene.instants.size() / kLooks + 1;
  for (const Body& body : scene.bodies) {
    if (!body.is_bounded()) continue;
    for (std::size_t k = 0; k < scene.instants.size(); k += step) {
      const Placement at = body.motion->at(scene.instants[k]);
      const Eigen::VectorXd center = at.turned(body.ball.center) + at.t;
      box.extend(Eigen::VectorXd(center.array() - body.ball.radius));
      box.extend(Eigen::VectorXd(center.array() + body.ball.radius));
    }
  }
  if (box.isEmpty()) box.extend(Eigen::VectorXd(Eigen::VectorXd::Zero(scene.dimension())));
  return box;
}

}  // namespace

nlohmann::json plane_patch(const Scene& scene, const Body& body, const HalfSpace& half_space) {
  const auto box = box_of(scene);
  const double diagonal = box.sizes().norm(), half = diagonal > kSmallest ? kBeyond * diagonal : 1.0;
  const Placement at = body.motion->at(scene.instants.front());
  const SmallVector middle = at.turned_back(SmallVector(box.center()) - at.t);
  const SmallVector n = half_space.normal() / half_space.normal().norm();
  const double offset = half_space.offset() / half_space.normal().norm();
  const SmallVector foot = middle - (n.dot(middle) - offset) * n;
  std::vector<SmallVector> corners;
  std::vector<int> triangles;
  if (scene.dimension() == 2) {
    const SmallVector along = half * Eigen::Vector2d(-n[1], n[0]);
    const SmallVector down = -kThickness * half * n;
    corners = {foot + along, foot + along + down, foot - along + down, foot - along};
  } else {
    const Eigen::Vector3d e = Eigen::Vector3d(n).unitOrthogonal(), f = Eigen::Vector3d(n).cross(e);
    const SmallVector a = half * e, b = half * f;
    corners = {foot - a - b, foot + a - b, foot + a + b, foot - a + b};
    triangles = {0, 1, 2, 0, 2, 3};
  }
  nlohmann::json vertices = nlohmann::json::array();
  for (const SmallVector& corner : corners)
    for (const double x : corner) vertices.push_back(x);
  return {{"vertices", vertices}, {"triangles", triangles}, {"plane", true}};
}

}  // namespace raygauge::cli
