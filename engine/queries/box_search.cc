// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/box_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

// Wide enough for axes that are orthonormal to BoxNode::kAxisError.
constexpr double kOfAxes = 1 - 4 * BoxNode::kAxisError;

constexpr std::size_t kFirstRoom = 1024;
constexpr std::int64_t kLooksPerReading = 64;  // of the clock: a look takes at most some microseconds

}  // namespace

BoxSearch::BoxSearch(const Stopwatch& watch) : watch_(&watch) { open_.reserve(kFirstRoom); }

void BoxSearch::search(const MeshPair& pair, NearestTriangles& nearest) {
  pair_ = &pair;
  nearest_ = &nearest;
  looks_ = 0;
  open_.clear();
  push(0, 0);
  while (!open_.empty() && !nearest.found.meets) {
    const OpenPair next = open_.back();
    open_.pop_back();
    if (nearest.is_beyond(next.lower)) {
      nearest.pass_over();
      continue;
    }
    if (is_over(next)) break;
    expand(next);
  }
}

bool BoxSearch::is_over(const OpenPair& pair) {
  if (++looks_ % kLooksPerReading != 0 || !watch_->expired()) return false;
  nearest_->leave_open(pair.lower);
  for (const OpenPair& other : open_) nearest_->leave_open(other.lower);
  return true;
}

void BoxSearch::push(std::int32_t one, std::int32_t two) {
  ++nearest_->counters.box_pairs;
  const BoxNode &a = pair_->tree_1().node(one), &b = pair_->node_2(two);
  const double lower =
      std::max(pair_->half_space_2 != nullptr ? -kInfinity : box_distance(a, b), nearest_->plane_distance(a));
  if (nearest_->is_beyond(lower)) return nearest_->pass_over();
  open_.push_back({one, two, lower});
}

// The larger box is opened; of its halves the nearer one is taken first.
void BoxSearch::expand(const OpenPair& pair) {
  const BoxNode &a = pair_->tree_1().node(pair.one), &b = pair_->node_2(pair.two);
  if (a.is_leaf() && b.is_leaf()) return look_at_leaves(a, b);
  const std::size_t before = open_.size();
  if (b.is_leaf() || (!a.is_leaf() && a.size() > b.size())) {
    push(pair.one + 1, pair.two);
    push(a.next, pair.two);
  } else {
    push(pair.one, pair.two + 1);
    push(pair.one, b.next);
  }
  if (open_.size() == before + 2 && open_[before].lower < open_[before + 1].lower)
    std::swap(open_[before], open_[before + 1]);
}

void BoxSearch::look_at_leaves(const BoxNode& one, const BoxNode& two) {
  const bool body = pair_->mesh_2 == nullptr;
  for (std::int32_t k = two.next; k < two.next + two.count; ++k) {
    const TriangleCorners turned = body ? TriangleCorners{} : pair_->turned(k);
    for (std::int32_t i = one.next; i < one.next + one.count && !nearest_->found.meets; ++i)
      body ? nearest_->look_at_body(i) : nearest_->look_at(i, k, turned);
  }
}

// The distance of two boxes is at least that of one and of a box along its axes around the other.
double BoxSearch::box_distance(const BoxNode& one, const BoxNode& two) const noexcept {
  const Vector3 d = pair_->R * vector_of(two.center) + pair_->t - vector_of(one.center);
  const Vector3 e = pair_->R.transposed_times(d);
  double wide_1[3] = {0, 0, 0}, wide_2[3] = {double{two.half[0]}, double{two.half[1]}, double{two.half[2]}};
  double apart_1[3], apart_2[3];
  Vector3 turned[3];
  for (int k = 0; k < 3; ++k) {
    const Vector3 axis = vector_of(two.axis[k]);
    turned[k] = pair_->R * axis;
    apart_2[k] = std::fabs(dot(axis, e));
  }
  for (int j = 0; j < 3; ++j) {
    const Vector3 axis = vector_of(one.axis[j]);
    const double half = double{one.half[j]};
    apart_1[j] = std::fabs(dot(axis, d));
    wide_1[j] = half;
    for (int k = 0; k < 3; ++k) {
      const double share = std::fabs(dot(axis, turned[k]));
      wide_1[j] += share * double{two.half[k]};
      wide_2[k] += share * half;
    }
  }
  double square_1 = 0, square_2 = 0;
  for (int k = 0; k < 3; ++k) {
    const double gap_1 = std::max(apart_1[k] - wide_1[k], 0.0), gap_2 = std::max(apart_2[k] - wide_2[k], 0.0);
    square_1 += gap_1 * gap_1;
    square_2 += gap_2 * gap_2;
  }
  return std::sqrt(std::max(square_1, square_2)) * kOfAxes - pair_->radii;
}

}  // namespace raygauge
