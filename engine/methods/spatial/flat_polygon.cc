// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/flat_polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raygauge {
namespace {

double cross(const FlatPoint& o, const FlatPoint& a, const FlatPoint& b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

double square(const FlatPoint& a, const FlatPoint& b) {
  return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
}

bool is_before(const FlatPoint& a, const FlatPoint& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

double distance(const FlatPoint& a, const FlatPoint& b) { return std::sqrt(square(a, b)); }

// Of p from the line through a and b, to its left.
double to_the_left(const FlatPoint& a, const FlatPoint& b, const FlatPoint& p) {
  const double size = distance(a, b);
  return size > 0 ? cross(a, b, p) / size : -distance(a, p);
}

// Whether p is farther to the right of that line than `noise`.
bool is_beside(const FlatPoint& a, const FlatPoint& b, const FlatPoint& p, double noise) {
  const double of_line = square(a, b), area = cross(a, b, p);
  return of_line > 0 ? area < 0 && area * area > noise * noise * of_line : distance(a, p) > noise;
}

const FlatPoint& farthest(const std::vector<FlatPoint>& points, const FlatPoint& from) {
  std::size_t best = 0;
  double most = square(from, points[0]);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double away = square(from, points[i]);
    if (!(most < away)) continue;
    most = away;
    best = i;
  }
  return points[best];
}

}  // namespace

// Whether no line is near the first three corners: of a triangle one corner is at least half of its least
// height from any line.
bool FlatPolygon::is_wide(double noise) const {
  if (corners_.size() < 3) return false;
  const FlatPoint &a = corners_[0], &b = corners_[1], &c = corners_[2];
  const double around =
      std::fabs(b.x - a.x) + std::fabs(b.y - a.y) + std::fabs(c.x - a.x) + std::fabs(c.y - a.y);
  return std::fabs(cross(a, b, c)) > 4 * noise * around;
}

// True where the points are as good as one or two.
bool FlatPolygon::shrink(double noise) {
  if (is_wide(noise)) return false;
  const FlatPoint first = farthest(corners_, middle()), second = farthest(corners_, first);
  const double width = distance(first, second);
  const bool is_point = !(width > noise);
  const auto wide = [&](const FlatPoint& p) { return std::fabs(cross(first, second, p)) > noise * width; };
  if (!is_point && std::any_of(corners_.begin(), corners_.end(), wide)) return false;
  corners_.assign(1, first);
  if (!is_point) corners_.push_back(second);
  return true;
}

// True where the corners go around once, in whichever sense, without a straight angle, as those of a disc do;
// then they begin with the first of their x and go to the left.
bool FlatPolygon::order() {
  constexpr std::size_t kFew = 12;  // are sorted as fast
  const std::size_t count = corners_.size();
  if (count < kFew) return false;
  if (cross(corners_[0], corners_[1], corners_[2]) < 0) std::reverse(corners_.begin(), corners_.end());
  std::size_t first = 0;
  int ends = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const FlatPoint &before = corners_[i > 0 ? i - 1 : count - 1], &at = corners_[i],
                    &after = corners_[i + 1 < count ? i + 1 : 0];
    if (!(cross(before, at, after) > 0)) return false;
    ends += is_before(at, before) && is_before(at, after) ? 1 : 0;
    first = is_before(at, corners_[first]) ? i : first;
  }
  if (ends != 1) return false;
  std::rotate(corners_.begin(), corners_.begin() + static_cast<std::ptrdiff_t>(first), corners_.end());
  return true;
}

// The monotone chain (Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979).
void FlatPolygon::make_chain() {
  std::sort(corners_.begin(), corners_.end(), is_before);
  other_.clear();
  std::size_t floor = 2;
  const auto take = [&](const FlatPoint& p) {
    while (other_.size() >= floor && !(cross(*(other_.end() - 2), other_.back(), p) > 0)) other_.pop_back();
    other_.push_back(p);
  };
  std::for_each(corners_.begin(), corners_.end(), take);
  floor = other_.size() + 1;
  std::for_each(corners_.rbegin() + 1, corners_.rend(), take);
  other_.pop_back();
}

void FlatPolygon::make_hull(double noise) {
  if (corners_.size() < 2 || shrink(noise)) return;
  if (order())
    std::swap(corners_, other_);
  else
    make_chain();
  corners_.clear();
  const std::size_t count = other_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const FlatPoint& before = corners_.empty() ? other_.back() : corners_.back();
    if (is_beside(before, other_[i + 1 < count ? i + 1 : 0], other_[i], noise)) corners_.push_back(other_[i]);
  }
  if (count >= 3 && corners_.size() < 3) corners_ = other_;
}

