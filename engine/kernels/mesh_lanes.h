// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

namespace raygauge {

/// Eight boxes {center + Σ_k z_k axis_k : |z_k| <= half_k}, one to a lane, as structure of arrays.
struct alignas(32) BoxLanes {
  static constexpr int kCount = 8;
  using Row = float[kCount];

  Row center[3];
  Row axis[3][3];
  Row half[3];
};

/// A box and how others are seen along its axes: x of their frame has the coordinates turn x + center there,
/// where the box is |z_k| <= half_k. Row j of `turn` is turn[j].
struct PlacedBox {
  float turn[3][3];
  float center[3];
  float half[3];
};

/// Eight triangles, one to a lane.
struct alignas(32) TriangleBlock {
  static constexpr int kCount = BoxLanes::kCount;
  using Row = float[kCount];

  Row corner[3][3];  ///< [c][k]: coordinate k of corner c
};

/// Sixteen pairs of triangles, one to a lane, each triangle in a frame of its own.
struct alignas(64) TriangleLanes {
  static constexpr int kCount = 16;
  using Row = float[kCount];

  Row one[3][3];  ///< [c][k]: coordinate k of corner c
  Row two[3][3];  ///< y, which is at turn y + offset in the first frame
  Row offset[3];
  Row size;  ///< at least the length of each corner and of the offset
  float turn[3][3];

  /// Out. The distance of the triangles as they were before they and the offset were rounded to single
  /// precision, turned by any matrix within 2⁻²⁴ of `turn`, is at least this.
  alignas(64) Row lower;
  alignas(64) Row way[3];  ///< about the unit vector from 1 to 2 that proves it; 0: none is known
};

}  // namespace raygauge
