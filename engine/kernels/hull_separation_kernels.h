// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Several pairs of hulls of few points, each with a ball, to a vector. Part of kernel_impl.h.
//
// With D = {x_2 - x_1} of the cores in the world and r both radii, the bodies meet if and only if D is within
// r of the origin. Support points of D come by portals from a point v_0 of D (G. Snethen, XenoCollide, 2008):
// the ray from v_0 through the origin passes through the triangle of three of them, and the next one is the
// farthest across it. A lane is decided where
//
//     max_D u·x < -r |u|,   or   0 is in conv{v_0, v_1, v_2, v_3},   or   |s| < r for a support point s.
//
// Rounding, with S = |t_2 - t_1|₁ + max|x_1|₁ + max|x_2|₁ + r, as in separation_kernels.h. max_D u·x is a
// maximum of R_2ᵀu·x_2, one of -R_1ᵀu·x_1, and u·(t_2 - t_1): within 30 u |u| S of its value. A support point
// is within 20 u S of one of D, and v_0, from means of up to 32 points, within 60 u S: less than
//
//     error() = 128 u S.
//
// So 0 is in D where a ball of radius error() about it is in the tetrahedron of the points as they are
// rounded. Of a facet a, b, c of it, n = (b - a) × (c - a) is rounded by less than 56 u S², and n·a by less
// than 70 u S³: the facet is farther than error() from 0 where |n·a| > error() |n| + 256 u S³. If 0 is so far
// inside of all four facets, whose n·a add up to the volume, it is in the tetrahedron.
#pragma once

#include "engine/kernels/separation_kernels.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

constexpr double kFlatError = 0x1p-45;        // 256 u
constexpr double kLeastDirection = 0x1p-700;  // of a direction: nothing that counts underflows
constexpr double kNearOrigin = 0x1p-10;       // a v_0 nearer than so many S is no place to look from
constexpr double kStraight = 0x1p-60;         // a square of a normal, in S⁴, is no direction
constexpr int kRounds = 16;

using Mask = decltype(Pack{} > Pack{});

inline Triple choose(Mask which, const Triple& a, const Triple& b) {
  return {which ? a.x : b.x, which ? a.y : b.y, which ? a.z : b.z};
}
inline Triple operator-(const Triple& a) { return {-a.x, -a.y, -a.z}; }

// The lanes of a mask, as bits.
inline unsigned bits_of_lanes(Mask which) { return lanes_above(which ? broadcast(1.0) : Pack{}, 0.0); }

class HullPair {
 public:
  HullPair(HullLanes* lanes, int at) : lanes_(lanes), at_(at) {
    apart_ = lanes_at(lanes->apart, at);
    radius_ = lanes_at(lanes->radius, at);
    size_ = magnitudes(apart_) + lanes_at(lanes->extent[0], at) + lanes_at(lanes->extent[1], at) + radius_;
    error_ = broadcast(kSeparationError) * size_;
    beyond_ = radius_ + (error_ + broadcast(kTurnedBall) * radius_);
    const Pack inside = maximum(radius_ - (error_ + broadcast(kTurnedBall) * radius_), Pack{});
    inside_square_ = inside * inside;
    in_range_ = lanes_above(size_, kLeastSize) & ~lanes_above(size_, kMostSize);
  }

  static constexpr unsigned kAll = (1U << kWidth) - 1;
  bool decided() const { return ((are_apart_ | do_meet_ | ~in_range_) & kAll) == kAll; }
  Pack size() const { return size_; }

  // A point in the middle of D, or on the way from there to another one of D.
  Triple start() {
    const Triple middle =
        apart_ + turned(*lanes_, 1, middle_of(1), at_) - turned(*lanes_, 0, middle_of(0), at_);
    const Mask near = magnitudes(middle) < broadcast(kNearOrigin) * size_;
    if (bits_of_lanes(near) == 0) return middle;
    const Triple other = farthest({broadcast(1.0), broadcast(0.5), broadcast(0.25)});
    return choose(near, middle + (other - middle) * broadcast(0.25), middle);
  }

  // The point of D that is farthest along n. Notes what it proves.
  Triple farthest(const Triple& n) {
    Pack height_1, height_2;
    const Triple x_1 = farthest_of(0, -n, &height_1), x_2 = farthest_of(1, n, &height_2);
    const Triple s = apart_ + turned(*lanes_, 1, x_2, at_) - turned(*lanes_, 0, x_1, at_);
    const Pack below = maximum(-(height_1 + height_2 + dot(n, apart_)), Pack{});
    constexpr double kUp = 1 + 0x1p-46;
    const Pack square = dot(n, n) * broadcast(kUp);
    const Mask apart =
        (below * below > beyond_ * beyond_ * square * broadcast(kUp)) & (square > broadcast(kLeastDirection));
    const unsigned new_ones = bits_of_lanes(apart) & ~are_apart_;
    if (lanes_->with_normals && new_ones != 0) normal_ = choose(apart & ~known_, -n, normal_);
    known_ |= apart;
    are_apart_ |= new_ones;
    do_meet_ |= bits_of_lanes(dot(s, s) * broadcast(kUp) < inside_square_);
    return s;
  }

