// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "raygauge/scene/scene.h"

namespace raygauge {

/// A ball around some parts of a body: one part, or those of two other nodes.
struct PartNode {
  BoundingBall ball;
  int part = -1;                ///< -1: more than one
  int first = -1, second = -1;  ///< nodes
};

/// A binary tree of balls around the parts of a body, cut across the longest side of the box of their
/// centres, half of them to either side. Node 0 holds all parts.
class PartTree {
 public:
  /// Fewer parts are not worth a tree.
  static constexpr std::size_t kFewest = 8;

  explicit PartTree(const std::vector<BodyPart>& parts);

  const PartNode& node(int i) const noexcept { return nodes_[static_cast<std::size_t>(i)]; }
  int size() const noexcept { return static_cast<int>(nodes_.size()); }

 private:
  int build(const std::vector<BodyPart>& parts, std::vector<int>& order, std::size_t begin, std::size_t end);

  std::vector<PartNode> nodes_;
};

/// Node i of the tree of a body. Of a body without a tree node 0 holds all parts, node i + 1 part i; of a
/// body of one part node 0 is that.
PartNode part_node(const Body& body, int i);

/// use(child) for the children of a node of several parts.
template <class Use>
void for_each_child(const Body& body, const PartNode& node, const Use& use) {
  if (body.tree != nullptr) {
    use(node.first);
    use(node.second);
    return;
  }
  for (int i = 1; i <= static_cast<int>(body.parts.size()); ++i) use(i);
}

}  // namespace raygauge
