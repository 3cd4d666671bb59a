// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/wide_search.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace raygauge {
namespace {

constexpr std::size_t kFirstRoom = 1024;
constexpr std::int64_t kLooksPerReading = 16;  // of the clock: a look takes some microseconds at most

// A number in single precision that is not below x >= 0.
float at_least(double x) { return static_cast<float>(x * (1 + 0x1p-22)); }

double sum_of_halves(const BoxNode& box) {
  return double{box.half[0]} + double{box.half[1]} + double{box.half[2]};
}

// Of a ball about the box and its centre.
double radius_of(const BoxNode& box) { return length(vector_of(box.half)) * (1 + 4 * BoxNode::kAxisError); }

void write(const Vector3& v, float* to) {
  to[0] = static_cast<float>(v.x);
  to[1] = static_cast<float>(v.y);
  to[2] = static_cast<float>(v.z);
}

// Lengths along the axes of the box, of points of the frame that (R, t) maps to its own.
PlacedBox placed(const BoxNode& box, const Matrix3& R, const Vector3& t) {
  PlacedBox to{};
  const Vector3 apart = t - vector_of(box.center);
  for (int j = 0; j < 3; ++j) {
    const Vector3 axis = vector_of(box.axis[j]);
    write(R.transposed_times(axis), to.turn[j]);
    to.center[j] = static_cast<float>(dot(axis, apart));
    to.half[j] = box.half[j];
  }
  return to;
}

// The same of points about `origin`.
PlacedBox moved(const PlacedBox& box, const float* origin) {
  PlacedBox to = box;
  for (int j = 0; j < 3; ++j)
    to.center[j] += box.turn[j][0] * origin[0] + box.turn[j][1] * origin[1] + box.turn[j][2] * origin[2];
  return to;
}

}  // namespace

WideSearch::WideSearch(const Kernels& kernels, const Stopwatch& watch) : kernels_(&kernels), watch_(&watch) {
  open_.reserve(kFirstRoom);
}

void WideSearch::search(const MeshPair& pair, NearestTriangles& nearest) {
  pair_ = &pair;
  nearest_ = &nearest;
  begin();
  while (!open_.empty() && !nearest.found.meets) {
    const OpenPair next = open_.back();
    open_.pop_back();
    if (nearest.is_beyond(double{next.lower} - pair.single_slack)) {
      nearest.pass_over();
      continue;
    }
    if (is_over(next)) break;
    if (WideTree::is_block(next.wide_one) && WideTree::is_block(next.wide_two)) {
      look_at_blocks(next);
    } else {
      open(next);
    }
  }
}

void WideSearch::begin() {
  open_.clear();
  looks_ = lane_count_ = 0;
  placed_[0].node = placed_[1].node = -1;
  const Matrix3& R = pair_->R;
  for (int k = 0; k < 3; ++k)
    back_R_.column[k] = {(&R.column[0].x)[k], (&R.column[1].x)[k], (&R.column[2].x)[k]};
  back_t_ = -R.transposed_times(pair_->t);
  for (int k = 0; k < 3; ++k) write(back_R_.column[k], lanes_.turn[k]);
  const BoxNode &a = pair_->tree_1().node(0), &b = pair_->tree_2().node(0);
  const double apart =
      length(pair_->to_first(vector_of(b.center)) - vector_of(a.center)) - radius_of(a) - radius_of(b);
  open_.push_back(
      {0, 0, pair_->tree_1().wide().root(), pair_->tree_2().wide().root(), static_cast<float>(apart)});
}

bool WideSearch::is_over(const OpenPair& pair) {
  if (++looks_ % kLooksPerReading != 0 || !watch_->expired()) return false;
  nearest_->leave_open(double{pair.lower} - pair_->single_slack);
  for (const OpenPair& other : open_) nearest_->leave_open(double{other.lower} - pair_->single_slack);
  return true;
}

// What boxes and triangles at least so far apart, in single precision, are.
float WideSearch::beyond() const noexcept {
  return at_least(nearest_->target() + pair_->margin + pair_->single_slack);
}

// A box of the first mesh as the second one sees it.
const PlacedBox& WideSearch::place_first(std::int32_t one) {
  Placed& first = placed_[0];
  if (first.node != one) first = {one, placed(pair_->tree_1().node(one), pair_->R, pair_->t)};
  return first.box;
}

const PlacedBox& WideSearch::place_second(std::int32_t two) {
  Placed& second = placed_[1];
  if (second.node != two) second = {two, placed(pair_->tree_2().node(two), back_R_, back_t_)};
  return second.box;
}

// The larger box is opened.
void WideSearch::open(const OpenPair& pair) {
  const BoxNode &a = pair_->tree_1().node(pair.one), &b = pair_->tree_2().node(pair.two);
  const bool of_first =
      WideTree::is_block(pair.wide_two) || (!WideTree::is_block(pair.wide_one) && a.size() > b.size());
  const WideNode& node =
      of_first ? pair_->tree_1().wide().node(pair.wide_one) : pair_->tree_2().wide().node(pair.wide_two);
  const PlacedBox& box = of_first ? place_second(pair.two) : place_first(pair.one);
  alignas(32) float lower[BoxLanes::kCount];
  const unsigned all = (1U << node.count) - 1,
                 near = kernels_->bound_boxes(&node.boxes, &box, beyond(), lower) & all;
  nearest_->counters.box_pairs += node.count;
  if (near != all) nearest_->pass_over();
  push_near(pair, node, near, lower, of_first);
}

