// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace raygauge {

/// A point of a plane, and which of the caller's points it came from; below 0: made by cuts. A cut numbers
/// the corners that it makes by itself and by whether the polygon is entered or left there, so that they have
/// the same numbers after a small motion.
struct FlatPoint {
  double x = 0, y = 0;
  std::int32_t index = -1;
};

/// A convex polygon of a plane: its corners counterclockwise, the two ends of a segment, or a point. Empty:
/// nothing. Functions work in place and allocate only where the polygon grows beyond what it once held.
class FlatPolygon {
 public:
  void clear() noexcept { corners_.clear(); }
  void add(const FlatPoint& p) { corners_.push_back(p); }

  const std::vector<FlatPoint>& corners() const noexcept { return corners_; }
  int count() const noexcept { return static_cast<int>(corners_.size()); }
  bool is_empty() const noexcept { return corners_.empty(); }

  /// The corners become those of their hull. What is within `noise` of fewer corners, of a segment, or of a
  /// point becomes that.
  void make_hull(double noise);

  /// Keeps what is at most `offset` to the right of the line from a along the vector (x, y): cut `number`.
  void cut(const FlatPoint& a, double x, double y, double offset, std::int32_t number);

  /// Keeps what is within `offset` of another polygon, of its edges' lines: corners of that count sharply. Of
  /// a segment, `beside` is allowed to both of its sides.
  void cut(const FlatPolygon& other, double offset, double beside);

  /// Corners nearer to the one before them than `size` go, and all but the middle if all are that near.
  void merge(double size);

  /// Of a point where two segments cross: to where their lines do, if that is within `reach` of both.
  void move_to_crossing(const FlatPolygon& one, const FlatPolygon& two, double reach);

  /// The least distance of p from the lines of the edges, negative outside; -infinity of what is no polygon.
  double depth_of(const FlatPoint& p) const;

  FlatPoint middle() const;

 private:
  bool is_wide(double noise) const;
  bool shrink(double noise);
  bool order();
  void make_chain();

  std::vector<FlatPoint> corners_, other_;
};

}  // namespace raygauge
