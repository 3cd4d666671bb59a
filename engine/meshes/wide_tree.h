// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/kernels/mesh_lanes.h"

namespace raygauge {

struct BoxNode;
struct TriangleCorners;

/// Up to eight descendants of a box of a BoxTree that hold its triangles between them.
struct WideNode {
  BoxLanes boxes;
  std::int32_t box[BoxLanes::kCount];   ///< their nodes in the BoxTree
  std::int32_t wide[BoxLanes::kCount];  ///< what is in them: see WideTree
  std::int32_t count;
};

/// The boxes of a BoxTree again, some levels at once, for kernels that look at eight of them together, and
/// its triangles in single precision, in blocks of up to eight about the centres of their boxes. Nodes near
/// the root may be the ones that are not full.
///
/// What is in a box is the node of a number i >= 0, or a block, of number ~i.
class WideTree {
 public:
  static constexpr std::ptrdiff_t kBlock = TriangleBlock::kCount;

  /// Of all nodes and triangles of the BoxTree.
  void build(std::span<const BoxNode> nodes, std::span<const TriangleCorners> triangles);

  static bool is_block(std::int32_t i) noexcept { return i < 0; }
  const WideNode& node(std::int32_t i) const noexcept { return nodes_[static_cast<std::size_t>(i)]; }
  const TriangleBlock& block(std::int32_t i) const noexcept {
    const std::int32_t place = ~i;
    return blocks_[static_cast<std::size_t>(place)];
  }

  /// What is in the box of all triangles.
  std::int32_t root() const noexcept { return nodes_.empty() ? ~0 : 0; }

  std::ptrdiff_t memory() const noexcept {
    return static_cast<std::ptrdiff_t>(nodes_.capacity() * sizeof(WideNode) +
                                       blocks_.capacity() * sizeof(TriangleBlock));
  }

 private:
  struct Part;
  struct Source;
  std::int32_t add(const Source& source, const Part& part);
  std::int32_t add_block(const Source& source, const Part& part);

  std::vector<WideNode> nodes_;
  std::vector<TriangleBlock> blocks_;
};

}  // namespace raygauge
