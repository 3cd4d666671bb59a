// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// The search of a MeshSearch for the nearest triangles of two meshes, eight boxes and sixteen pairs of
// triangles at once, in single precision. What is not beyond the target then is looked at in double.
#include <algorithm>
#include <bit>
#include <cmath>

#include "engine/queries/mesh_search.h"

namespace raygauge {
namespace {

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

void MeshSearch::search_wide() {
  wide_open_.clear();
  lane_count_ = 0;
  placed_[0].node = placed_[1].node = -1;
  for (int k = 0; k < 3; ++k)
    back_R_.column[k] = {(&R_.column[0].x)[k], (&R_.column[1].x)[k], (&R_.column[2].x)[k]};
  back_t_ = -R_.transposed_times(t_);
  for (int k = 0; k < 3; ++k) write(back_R_.column[k], lanes_.turn[k]);
  const BoxNode &a = first_->tree().node(0), &b = other_.tree->node(0);
  const double apart =
      length(to_first(vector_of(b.center)) - vector_of(a.center)) - radius_of(a) - radius_of(b);
  wide_open_.push_back(
      {0, 0, first_->tree().wide().root(), other_.tree->wide().root(), static_cast<float>(apart)});
  while (!wide_open_.empty() && !meets_) {
    const WidePair pair = wide_open_.back();
    wide_open_.pop_back();
    if (is_beyond(double{pair.lower} - single_slack_)) {
      passed_over_ = true;
      continue;
    }
    if (++looks_ % kLooksPerReading == 0 && watch_.expired()) {
      note_out_of_time(double{pair.lower} - single_slack_);
      for (const WidePair& other : wide_open_) note_out_of_time(double{other.lower} - single_slack_);
      break;
    }
    if (WideTree::is_block(pair.wide_one) && WideTree::is_block(pair.wide_two)) {
      look_at_blocks(pair);
    } else {
      open(pair);
    }
  }
}

// A box of the first mesh as the second one sees it.
const PlacedBox& MeshSearch::place_first(std::int32_t one) {
  Placed& first = placed_[0];
  if (first.node != one) first = {one, placed(first_->tree().node(one), R_, t_)};
  return first.box;
}

const PlacedBox& MeshSearch::place_second(std::int32_t two) {
  Placed& second = placed_[1];
  if (second.node != two) second = {two, placed(other_.tree->node(two), back_R_, back_t_)};
  return second.box;
}

// The larger box is opened.
void MeshSearch::open(const WidePair& pair) {
  const BoxNode &a = first_->tree().node(pair.one), &b = other_.tree->node(pair.two);
  const bool of_first =
      WideTree::is_block(pair.wide_two) || (!WideTree::is_block(pair.wide_one) && a.size() > b.size());
  const WideNode& node =
      of_first ? first_->tree().wide().node(pair.wide_one) : other_.tree->wide().node(pair.wide_two);
  const PlacedBox& box = of_first ? place_second(pair.two) : place_first(pair.one);
  alignas(32) float lower[BoxLanes::kCount];
  const float beyond = at_least(target_ + margin_ + single_slack_);
  const unsigned all = (1U << node.count) - 1,
                 near = kernels_.bound_boxes(&node.boxes, &box, beyond, lower) & all;
  counters_.box_pairs += node.count;
  if (near != all) passed_over_ = true;
  push_near(pair, node, near, lower, of_first);
}

// The nearest one last.
void MeshSearch::push_near(const WidePair& pair, const WideNode& node, unsigned lanes, const float* lower,
                           bool of_first) {
  const std::size_t first = wide_open_.size();
  for (; lanes != 0; lanes &= lanes - 1) {
    const int lane = std::countr_zero(lanes);
    WidePair fresh = pair;
    (of_first ? fresh.one : fresh.two) = node.box[lane];
    (of_first ? fresh.wide_one : fresh.wide_two) = node.wide[lane];
    fresh.lower = lower[lane];
    std::size_t place = wide_open_.size();
    wide_open_.push_back(fresh);
    for (; place > first && wide_open_[place - 1].lower < fresh.lower; --place)
      wide_open_[place] = wide_open_[place - 1];
    wide_open_[place] = fresh;
  }
}

// The triangles of either block that are not beyond the box of the other one, in pairs.
void MeshSearch::look_at_blocks(const WidePair& pair) {
  BlockLane near_1[TriangleBlock::kCount], near_2[TriangleBlock::kCount];
  const int count_2 = near_of_block(pair, false, near_2);
  const int count_1 = count_2 > 0 ? near_of_block(pair, true, near_1) : 0;
  if (count_1 == 0) return;
  const BoxNode &a = first_->tree().node(pair.one), &b = other_.tree->node(pair.two);
  const TriangleBlock& one = first_->tree().wide().block(pair.wide_one);
  const TriangleBlock& two = other_.tree->wide().block(pair.wide_two);
  const std::int32_t begin_1 = first_->tree().triangles_of(pair.one).begin,
                     begin_2 = other_.tree->triangles_of(pair.two).begin;
  const Vector3 offset = to_first(vector_of(b.center)) - vector_of(a.center);
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
      if (meets_) return;
    }
  }
  look_at_lanes();
}

