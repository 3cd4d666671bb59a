// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/output/scene_drawing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "raygauge/scene/timeline.h"

namespace raygauge::cli {
namespace {

using nlohmann::json;
using Triangle = std::array<int, 3>;

// Enough for a smooth film, few enough for a page.
constexpr std::size_t kMostPoses = 30'000;
constexpr std::size_t kMostFrames = 400;
constexpr std::size_t kPartsInDetail = 40;

/// Six significant digits: more than a screen shows.
double short_number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return std::strtod(text, nullptr);
}

struct Sphere {
  std::vector<Eigen::Vector3d> directions;
  std::vector<Triangle> triangles;
};

/// An octahedron whose triangles are cut into four, `levels` times: 4^(levels+1) + 2 directions. The axes are
/// among them, so that boxes come out as they are.
Sphere sphere(int levels) {
  Sphere sphere;
  for (int k = 0; k < 3; ++k) {
    sphere.directions.emplace_back(Eigen::Vector3d::Unit(k));
    sphere.directions.emplace_back(-Eigen::Vector3d::Unit(k));
  }
  sphere.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int i, int j) {
      const auto [found, added] = middles.try_emplace({std::min(i, j), std::max(i, j)}, 0);
      if (added) {
        found->second = static_cast<int>(sphere.directions.size());
        sphere.directions.push_back(
            (sphere.directions[static_cast<std::size_t>(i)] + sphere.directions[static_cast<std::size_t>(j)])
                .normalized());
      }
      return found->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : sphere.triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const Triangle& part :
           {Triangle{a, ab, ca}, Triangle{ab, b, bc}, Triangle{ca, bc, c}, Triangle{ab, bc, ca}}) {
        finer.push_back(part);
      }
    }
    sphere.triangles = std::move(finer);
  }
  return sphere;
}

/// Numbers of support points, each distinct one once.
class Vertices {
 public:
  int number(const SmallVector& point) {
    std::vector<double> key;
    for (Eigen::Index k = 0; k < point.size(); ++k) key.push_back(short_number(point[k]));
    const auto [found, added] = numbers_.try_emplace(key, static_cast<int>(numbers_.size()));
    if (added) {
      for (const double x : key) list.push_back(x);
    }
    return found->second;
  }

  json list = json::array();

 private:
  std::map<std::vector<double>, int> numbers_;
};

SmallVector support_point(const ConvexSet& set, const SmallVector& u) {
  SmallVector point(u.size());
  set.support_unchecked(u.data(), point.data());
  return point;
}

json polygon_of(const ConvexSet& set) {
  constexpr int kDirections = 180;
  Vertices vertices;
  for (int i = 0; i < kDirections; ++i) {
    SmallVector u(2);
    const double angle = 2 * EIGEN_PI * (i + 0.5) / kDirections;
    u << std::cos(angle), std::sin(angle);
    vertices.number(support_point(set, u));
  }
  return {{"vertices", vertices.list}};
}

json mesh_of(const ConvexSet& set, const Sphere& sphere) {
  Vertices vertices;
  std::vector<int> number;
  for (const Eigen::Vector3d& u : sphere.directions) {
    // Off the axes by a little: at a box's normals a whole face would tie.
    number.push_back(vertices.number(support_point(set, SmallVector(u + Eigen::Vector3d(1e-4, 2e-4, 3e-4)))));
  }
  json triangles = json::array();
  for (const auto& [a, b, c] : sphere.triangles) {
    const std::array<int, 3> corner = {number[static_cast<std::size_t>(a)],
                                       number[static_cast<std::size_t>(b)],
                                       number[static_cast<std::size_t>(c)]};
    if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
    for (const int k : corner) triangles.push_back(k);
  }
  return {{"vertices", vertices.list}, {"triangles", triangles}};
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
  const Sphere directions = sphere(parts > kPartsInDetail ? 2 : 4);
  const std::size_t instants = scene.instants.size();
  const std::size_t most = std::max<std::size_t>(2, std::min(kMostFrames, kMostPoses / scene.bodies.size()));
  const std::size_t step = (instants + most - 1) / most;
  json times = json::array();
  for (std::size_t k = 0; k < instants; k += step) times.push_back(scene.instants[k]);
  json bodies = json::array();
  for (const Body& body : scene.bodies) {
    json shapes = json::array();
    for (const BodyPart& part : body.parts) {
      shapes.push_back(n == 2 ? polygon_of(*part.set) : mesh_of(*part.set, directions));
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
