// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/methods/bodies/open_facets.h"
#include "engine/methods/spatial/common_face.h"

namespace raygauge {

/// A pair of points and how far they are apart, along the normal of a patch.
struct GapPair {
  FacePair pair;
  double gap = 0;
  double rank = 0;                     ///< of its number, by which equal losses differ
  std::int32_t before = 0, after = 0;  ///< the neighbours that are left
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
  GapPair& at(std::int32_t i) { return pairs_[static_cast<std::size_t>(i)]; }
  void weigh(const Vector3& normal, std::int32_t i, double widest, double margin);

  std::vector<GapPair> pairs_, other_;
  OpenFacets losses_;  // of the corners that are left: what the patch loses without them
};

}  // namespace raygauge
