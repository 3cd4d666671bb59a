// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Several pairs of boxes, balls and capsules to a vector: apart, or not? Part of kernel_impl.h.
//
// With p the way between the centres, g_k the generators of both bodies in the world (h_k times column k of R
// for a box, R h for a segment) and r both radii, the bodies meet if and only if p is in the sum of the
// zonotope Z = Σ [-1, 1] g_k and a ball of radius r; they are apart if and only if some u has
//
//     |u·p| > Σ |u·g_k| + r |u|.
//
// Rounding. u = 2⁻⁵³, and S = |t_2 - t_1|₁ + |c_1|₁ + |c_2|₁ + |h_1|₁ + |h_2|₁ + r, so that |p| + Σ|g_k| <= S
// but for 4e-12 of it. The halves and centres of boxes are rounded once, g_k is within 7 u |g_k|, and p,
// from seven terms, within 14 u S of what they stand for. A dot product of a vector v with one of these adds
// 3.1 u |v| S in all, and the sum of their magnitudes 7 u |v| S: less than
//
//     error() = 128 u S
//
// times |v|, whatever is contracted to fused operations. A cross product g×h is within 13 u |g||h| of the
// exact one, so that Σ |n·g_k| - |n·p| is within 52 u |g||h| S for n = g×h, exact or as it is rounded: again
// less than error() |g||h|. The image of a ball under R differs from a ball by less than 2⁻³⁷ r. Nothing
// overflows where 2⁻¹⁰⁰ < S < 2¹⁰⁰, and what underflows there is less than kSmallest in a product of three
// vectors. Lanes beyond that range stay open.
#pragma once

#include "engine/kernels/pack.h"
#include "engine/kernels/separation_lanes.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

static_assert(SeparationLanes::kCount == kLanes);

constexpr double kSeparationError = 0x1p-46;  // error() / S
constexpr double kTurnedBall = 0x1p-37;
constexpr double kSmallest = 0x1p-780;
constexpr double kLeastSize = 0x1p-100, kMostSize = 0x1p100;

struct Triple {
  Pack x, y, z;
};

