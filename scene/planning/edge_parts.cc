// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/planning/edge_parts.h"

#include <algorithm>
#include <string>
#include <utility>

#include "raygauge/exceptions.h"
#include "raygauge/meshes/mesh.h"

namespace raygauge {
namespace {

const Mesh* mesh_of(const EdgeShape& shape) { return as_mesh(*shape.part->set); }

bool is_solid(const Mesh* mesh) { return mesh != nullptr && mesh->kind() == MeshKind::solid; }

void check_pair(const std::pair<int, int>& pair, int bodies) {
  for (const int i : {pair.first, pair.second}) {
    if (i < 0 || i >= bodies) throw InvalidParameterError("there is no body number " + std::to_string(i));
  }
}

// The links above both bodies of a robot.
void take_carrier(const RobotChain& chain, const EdgeBody& a, const EdgeBody& b, EdgePair& pair) {
  const std::vector<int>&one = chain.path(a.link), &two = chain.path(b.link);
  std::size_t common = 0;
  while (common < std::min(one.size(), two.size()) && one[common] == two[common]) ++common;
  if (common > 0) pair.carrier = one[common - 1];
  pair.left_out_a = pair.left_out_b = common;
}

}  // namespace

EdgePairs::EdgePairs(const RobotModel& robot, const RobotChain& chain, const std::vector<EdgeBody>& bodies) {
  take_pairs(robot, chain, bodies);
  take_parts(bodies);
}

void EdgePairs::take_pairs(const RobotModel& robot, const RobotChain& chain,
                           const std::vector<EdgeBody>& bodies) {
  const auto count = static_cast<int>(bodies.size());
  std::vector<std::pair<int, int>> ignored;
  for (const std::pair<int, int>& pair : robot.ignored) {
    check_pair(pair, count);
    ignored.emplace_back(std::minmax(pair.first, pair.second));
  }
  std::sort(ignored.begin(), ignored.end());
  for (int a = 0; a < static_cast<int>(robot.bodies.size()); ++a) {
    for (int b = a + 1; b < count; ++b) {
      if (std::binary_search(ignored.begin(), ignored.end(), std::pair(a, b))) continue;
      EdgePair pair{a, b};
      const EdgeBody& other = bodies[static_cast<std::size_t>(b)];
      if (!other.is_obstacle()) take_carrier(chain, bodies[static_cast<std::size_t>(a)], other, pair);
      pairs_.push_back(pair);
    }
  }
}

void EdgePairs::take_parts(const std::vector<EdgeBody>& bodies) {
  for (int i = 0; i < size(); ++i) {
    first_parts_.push_back(static_cast<int>(parts_.size()));
    const EdgeBody& one = bodies[static_cast<std::size_t>(pair(i).a)];
    const EdgeBody& other = bodies[static_cast<std::size_t>(pair(i).b)];
    for (std::size_t a = 1; a <= one.body.parts.size(); ++a) {
      for (std::size_t b = 1; b <= other.body.parts.size(); ++b) {
        EdgeParts& parts = parts_.emplace_back();
        parts.pair = i;
        parts.shape_a = a;
        parts.shape_b = b;
        const Mesh *mesh_a = mesh_of(one.shapes[a]), *mesh_b = mesh_of(other.shapes[b]);
        parts.is_mesh = mesh_a != nullptr || mesh_b != nullptr;
        parts.is_solid = is_solid(mesh_a) || is_solid(mesh_b);
      }
    }
  }
  first_parts_.push_back(static_cast<int>(parts_.size()));
}

void EdgePairs::forget() {
  for (EdgeParts& parts : parts_) {
    parts.memory = PartMemory();
    parts.plane.setZero();
  }
}

}  // namespace raygauge