void FlatPolygon::cut(const FlatPoint& a, double x, double y, double offset, std::int32_t number) {
  const auto area = [&](const FlatPoint& p) { return x * (p.y - a.y) - y * (p.x - a.x); };
  if (std::all_of(corners_.begin(), corners_.end(), [&](const FlatPoint& p) { return area(p) >= 0; })) return;
  const double size = std::sqrt(x * x + y * y);
  if (!(size > 0)) return;
  const auto height = [&](const FlatPoint& p) { return area(p) / size + offset; };
  const auto is_kept = [&](const FlatPoint& p) { return area(p) >= 0 || height(p) >= 0; };  // offset >= 0
  const std::size_t count = corners_.size();
  if (std::all_of(corners_.begin(), corners_.end(), is_kept)) return;
  other_.clear();
  bool is_next_kept = is_kept(corners_[0]);
  for (std::size_t i = 0; i < count; ++i) {
    const FlatPoint &p = corners_[i], &next = corners_[(i + 1) % count];
    const bool is_here_kept = is_next_kept;
    is_next_kept = is_kept(next);
    if (is_here_kept) other_.push_back(p);
    const bool has_edge = count > 2 || (count == 2 && i == 0);
    if (!has_edge || is_here_kept == is_next_kept) continue;
    const double at = height(p), share = at / (at - height(next));
    const std::int32_t made = -2 - 2 * number - (is_here_kept ? 1 : 0);
    other_.push_back({p.x + (next.x - p.x) * share, p.y + (next.y - p.y) * share, made});
  }
  std::swap(corners_, other_);
}

void FlatPolygon::cut(const FlatPolygon& other, double offset, double beside) {
  const std::vector<FlatPoint>& q = other.corners_;
  if (q.size() == 1) {
    if (distance(middle(), q[0]) > std::max(offset, beside)) clear();
    return;
  }
  if (q.size() == 2) {
    const double x = q[1].x - q[0].x, y = q[1].y - q[0].y, width = std::max(offset, beside);
    cut(q[0], x, y, width, 0);
    cut(q[0], -x, -y, width, 1);
    cut(q[0], y, -x, offset, 2);
    cut(q[1], -y, x, offset, 3);
    return;
  }
  for (std::size_t i = 0; i < q.size(); ++i) {
    const FlatPoint& next = q[(i + 1) % q.size()];
    cut(q[i], next.x - q[i].x, next.y - q[i].y, offset, q[i].index);
  }
}

void FlatPolygon::merge(double size) {
  if (corners_.size() < 2) return;
  const FlatPoint center = middle();
  if (distance(farthest(corners_, center), center) <= 0.5 * size) {
    corners_.assign(1, center);
    return;
  }
  std::size_t kept = 0;
  for (const FlatPoint& corner : corners_) {
    if (kept == 0 || square(corners_[kept - 1], corner) > size * size) corners_[kept++] = corner;
  }
  while (kept > 2 && square(corners_[kept - 1], corners_[0]) <= size * size) --kept;
  corners_.resize(kept);
}

void FlatPolygon::move_to_crossing(const FlatPolygon& one, const FlatPolygon& two, double reach) {
  const FlatPoint &a = one.corners_[0], &b = one.corners_[1], &c = two.corners_[0], &d = two.corners_[1];
  const double left = cross(a, b, c), right = cross(a, b, d), share = left / (left - right);
  const double length = distance(c, d), along = distance(a, b);
  const FlatPoint p{c.x + (d.x - c.x) * share, c.y + (d.y - c.y) * share};
  const double at = ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / along;
  const bool is_near = std::fabs(share - 0.5) * length <= 0.5 * length + reach &&
                       std::fabs(at - 0.5 * along) <= 0.5 * along + reach;
  if (is_near) corners_.assign(1, p);
}

double FlatPolygon::depth_of(const FlatPoint& p) const {
  if (corners_.size() < 3) return -std::numeric_limits<double>::infinity();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners_.size(); ++i)
    least = std::min(least, to_the_left(corners_[i], corners_[(i + 1) % corners_.size()], p));
  return least;
}

FlatPoint FlatPolygon::middle() const {
  FlatPoint sum;
  for (const FlatPoint& p : corners_) {
    sum.x += p.x;
    sum.y += p.y;
  }
  const double share = corners_.empty() ? 0.0 : 1.0 / static_cast<double>(corners_.size());
  return {sum.x * share, sum.y * share};
}

}  // namespace raygauge
