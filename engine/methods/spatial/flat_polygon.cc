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

double distance(const FlatPoint& a, const FlatPoint& b) { return std::sqrt(square(a, b)); }

// Of p from the line through a and b, to its left.
double to_the_left(const FlatPoint& a, const FlatPoint& b, const FlatPoint& p) {
  const double size = distance(a, b);
  return size > 0 ? cross(a, b, p) / size : -distance(a, p);
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

// True where the points are as good as one or two.
bool FlatPolygon::shrink(double noise) {
  const FlatPoint first = farthest(corners_, middle()), second = farthest(corners_, first);
  const double width = distance(first, second);
  const bool is_point = !(width > noise);
  const auto wide = [&](const FlatPoint& p) { return std::fabs(cross(first, second, p)) > noise * width; };
  if (!is_point && std::any_of(corners_.begin(), corners_.end(), wide)) return false;
  corners_.assign(1, first);
  if (!is_point) corners_.push_back(second);
  return true;
}

// The monotone chain (Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979).
void FlatPolygon::make_hull(double noise) {
  if (corners_.size() < 2 || shrink(noise)) return;
  std::sort(corners_.begin(), corners_.end(),
            [](const FlatPoint& a, const FlatPoint& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
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
  corners_.clear();
  const std::size_t count = other_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const FlatPoint& before = corners_.empty() ? other_.back() : corners_.back();
    if (-to_the_left(before, other_[(i + 1) % count], other_[i]) > noise) corners_.push_back(other_[i]);
  }
  if (count >= 3 && corners_.size() < 3) corners_ = other_;
}

void FlatPolygon::cut(const FlatPoint& a, double x, double y, double offset, std::int32_t number) {
  const double size = std::sqrt(x * x + y * y);
  if (!(size > 0) || corners_.empty()) return;
  const auto area = [&](const FlatPoint& p) { return x * (p.y - a.y) - y * (p.x - a.x); };
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
