// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/meshes/wide_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/meshes/box_split.h"
#include "engine/meshes/box_tree.h"
#include "tests/engine/meshes/mesh_shapes.h"

namespace raygauge::test_wide_tree {
namespace {

using namespace testing;

// Every triangle is in one block, about the centre of its box; the boxes are those of the BoxTree.
class Walk {
 public:
  explicit Walk(const BoxTree& tree) : tree_(tree), seen_(static_cast<std::size_t>(tree.size())) {}

  void look(std::int32_t box, std::int32_t wide) {
    if (WideTree::is_block(wide)) return look_at_block(box, tree_.wide().block(wide));
    const WideNode& node = tree_.wide().node(wide);
    ASSERT_GE(node.count, 2);
    ASSERT_LE(node.count, BoxLanes::kCount);
    ++nodes;
    children += node.count;
    for (int lane = 0; lane < node.count; ++lane) {
      const BoxNode& same = tree_.node(node.box[lane]);
      for (int k = 0; k < 3; ++k) {
        ASSERT_EQ(node.boxes.center[k][lane], same.center[k]);
        ASSERT_EQ(node.boxes.half[k][lane], same.half[k]);
        for (int i = 0; i < 3; ++i) ASSERT_EQ(node.boxes.axis[k][i][lane], same.axis[k][i]);
      }
      look(node.box[lane], node.wide[lane]);
    }
  }

  bool saw_all_once() const { return std::count(seen_.begin(), seen_.end(), 1) == std::ssize(seen_); }

  int nodes = 0, children = 0;

 private:
  void look_at_block(std::int32_t box, const TriangleBlock& block) {
    const TriangleRange range = tree_.triangles_of(box);
    ASSERT_LE(range.end - range.begin, WideTree::kBlock);
    const BoxNode& node = tree_.node(box);
    for (std::int32_t lane = 0; lane < WideTree::kBlock; ++lane) {
      const std::int32_t t = std::min(range.begin + lane, range.end - 1);
      if (t == range.begin + lane) ++seen_[static_cast<std::size_t>(t)];
      for (int c = 0; c < 3; ++c) {
        const Vector3& p = tree_.triangle(t).corner[c];
        EXPECT_EQ(block.corner[c][0][lane], static_cast<float>(p.x - double{node.center[0]}));
        EXPECT_EQ(block.corner[c][1][lane], static_cast<float>(p.y - double{node.center[1]}));
        EXPECT_EQ(block.corner[c][2][lane], static_cast<float>(p.z - double{node.center[2]}));
      }
    }
  }

  const BoxTree& tree_;
  std::vector<int> seen_;
};

TEST(WideTree, HasEveryTriangleInOneBlock) {
  for (const auto& [k, l] : {std::pair{3, 3}, {4, 3}, {8, 5}, {30, 17}, {64, 32}, {120, 77}}) {
    const MeshShape torus = torus_shape(3, 1, k, l);
    const BoxTree tree(torus.vertices, torus.triangles, 1);
    Walk walk(tree);
    walk.look(0, tree.wide().root());
    EXPECT_TRUE(walk.saw_all_once()) << k << ' ' << l;
    EXPECT_TRUE(torus.triangles.size() < 1000 || walk.children > 5 * walk.nodes) << k << ' ' << l;
  }
  const MeshShape box = box_shape(kZero, kOne);
  const BoxTree one(box.vertices, {box.triangles.data(), 7}, 1);
  EXPECT_TRUE(WideTree::is_block(one.wide().root()));
}

SplitItem item(float x, float half) { return {{x, 0, 0}, {half, half, half}, 0}; }

TEST(BoxSplit, CutsWhereThereIsAGap) {
  for (const int others : {16, 32, 200}) {
    std::vector<SplitItem> items;
    for (int i = 0; i < others; ++i) items.push_back(item(10 + 0.01F * static_cast<float>(i % 16), 0.1F));
    for (int i = 0; i < 8; ++i) items.push_back(item(0.01F * static_cast<float>(i), 0.1F));
    const BoxSplit split = best_split(items, 8);
    EXPECT_EQ(split.axis, 0) << others;
    EXPECT_EQ(split.first, 8) << others;
    EXPECT_EQ(middle_split(items, 8).first, (others + 8) / 16 * 8) << others;
  }
}

// One large triangle among small ones is cut off, though its centre is not apart.
TEST(BoxSplit, CountsTheSizesOfItems) {
  std::vector<SplitItem> items;
  for (int i = 0; i < 24; ++i) items.push_back(item(static_cast<float>(i), i >= 16 ? 50.0F : 0.1F));
  EXPECT_EQ(best_split(items, 8).first, 16);
}

TEST(BoxSplit, CutsWholeUnitsOfWhatIsInOnePlace) {
  for (const int count : {9, 20, 64, 65, 500}) {
    const std::vector<SplitItem> items(static_cast<std::size_t>(count), item(1, 0));
    const BoxSplit split = best_split(items, 8);
    EXPECT_EQ(split.first % 8, 0) << count;
    EXPECT_GT(split.first, 0) << count;
    EXPECT_LT(split.first, count) << count;
  }
}

}  // namespace
}  // namespace raygauge::test_wide_tree
