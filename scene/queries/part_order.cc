// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/queries/part_order.h"

#include <algorithm>

#include "scene/model/part_tree.h"

namespace raygauge {
namespace {

constexpr std::size_t kSorted = 64;  // pairs: of fewer a tree saves nothing

}  // namespace

void PartOrder::bind(const Body& a, const Body& b) {
  a_ = &a;
  b_ = &b;
  all_.clear();
  trees_ = a.parts.size() * b.parts.size() > kSorted && (a.tree != nullptr || b.tree != nullptr);
  if (trees_) return;
  for (int i = 0; i < static_cast<int>(a.parts.size()); ++i) {
    for (int j = 0; j < static_cast<int>(b.parts.size()); ++j) all_.push_back({{i, j}, 0});
  }
}

void PartOrder::begin(const PlacedPair& placed, std::int64_t& tests) {
  placed_ = &placed;
  tests_ = &tests;
  next_ = 0;
  heap_.clear();
  if (trees_) return push(0, 0, 0);
  if (all_.size() == 1) return;
  for (PartCandidate& candidate : all_) {
    candidate.ball_bound = placed.part_ball_bound(candidate.parts);
    ++*tests_;
  }
  std::sort(all_.begin(), all_.end(), [](const PartCandidate& x, const PartCandidate& y) {
    if (x.ball_bound != y.ball_bound) return x.ball_bound < y.ball_bound;
    return x.parts.a != y.parts.a ? x.parts.a < y.parts.a : x.parts.b < y.parts.b;
  });
}

// Nodes that may hold a pair that comes before others of the same bound are opened first.
bool PartOrder::later(const Entry& x, const Entry& y) noexcept {
  if (x.bound != y.bound) return x.bound > y.bound;
  if (x.is_pair != y.is_pair) return x.is_pair;
  return x.a != y.a ? x.a > y.a : x.b > y.b;
}

// What is within nodes is no nearer than they are.
void PartOrder::push(int node_a, int node_b, double least) {
  const PartNode a = part_node(*a_, node_a), b = part_node(*b_, node_b);
  ++*tests_;
  Entry entry{std::max(least, placed_->bound_of_balls(a.ball, b.ball)), node_a, node_b, false};
  if (a.part >= 0 && b.part >= 0) entry = {entry.bound, a.part, b.part, true};
  heap_.push_back(entry);
  std::push_heap(heap_.begin(), heap_.end(), later);
}

void PartOrder::open(const Entry& entry) {
  const PartNode a = part_node(*a_, entry.a), b = part_node(*b_, entry.b);
  if (b.part >= 0 || (a.part < 0 && a.ball.radius > b.ball.radius)) {
    for_each_child(*a_, a, [&](int child) { push(child, entry.b, entry.bound); });
  } else {
    for_each_child(*b_, b, [&](int child) { push(entry.a, child, entry.bound); });
  }
}

const PartCandidate* PartOrder::next() {
  if (!trees_) return next_ < all_.size() ? &all_[next_++] : nullptr;
  while (!heap_.empty()) {
    std::pop_heap(heap_.begin(), heap_.end(), later);
    const Entry entry = heap_.back();
    heap_.pop_back();
    if (!entry.is_pair) {
      open(entry);
      continue;
    }
    found_ = {{entry.a, entry.b}, entry.bound};
    return &found_;
  }
  return nullptr;
}

}  // namespace raygauge