// Of a pair of blocks; the nearest one first.
int MeshSearch::near_of_block(const WidePair& pair, bool of_first, BlockLane* near) {
  const TriangleBlock& block =
      of_first ? first_->tree().wide().block(pair.wide_one) : other_.tree->wide().block(pair.wide_two);
  const PlacedBox box = of_first ? moved(place_second(pair.two), first_->tree().node(pair.one).center)
                                 : moved(place_first(pair.one), other_.tree->node(pair.two).center);
  alignas(32) float lower[TriangleBlock::kCount];
  unsigned lanes = kernels_.bound_block(&block, &box, at_least(target_ + margin_ + single_slack_), lower);
  if (lanes == 0) {
    passed_over_ = true;
    return 0;
  }
  const TriangleRange range =
      of_first ? first_->tree().triangles_of(pair.one) : other_.tree->triangles_of(pair.two);
  const unsigned all = (1U << (range.end - range.begin)) - 1;
  lanes &= all;
  if (lanes != all) passed_over_ = true;
  int count = 0;
  for (; lanes != 0; lanes &= lanes - 1) {
    const int lane = std::countr_zero(lanes);
    int place = count++;
    for (; place > 0 && near[place - 1].lower > lower[lane]; --place) near[place] = near[place - 1];
    near[place] = {lane, lower[lane]};
  }
  return count;
}

void MeshSearch::add_lane(const TriangleBlock& one, int i, const TriangleBlock& two, int k) {
  const int lane = lane_count_++;
  for (int c = 0; c < 3; ++c) {
    for (int axis = 0; axis < 3; ++axis) {
      lanes_.one[c][axis][lane] = one.corner[c][axis][i];
      lanes_.two[c][axis][lane] = two.corner[c][axis][k];
    }
  }
}

// The nearest one first.
void MeshSearch::look_at_lanes() {
  kernels_.bound_triangles(&lanes_, lane_count_);
  counters_.triangle_pairs += lane_count_;
  int near[TriangleLanes::kCount], count = 0;
  const auto lower = [&](int lane) { return double{lanes_.lower[lane]} - radii_; };
  for (int lane = 0; lane < lane_count_; ++lane) {
    if (is_beyond(lower(lane))) {
      passed_over_ = true;
    } else {
      near[count++] = lane;
    }
  }
  lane_count_ = 0;
  while (count > 0 && !meets_) {
    int* const nearest =
        std::min_element(near, near + count, [&](int i, int k) { return lanes_.lower[i] < lanes_.lower[k]; });
    const int lane = *nearest;
    *nearest = near[--count];
    if (is_beyond(lower(lane))) {
      passed_over_ = true;
      continue;
    }
    turn_second(lane_two_[lane]);
    look_at_triangles(
        lane_one_[lane], lane_two_[lane],
        {double{lanes_.way[0][lane]}, double{lanes_.way[1][lane]}, double{lanes_.way[2][lane]}});
  }
}

}  // namespace raygauge
