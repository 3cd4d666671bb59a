// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "scene/queries/placed_pair.h"

namespace raygauge {

/// A part of each of two bodies, and a certified lower bound on their distance from their bounding balls.
struct PartCandidate {
  PartNumbers parts;
  double ball_bound = 0;
};

/// The pairs of parts of two bodies where they stand, those with the least bounds first, equal ones by their
/// numbers. Where both have few parts together all are sorted, else trees of balls are opened as far as the
/// caller asks: the order is the same.
class PartOrder {
 public:
  /// The bodies of what follows, which must outlive it.
  void bind(const Body& a, const Body& b);

  /// All pairs, from the first one on. Balls that are tested are added to `tests`, which must outlive it.
  void begin(const PlacedPair& placed, std::int64_t& tests);

  /// The next pair; nullptr: there is none. Lives until the next call.
  const PartCandidate* next();

 private:
  /// Two nodes, or parts of bodies without a tree.
  struct Entry {
    double bound = 0;
    int a = 0, b = 0;
    bool is_pair = false;  // of parts, whose numbers these are then
  };

  static bool later(const Entry& x, const Entry& y) noexcept;
  void push(int node_a, int node_b, double least);
  void open(const Entry& entry);

  const Body* a_ = nullptr;
  const Body* b_ = nullptr;
  const PlacedPair* placed_ = nullptr;
  bool trees_ = false;
  std::vector<PartCandidate> all_;  // without trees
  std::size_t next_ = 0;
  std::vector<Entry> heap_;
  PartCandidate found_;
  std::int64_t* tests_ = nullptr;
};

}  // namespace raygauge
