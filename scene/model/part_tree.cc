// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/model/part_tree.h"

#include <algorithm>
#include <numeric>

#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

constexpr double kOutward = 1 + 1e-13;

const BoundingBall& ball_of(const std::vector<BodyPart>& parts, int i) {
  return parts[static_cast<std::size_t>(i)].ball;
}

}  // namespace

PartTree::PartTree(const std::vector<BodyPart>& parts) {
  std::vector<int> order(parts.size());
  std::iota(order.begin(), order.end(), 0);
  nodes_.reserve(2 * parts.size());
  build(parts, order, 0, order.size());
}

int PartTree::build(const std::vector<BodyPart>& parts, std::vector<int>& order, std::size_t begin,
                    std::size_t end) {
  const int number = size();
  nodes_.emplace_back();
  if (end - begin == 1) {
    nodes_.back().part = order[begin];
    nodes_.back().ball = ball_of(parts, order[begin]);
    return number;
  }
  SmallVector low = ball_of(parts, order[begin]).center, high = low;
  for (std::size_t k = begin; k < end; ++k) {
    low = low.cwiseMin(ball_of(parts, order[k]).center);
    high = high.cwiseMax(ball_of(parts, order[k]).center);
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  BoundingBall ball{low + (high - low) / 2, 0};
  for (std::size_t k = begin; k < end; ++k) {
    const BoundingBall& own = ball_of(parts, order[k]);
    ball.radius = std::max(ball.radius, ((own.center - ball.center).norm() + own.radius) * kOutward);
  }
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t k) { return order.begin() + static_cast<std::ptrdiff_t>(k); };
  std::nth_element(at(begin), at(middle), at(end), [&](int i, int j) {
    const double x = ball_of(parts, i).center[axis], y = ball_of(parts, j).center[axis];
    return x != y ? x < y : i < j;
  });
  const int first = build(parts, order, begin, middle), second = build(parts, order, middle, end);
  nodes_[static_cast<std::size_t>(number)] = {ball, -1, first, second};
  return number;
}

PartNode part_node(const Body& body, int i) {
  if (body.tree != nullptr) return body.tree->node(i);
  if (body.parts.size() == 1) return {body.parts.front().ball, 0, -1, -1};
  if (i == 0) return {body.ball, -1, -1, -1};
  return {body.parts[static_cast<std::size_t>(i - 1)].ball, i - 1, -1, -1};
}

}  // namespace raygauge
