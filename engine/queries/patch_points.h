// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/methods/spatial/common_face.h"

namespace raygauge {

/// A pair of points and how far they are apart, along the normal of a patch.
struct GapPair {
  FacePair pair;
  double gap = 0;
  double loss = 0;  ///< what the patch loses without it: see PatchPoints::reduce
  double rank = 0;  ///< of its number, by which equal losses differ
};

/// The corners of a convex patch of contact, in order. It keeps its memory.
class PatchPoints {
 public:
  void begin() noexcept { pairs_.clear(); }
  void add(const GapPair& pair) { pairs_.push_back(pair); }
  const std::vector<GapPair>& pairs() const noexcept { return pairs_; }

  bool is_empty() const noexcept { return pairs_.empty(); }
  double least_gap() const;

  /// Cuts off what has a larger gap, which varies linearly along edges.
  void keep_within(double gap);

  /// Takes corners away until `most` are left, each time the one with the least triangle between it and its
  /// neighbours, seen along the normal; of corners with the same triangle every other one. Triangles of
  /// corners that are nearer, in shares of `margin`, count for more.
  void reduce(const Vector3& normal, int most, double margin);

 private:
  double loss(const Vector3& normal, std::size_t i, double widest, double margin) const;

  std::vector<GapPair> pairs_, other_;
};

}  // namespace raygauge