inline Triple operator+(const Triple& a, const Triple& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Triple operator-(const Triple& a, const Triple& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Triple operator*(const Triple& a, Pack s) { return {a.x * s, a.y * s, a.z * s}; }
inline Pack dot(const Triple& a, const Triple& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Triple cross(const Triple& a, const Triple& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline Pack magnitudes(const Triple& a) { return magnitude(a.x) + magnitude(a.y) + magnitude(a.z); }
// NaN becomes `low`.
inline Pack clamped(Pack a, Pack low, Pack high) { return minimum(maximum(a, low), high); }

// Lanes `at`, at + 1, … of a number.
inline Pack lanes_at(const SeparationLanes::Row& row, int at) { return load(row + at); }
inline Triple lanes_at(const SeparationLanes::Row* rows, int at) {
  return {load(rows[0] + at), load(rows[1] + at), load(rows[2] + at)};
}

// A vector of body i's frame in the world.
inline Triple turned(const PairLanes& lanes, int i, const Triple& v, int at) {
  const PairLanes::Row* R = lanes.rotation[i];
  return lanes_at(R, at) * v.x + lanes_at(R + 3, at) * v.y + lanes_at(R + 6, at) * v.z;
}

// What all pairs have in common.
struct Placed {
  Placed(const SeparationLanes& lanes, int at) {
    const Triple apart = lanes_at(lanes.apart, at);
    const Triple c1 = lanes_at(lanes.center[0], at), c2 = lanes_at(lanes.center[1], at);
    half[0] = lanes_at(lanes.half[0], at);
    half[1] = lanes_at(lanes.half[1], at);
    radius = lanes_at(lanes.radius, at);
    p = apart + turned(lanes, 1, c2, at) - turned(lanes, 0, c1, at);
    size = magnitudes(apart) + magnitudes(c1) + magnitudes(c2) + magnitudes(half[0]) + magnitudes(half[1]) +
           radius;
    error = broadcast(kSeparationError) * size;
    in_range = lanes_above(size, kLeastSize) & ~lanes_above(size, kMostSize);
  }

  Triple p{}, half[2] = {};
  Pack radius, size, error;
  unsigned in_range;  // not of a NaN
};

inline void note(PairLanes* lanes, int at, unsigned are_apart, unsigned do_meet) {
  lanes->are_apart |= are_apart << at;
  lanes->do_meet |= do_meet << at;
}

inline void note_normal(PairLanes* lanes, int at, const Triple& normal) {
  store(lanes->normal[0] + at, normal.x);
  store(lanes->normal[1] + at, normal.y);
  store(lanes->normal[2] + at, normal.z);
}

// Points of the cores with the way v between them prove that the bodies meet where |v| + error < r, and the
// plane across v that they are apart; `height` is Σ |v·g_k|.
inline void decide_along(SeparationLanes* lanes, int at, const Placed& placed, const Triple& v, Pack height) {
  constexpr double kUp = 1 + 0x1p-46;
  const Pack square = dot(v, v) * broadcast(kUp);
  const Pack error = placed.error + broadcast(kTurnedBall) * placed.radius;
  const Pack inside = maximum(placed.radius - error, Pack{});
  const Pack beyond = placed.radius + error, gap = maximum(dot(v, placed.p) - height, Pack{});
  const unsigned has_way = lanes_above(square - error * error, 0.0);
  const unsigned are_apart = lanes_above(gap * gap - beyond * beyond * square * broadcast(kUp), 0.0);
  const unsigned do_meet = lanes_above(inside * inside - square, 0.0);
  note(lanes, at, are_apart & has_way & placed.in_range, do_meet & placed.in_range);
  if (lanes->with_normals) note_normal(lanes, at, v);
}

// p + t y and s x, |s|, |t| <= 1, as near to each other as they come, but for rounding.
inline void nearest_of_segments(const Triple& p, const Triple& x, const Triple& y, Pack* s, Pack* t) {
  const Pack one = broadcast(1.0), none = Pack{};
  const Pack xx = dot(x, x), yy = dot(y, y), xy = dot(x, y), xp = dot(x, p), yp = dot(y, p);
  *s = clamped((xp * yy - yp * xy) / (xx * yy - xy * xy), -one, one);
  for (int round = 0; round < 2; ++round) {
    const Pack at = clamped((*s * xy - yp) / yy, -one, one);
    *t = yy > none ? at : none;
    const Pack from = clamped((xp + *t * xy) / xx, -one, one);
    *s = xx > none ? from : none;
  }
}

void separate_capsules(SeparationLanes* lanes) {
  lanes->are_apart = lanes->do_meet = 0;
  for (int at = 0; at < kLanes; at += kWidth) {
    const Placed placed(*lanes, at);
    const Triple x = turned(*lanes, 0, placed.half[0], at), y = turned(*lanes, 1, placed.half[1], at);
    Pack s, t;
    nearest_of_segments(placed.p, x, y, &s, &t);
    const Triple v = placed.p + y * t - x * s;
    decide_along(lanes, at, placed, v, magnitude(dot(v, x)) + magnitude(dot(v, y)));
  }
}

// The distance of the point c + t y to the box of half edges h, both in the box's frame: half the derivative
// of its square, which rises with t.
struct DistanceToBox {
  Triple c, y, h;

  static Pack beyond(Pack x, Pack h) { return x - clamped(x, -h, h); }
  Pack slope(Pack t) const {
    return beyond(c.x + t * y.x, h.x) * y.x + beyond(c.y + t * y.y, h.y) * y.y +
           beyond(c.z + t * y.z, h.z) * y.z;
  }

  // The slope is linear between those t where a coordinate passes ±h: its zero is found between the last one
  // below 0 and the first one above.
  Pack nearest() const {
    const Pack one = broadcast(1.0), none = Pack{};
    Pack low = -one, high = one;
    Pack slope_low = slope(low), slope_high = slope(high);
    const auto look = [&](Pack at) {
      const Pack t = clamped(at, -one, one), here = slope(t);
      const auto below = (here <= none) & (t > low), above = (here >= none) & (t < high);
      low = below ? t : low;
      slope_low = below ? here : slope_low;
      high = above ? t : high;
      slope_high = above ? here : slope_high;
    };
    const Pack ix = one / y.x, iy = one / y.y, iz = one / y.z;
    look((h.x - c.x) * ix), look((-h.x - c.x) * ix);
    look((h.y - c.y) * iy), look((-h.y - c.y) * iy);
    look((h.z - c.z) * iz), look((-h.z - c.z) * iz);
    const Pack share = clamped(slope_low / (slope_low - slope_high), none, one);
    return low + (high - low) * share;
  }
};

void separate_box_from_capsule(SeparationLanes* lanes) {
  lanes->are_apart = lanes->do_meet = 0;
  for (int at = 0; at < kLanes; at += kWidth) {
    const Placed placed(*lanes, at);
    const Triple& h = placed.half[0];
    const Triple e[3] = {lanes_at(lanes->rotation[0], at), lanes_at(lanes->rotation[0] + 3, at),
                         lanes_at(lanes->rotation[0] + 6, at)};
    const Triple y = turned(*lanes, 1, placed.half[1], at);
    const DistanceToBox seen{{dot(e[0], placed.p), dot(e[1], placed.p), dot(e[2], placed.p)},
                             {dot(e[0], y), dot(e[1], y), dot(e[2], y)},
                             h};
    const Pack t = seen.nearest();
    const Triple v = placed.p + y * t - e[0] * clamped(seen.c.x + t * seen.y.x, -h.x, h.x) -
                     e[1] * clamped(seen.c.y + t * seen.y.y, -h.y, h.y) -
                     e[2] * clamped(seen.c.z + t * seen.y.z, -h.z, h.z);
    const Pack height = magnitude(dot(v, e[0])) * h.x + magnitude(dot(v, e[1])) * h.y +
                        magnitude(dot(v, e[2])) * h.z + magnitude(dot(v, y));
    decide_along(lanes, at, placed, v, height);
  }
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
