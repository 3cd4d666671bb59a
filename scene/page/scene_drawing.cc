// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/page/scene_drawing.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "engine/meshes/box_tree.h"
#include "raygauge/meshes/mesh.h"
#include "scene/page/plane_patch.h"
#include "scene/page/support_mesh.h"

namespace raygauge::cli {
namespace {

using nlohmann::json;

// Enough for a smooth film, few enough for a page.
constexpr std::size_t kMostPoses = 30'000;
constexpr std::size_t kMostFrames = 400;
// Of all bodies together, and of one part.
constexpr std::size_t kMostVertices = 24'000;
constexpr std::size_t kMostOfPart = 1200;
constexpr std::size_t kFewestOfPart = 60;
// Of the size of a part: how far its surface may lie from the picture's.
constexpr double kFineness = 1e-3;

/// Six significant digits: more than a screen shows.
double short_number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return std::strtod(text, nullptr);
}

json polygon_of(const ConvexSet& set, std::size_t most) {
  json vertices = json::array();
  for (const Eigen::Vector2d& p : support_polygon(set, kFineness, most))
    for (const double x : p) vertices.push_back(short_number(x));
  return {{"vertices", vertices}};
}

json mesh_of(const ConvexSet& set, std::size_t most) {
  const SupportMesh mesh = support_mesh(set, kFineness, most);
  json vertices = json::array();
  for (const Eigen::Vector3d& p : mesh.vertices)
    for (const double x : p) vertices.push_back(short_number(x));
  json triangles = json::array();
  for (const auto& triangle : mesh.triangles)
    for (const int corner : triangle) triangles.push_back(corner);
  return {{"vertices", vertices}, {"triangles", triangles}};
}

/// The triangles of a mesh, the largest ones of very many.
json triangles_of(const Mesh& mesh) {
  constexpr std::int32_t kMostTriangles = 20'000;
  std::vector<std::pair<double, std::int32_t>> order;
  for (std::int32_t i = 0; i < mesh.size(); ++i)
    order.emplace_back(-length(mesh.tree().triangle(i).normal()), i);
  if (mesh.size() > kMostTriangles) {
    std::nth_element(order.begin(), order.begin() + kMostTriangles, order.end());
    order.resize(kMostTriangles);
  }
  json vertices = json::array(), triangles = json::array();
  for (const auto& [size, i] : order) {
    for (const Vector3& p : mesh.tree().triangle(i).corner) {
      triangles.push_back(triangles.size());
      for (const double x : {p.x, p.y, p.z}) vertices.push_back(short_number(x));
    }
  }
  return {{"vertices", vertices}, {"triangles", triangles}};
}

/// Balls of a cloud as octahedra, some of very many.
json balls_of(const Mesh& cloud) {
  constexpr std::int32_t kMostBalls = 2'500;
  constexpr int kFaces[8][3] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  const auto step = static_cast<std::int32_t>((cloud.size() + kMostBalls - 1) / kMostBalls);
  json vertices = json::array(), triangles = json::array();
  std::int32_t first = 0;
  for (std::int32_t i = 0; i < cloud.size(); i += step, first += 6) {
    const Vector3& p = cloud.tree().triangle(i).corner[0];
    for (int c = 0; c < 6; ++c) {
      double x[3] = {p.x, p.y, p.z};
      x[c / 2] += c % 2 == 0 ? cloud.radius() : -cloud.radius();
      for (const double coordinate : x) vertices.push_back(short_number(coordinate));
    }
    for (const auto& face : kFaces)
      for (const int corner : face) triangles.push_back(first + corner);
  }
  return {{"vertices", vertices}, {"triangles", triangles}};
}

json pose_of(const Placement& where) {
  json pose = json::array();
  for (Eigen::Index k = 0; k < where.t.size(); ++k) pose.push_back(short_number(where.t[k]));
  for (Eigen::Index i = 0; i < where.R.size(); ++i) pose.push_back(short_number(where.R.data()[i]));
  return pose;
}

}  // namespace

std::string drawing_of(const Scene& scene) {
  const int n = scene.dimension();
  if (n != 2 && n != 3) return {};
  std::size_t parts = 0;
  for (const Body& body : scene.bodies) parts += body.parts.size();
  const std::size_t detail =
      std::clamp(kMostVertices / std::max<std::size_t>(1, parts), kFewestOfPart, kMostOfPart);
  const std::size_t instants = scene.instants.size();
  const std::size_t most = std::max<std::size_t>(2, std::min(kMostFrames, kMostPoses / scene.bodies.size()));
  const std::size_t step = (instants + most - 1) / most;
  json times = json::array();
  for (std::size_t k = 0; k < instants; k += step) times.push_back(scene.instants[k]);
  json bodies = json::array();
  for (const Body& body : scene.bodies) {
    json shapes = json::array();
    for (const BodyPart& part : body.parts) {
      if (const HalfSpace* half_space = as_half_space(*part.set)) {
        shapes.push_back(plane_patch(scene, body, *half_space));
        continue;
      }
      if (const Mesh* mesh = as_mesh(*part.set)) {
        shapes.push_back(mesh->kind() == MeshKind::cloud ? balls_of(*mesh) : triangles_of(*mesh));
        continue;
      }
      shapes.push_back(n == 2 ? polygon_of(*part.set, detail) : mesh_of(*part.set, detail));
    }
    json poses = json::array();
    for (std::size_t k = 0; k < instants; k += step) {
      poses.push_back(pose_of(body.motion->at(scene.instants[k])));
      if (body.motion->is_static()) break;
    }
    bodies.push_back({{"name", body.name}, {"parts", shapes}, {"poses", poses}});
  }
  return json{{"dimension", n}, {"times", times}, {"bodies", bodies}}.dump();
}

}  // namespace raygauge::cli