// The nearest one last.
void WideSearch::push_near(const OpenPair& pair, const WideNode& node, unsigned lanes, const float* lower,
                           bool of_first) {
  const std::size_t first = open_.size();
  for (; lanes != 0; lanes &= lanes - 1) {
    const int lane = std::countr_zero(lanes);
    OpenPair fresh = pair;
    (of_first ? fresh.one : fresh.two) = node.box[lane];
    (of_first ? fresh.wide_one : fresh.wide_two) = node.wide[lane];
    fresh.lower = lower[lane];
    std::size_t place = open_.size();
    open_.push_back(fresh);
    for (; place > first && open_[place - 1].lower < fresh.lower; --place) open_[place] = open_[place - 1];
    open_[place] = fresh;
  }
}

// The triangles of either block that are not beyond the box of the other one, in pairs.
void WideSearch::look_at_blocks(const OpenPair& pair) {
  BlockLane near_1[TriangleBlock::kCount], near_2[TriangleBlock::kCount];
  const int count_2 = near_of_block(pair, false, near_2);
  const int count_1 = count_2 > 0 ? near_of_block(pair, true, near_1) : 0;
  if (count_1 == 0) return;
  const BoxNode &a = pair_->tree_1().node(pair.one), &b = pair_->tree_2().node(pair.two);
  const TriangleBlock& one = pair_->tree_1().wide().block(pair.wide_one);
  const TriangleBlock& two = pair_->tree_2().wide().block(pair.wide_two);
  const std::int32_t begin_1 = pair_->tree_1().triangles_of(pair.one).begin,
                     begin_2 = pair_->tree_2().triangles_of(pair.two).begin;
  const Vector3 offset = pair_->to_first(vector_of(b.center)) - vector_of(a.center);
  float at[3];
  write(offset, at);
  const float size = static_cast<float>((length(offset) + sum_of_halves(a) + sum_of_halves(b)) * (1 + 1e-5));
  for (int i = 0; i < count_1; ++i) {
    for (int k = 0; k < count_2; ++k) {
      const auto lane = static_cast<std::size_t>(lane_count_);
      lane_one_[lane] = begin_1 + near_1[i].lane;
      lane_two_[lane] = begin_2 + near_2[k].lane;
      lanes_.size[lane] = size;
      for (int c = 0; c < 3; ++c) lanes_.offset[c][lane] = at[c];
      add_lane(one, near_1[i].lane, two, near_2[k].lane);
      if (lane_count_ == TriangleLanes::kCount) look_at_lanes();
      if (nearest_->found.meets) return;
    }
  }
  look_at_lanes();
}

// Of a pair of blocks; the nearest one first.
int WideSearch::near_of_block(const OpenPair& pair, bool of_first, BlockLane* near) {
  const TriangleBlock& block =
      of_first ? pair_->tree_1().wide().block(pair.wide_one) : pair_->tree_2().wide().block(pair.wide_two);
  const PlacedBox box = of_first ? moved(place_second(pair.two), pair_->tree_1().node(pair.one).center)
                                 : moved(place_first(pair.one), pair_->tree_2().node(pair.two).center);
  alignas(32) float lower[TriangleBlock::kCount];
  unsigned lanes = kernels_->bound_block(&block, &box, beyond(), lower);
  if (lanes == 0) {
    nearest_->pass_over();
    return 0;
  }
  const TriangleRange range =
      of_first ? pair_->tree_1().triangles_of(pair.one) : pair_->tree_2().triangles_of(pair.two);
  const unsigned all = (1U << (range.end - range.begin)) - 1;
  lanes &= all;
  if (lanes != all) nearest_->pass_over();
  int count = 0;
  for (; lanes != 0; lanes &= lanes - 1) {
    const int lane = std::countr_zero(lanes);
    int place = count++;
    for (; place > 0 && near[place - 1].lower > lower[lane]; --place) near[place] = near[place - 1];
    near[place] = {lane, lower[lane]};
  }
  return count;
}

void WideSearch::add_lane(const TriangleBlock& one, int i, const TriangleBlock& two, int k) {
  const int lane = lane_count_++;
  for (int c = 0; c < 3; ++c) {
    for (int axis = 0; axis < 3; ++axis) {
      lanes_.one[c][axis][lane] = one.corner[c][axis][i];
      lanes_.two[c][axis][lane] = two.corner[c][axis][k];
    }
  }
}

// The nearest one first.
void WideSearch::look_at_lanes() {
  kernels_->bound_triangles(&lanes_, lane_count_);
  nearest_->counters.triangle_pairs += lane_count_;
  int near[TriangleLanes::kCount], count = 0;
  const auto lower = [&](int lane) { return double{lanes_.lower[lane]} - pair_->radii; };
  for (int lane = 0; lane < lane_count_; ++lane) {
    if (nearest_->is_beyond(lower(lane))) {
      nearest_->pass_over();
    } else {
      near[count++] = lane;
    }
  }
  lane_count_ = 0;
  while (count > 0 && !nearest_->found.meets) {
    int* const nearest =
        std::min_element(near, near + count, [&](int i, int k) { return lanes_.lower[i] < lanes_.lower[k]; });
    const int lane = *nearest;
    *nearest = near[--count];
    if (nearest_->is_beyond(lower(lane))) {
      nearest_->pass_over();
      continue;
    }
    const Vector3 way{double{lanes_.way[0][lane]}, double{lanes_.way[1][lane]}, double{lanes_.way[2][lane]}};
    nearest_->look_at(lane_one_[lane], lane_two_[lane], pair_->turned(lane_two_[lane]), way);
  }
}

}  // namespace raygauge
