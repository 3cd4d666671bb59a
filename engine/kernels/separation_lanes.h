// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

namespace raygauge {

/// Eight pairs of bodies of R^3, one to a lane, as structure of arrays: entry [k][l] is number k of lane l.
/// A body is {R x + t : x in a core + a ball about the origin}.
///
/// A lane is decided by a proof alone: `apart` by a plane, `meet` by a point of both bodies. What is known of
/// the rotations is that RᵀR = 1 to 4e-12 in the spectral norm.
struct alignas(64) PairLanes {
  static constexpr int kCount = 8;
  using Row = double[kCount];

  Row rotation[2][9];  ///< R of both bodies, by columns
  Row apart[3];        ///< t_2 - t_1
  Row radius;          ///< of both balls together

  /// Out, if asked for, of lanes that are apart: the normal of the plane, from the first body to the second
  /// one, of any length.
  alignas(64) Row normal[3];
  bool with_normals = false;

  unsigned are_apart = 0, do_meet = 0;  ///< out: bit l is for lane l
};

/// Cores c + G with the box G = {|x_k| <= h_k} or the segment G = [-h, h]; a point has h = 0. Where one of
/// the two is a box and the other is not, the box is the first.
struct SeparationLanes : PairLanes {
  alignas(64) Row center[2][3];  ///< c
  Row half[2][3];                ///< h
};

/// Cores that are hulls of few points.
struct HullLanes : PairLanes {
  static constexpr int kMost = 32;
  alignas(64) Row point[2][kMost][3];
  Row extent[2];  ///< at least |x|₁ of the points, but for rounding
  int count[2];   ///< of points in every lane: a lane with fewer repeats one of them
};

}  // namespace raygauge
