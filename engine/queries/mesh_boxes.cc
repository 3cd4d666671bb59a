// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// The search of a MeshSearch for the triangle that is nearest to a body or a half-space, and for those of two
// meshes whose sizes are beyond the range of single precision: pairs of boxes one by one, in double.
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/numerics/floating_point.h"
#include "engine/queries/mesh_search.h"

namespace raygauge {
namespace {

// Wide enough for axes that are orthonormal to BoxNode::kAxisError.
constexpr double kOfAxes = 1 - 4 * BoxNode::kAxisError;

constexpr std::int64_t kLooksPerReading = 64;  // of the clock: a look takes at most some microseconds

}  // namespace

void MeshSearch::search_boxes() {
  open_.clear();
  push(0, 0);
  while (!open_.empty() && !meets_) {
    const OpenPair pair = open_.back();
    open_.pop_back();
    if (is_beyond(pair.lower)) {
      passed_over_ = true;
      continue;
    }
    if (++looks_ % kLooksPerReading == 0 && watch_.expired()) {
      note_out_of_time(pair.lower);
      for (const OpenPair& other : open_) note_out_of_time(other.lower);
      break;
    }
    expand(pair);
  }
}

void MeshSearch::push(std::int32_t one, std::int32_t two) {
  ++counters_.box_pairs;
  const BoxNode &a = first_->tree().node(one), &b = other_.node(two);
  const double lower = std::max(other_.is_half_space ? -kInfinity : box_distance(a, b), plane_distance(a));
  if (is_beyond(lower)) {
    passed_over_ = true;
    return;
  }
  open_.push_back({one, two, lower});
}

// The larger box is opened; of its halves the nearer one is taken first.
void MeshSearch::expand(const OpenPair& pair) {
  const BoxNode &a = first_->tree().node(pair.one), &b = other_.node(pair.two);
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

void MeshSearch::look_at_leaves(const BoxNode& one, const BoxNode& two) {
  for (std::int32_t k = two.next; k < two.next + two.count; ++k) {
    turn_second(k);
    for (std::int32_t i = one.next; i < one.next + one.count && !meets_; ++i) look_at(i, k);
  }
}

// The distance of two boxes is at least that of one and of a box along its axes around the other.
double MeshSearch::box_distance(const BoxNode& one, const BoxNode& two) const noexcept {
  const Vector3 d = R_ * vector_of(two.center) + t_ - vector_of(one.center);
  const Vector3 e = R_.transposed_times(d);
  double wide_1[3] = {0, 0, 0}, wide_2[3] = {double{two.half[0]}, double{two.half[1]}, double{two.half[2]}};
  double apart_1[3], apart_2[3];
  Vector3 turned[3];
  for (int k = 0; k < 3; ++k) {
    const Vector3 axis = vector_of(two.axis[k]);
    turned[k] = R_ * axis;
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
  return std::sqrt(std::max(square_1, square_2)) * kOfAxes - radii_;
}

double MeshSearch::plane_distance(const BoxNode& one) const noexcept {
  if (!has_plane_) return -kInfinity;
  double top = dot(plane_, vector_of(one.center));
  for (int k = 0; k < 3; ++k) top += std::fabs(dot(plane_, vector_of(one.axis[k]))) * double{one.half[k]};
  return plane_of_ - top - radius_1_;
}

}  // namespace raygauge