  // Whether 0 is in the tetrahedron; n = (v_2 - v_1) × (v_3 - v_1).
  void look_inside(const Triple& v_0, const Triple& v_1, const Triple& v_2, const Triple& v_3,
                   const Triple& n) {
    const Triple a = v_1 - v_0, b = v_2 - v_0, c = v_3 - v_0;
    const Triple ab = cross(a, b), bc = cross(b, c), ca = cross(c, a);
    Pack least = dot(n, v_1) - error_ * magnitudes(n);
    for (const Triple* side : {&ab, &bc, &ca})
      least = minimum(least, -dot(*side, v_0) - error_ * magnitudes(*side));
    do_meet_ |= bits_of_lanes(least > broadcast(kFlatError) * (size_ * size_ * size_));
  }

  // What is proven, less of both, which no pair can be.
  void note_all() {
    note(lanes_, at_, are_apart_ & ~do_meet_ & in_range_, do_meet_ & ~are_apart_ & in_range_);
    if (lanes_->with_normals) note_normal(lanes_, at_, normal_);
  }

 private:
  // Of the points with unlike weights: the ray from the centre of symmetric bodies goes along edges of
  // portals, where no point is inside of them.
  Triple middle_of(int body) const {
    const double first = body == 0 ? 1 : 1.375, step = body == 0 ? 0.03125 : -0.0390625;
    Triple sum{};
    double weight = first, weights = 0;
    for (int i = 0; i < lanes_->count[body]; ++i) {
      sum = sum + lanes_at(lanes_->point[body][i], at_) * broadcast(weight);
      weights += weight;
      weight = weight + step > 0.5 && weight + step < 2 ? weight + step : first;
    }
    return sum * broadcast(1 / weights);
  }

  // In the body's frame.
  Triple farthest_of(int body, const Triple& n, Pack* height) const {
    const PairLanes::Row* R = lanes_->rotation[body];
    const Triple u = {dot(lanes_at(R, at_), n), dot(lanes_at(R + 3, at_), n), dot(lanes_at(R + 6, at_), n)};
    Triple best = lanes_at(lanes_->point[body][0], at_);
    Pack most = dot(u, best);
    for (int i = 1; i < lanes_->count[body]; ++i) {
      const Triple x = lanes_at(lanes_->point[body][i], at_);
      const Pack value = dot(u, x);
      const Mask higher = value > most;
      most = higher ? value : most;
      best = choose(higher, x, best);
    }
    *height = most;
    return best;
  }

  HullLanes* lanes_;
  int at_;
  Triple apart_{}, normal_{};
  Pack radius_, size_, error_, beyond_, inside_square_;
  Mask known_{};
  unsigned in_range_ = 0, are_apart_ = 0, do_meet_ = 0;
};

// v_1, v_2 and v_3 as described above. Until there is a portal, the next point is looked for across the
// triangle v_0, v_1, v_2, on the origin's side.
class PortalLanes {
 public:
  explicit PortalLanes(HullPair* pair) : pair_(pair), v0_(pair->start()) {
    v1_ = pair->farthest(-v0_);
    n_ = cross(v1_, v0_);
    const Pack size = pair->size();
    const Mask straight = dot(n_, n_) < broadcast(kStraight) * (size * size * size * size);
    const Mask x_is_small = magnitude(v0_.x) <= magnitude(v0_.y);
    const Pack one = broadcast(1.0), none = Pack{};
    const Triple axis = {x_is_small ? one : none, x_is_small ? none : one, none};
    n_ = choose(straight, cross(v0_, axis), n_);
    v2_ = pair->farthest(n_);
    n_ = cross(v1_ - v0_, v2_ - v0_);
    const Mask away = dot(n_, v0_) > none;
    const Triple first = v1_;
    v1_ = choose(away, v2_, v1_);
    v2_ = choose(away, first, v2_);
    n_ = choose(away, -n_, n_);
    v3_ = v2_;
  }

  void look() {
    const Pack none = Pack{};
    const Triple s = pair_->farthest(n_), across = cross(s, v0_);
    const Pack side_1 = dot(v1_, across);
    const Mask one = side_1 > none, two = dot(v2_, across) > none, three = dot(v3_, across) > none;
    // Of a portal, the corner that leaves it the ray; before there is one, the corner on s's far side of it.
    const Mask first = (portal_ & ((one & two) | (~one & ~three))) | (~portal_ & two & ~(side_1 < none));
    const Mask second = (portal_ & ~one & three) | (~portal_ & (side_1 < none));
    const Mask third = ~(first | second);
    v1_ = choose(first, s, v1_);
    v2_ = choose(second, s, v2_);
    v3_ = choose(third, s, v3_);
    portal_ |= third;
    n_ = choose(portal_, cross(v2_ - v1_, v3_ - v1_), cross(v1_ - v0_, v2_ - v0_));
    if (bits_of_lanes(portal_ & (dot(n_, v1_) > none)) != 0) pair_->look_inside(v0_, v1_, v2_, v3_, n_);
  }

 private:
  HullPair* pair_;
  Triple v0_, v1_{}, v2_{}, v3_{}, n_{};
  Mask portal_{};
};

void separate_hulls(HullLanes* lanes) {
  lanes->are_apart = lanes->do_meet = 0;
  for (int at = 0; at < kLanes; at += kWidth) {
    HullPair pair(lanes, at);
    PortalLanes portal(&pair);
    for (int round = 0; round < kRounds && !pair.decided(); ++round) portal.look();
    pair.note_all();
  }
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
