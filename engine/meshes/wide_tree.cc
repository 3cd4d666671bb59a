// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/meshes/wide_tree.h"

#include <algorithm>

#include "engine/meshes/box_tree.h"

namespace raygauge {
namespace {

std::ptrdiff_t blocks_of(std::ptrdiff_t triangles) {
  return (triangles + WideTree::kBlock - 1) / WideTree::kBlock;
}

void set_lane(BoxLanes& boxes, int lane, const BoxNode& box) {
  for (int k = 0; k < 3; ++k) {
    boxes.center[k][lane] = box.center[k];
    boxes.half[k][lane] = box.half[k];
    for (int i = 0; i < 3; ++i) boxes.axis[k][i][lane] = box.axis[k][i];
  }
}

}  // namespace

/// Triangles [begin, begin + size) and their node in the BoxTree.
struct WideTree::Part {
  std::int32_t node = 0;
  std::ptrdiff_t begin = 0, size = 0;
};

struct WideTree::Source {
  std::span<const BoxNode> nodes;
  std::span<const TriangleCorners> triangles;

  const BoxNode& node(const Part& part) const { return nodes[static_cast<std::size_t>(part.node)]; }

  // Its first child; the other one has the rest. A first child's leaves are full, 2 n - 1 nodes for n of
  // them.
  Part first_of(const Part& part) const {
    return {part.node + 1, part.begin, (node(part).next - part.node) / 2 * BoxTree::kLeaf};
  }

  // Parts of a part: the largest is cut until they fit into full nodes of fewer levels or there are eight.
  int cut(const Part& part, Part* parts) const {
    std::ptrdiff_t fitting = kBlock;
    while (fitting * BoxLanes::kCount < part.size) fitting *= BoxLanes::kCount;
    int count = 0;
    parts[count++] = part;
    while (count < BoxLanes::kCount) {
      Part* const largest = std::max_element(parts, parts + count,
                                             [](const Part& a, const Part& b) { return a.size < b.size; });
      if (largest->size <= fitting) break;
      const Part first = first_of(*largest);
      parts[count++] = {node(*largest).next, first.begin + first.size, largest->size - first.size};
      *largest = first;
    }
    return count;
  }
};

void WideTree::build(std::span<const BoxNode> nodes, std::span<const TriangleCorners> triangles) {
  blocks_.reserve(static_cast<std::size_t>(blocks_of(std::ssize(triangles))));
  add({nodes, triangles}, {0, 0, std::ssize(triangles)});
  nodes_.shrink_to_fit();
}

std::int32_t WideTree::add(const Source& source, const Part& part) {
  if (part.size <= kBlock) return add_block(source, part);
  const std::size_t place = nodes_.size();
  nodes_.emplace_back();
  Part parts[BoxLanes::kCount];
  const int count = source.cut(part, parts);
  for (int lane = 0; lane < count; ++lane) {
    const std::int32_t wide = add(source, parts[lane]);
    WideNode& node = nodes_[place];
    set_lane(node.boxes, lane, source.node(parts[lane]));
    node.box[lane] = parts[lane].node;
    node.wide[lane] = wide;
  }
  nodes_[place].count = count;
  return static_cast<std::int32_t>(place);
}

// Lanes beyond the last triangle repeat it.
std::int32_t WideTree::add_block(const Source& source, const Part& part) {
  TriangleBlock block{};
  const float* center = source.node(part).center;
  for (std::ptrdiff_t lane = 0; lane < kBlock; ++lane) {
    const auto i = static_cast<std::size_t>(part.begin + std::min(lane, part.size - 1));
    for (int c = 0; c < 3; ++c) {
      const Vector3& p = source.triangles[i].corner[c];
      block.corner[c][0][lane] = static_cast<float>(p.x - double{center[0]});
      block.corner[c][1][lane] = static_cast<float>(p.y - double{center[1]});
      block.corner[c][2][lane] = static_cast<float>(p.z - double{center[2]});
    }
  }
  blocks_.push_back(block);
  return ~static_cast<std::int32_t>(blocks_.size() - 1);
}

}  // namespace raygauge
