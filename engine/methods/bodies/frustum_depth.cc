// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/bodies/frustum_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/methods/spatial/nearest_of_segments.h"
#include "engine/numerics/fused.h"

namespace raygauge {
namespace {

constexpr double kLost = 512 * 0x1p-53;  // of a height, relative to the size
constexpr double kNearby = 1e-8;         // of the size: more than what is lost
constexpr double kInfinite = std::numeric_limits<double>::infinity();

}  // namespace

// The frustum's base, the larger disc, is across the third axis, about the origin.
bool FrustumDepth::place(const SpatialShape& frustum, const Matrix3& R, const Vector3& t) noexcept {
  const bool is_turned = frustum.top_radius > frustum.base_radius;
  const Vector3 a = is_turned ? -frustum.axis.column[0] : frustum.axis.column[0], e = any_orthogonal(a);
  basis_ = {{e, cross(a, e), a}};
  base_ = is_turned ? frustum.top : frustum.base;
  const double base = std::max(frustum.base_radius, frustum.top_radius),
               top = std::min(frustum.base_radius, frustum.top_radius);
  frustum_ = {base, top, frustum.full, std::fabs(frustum.side_along), frustum.side_across};
  R_ = R;
  t_ = t;
  return frustum_.full > kNearby * size_ && base > kNearby * size_;
}

// The corners are those of base - P.
void FrustumDepth::place_other() noexcept {
  Vector3 way = t_;
  for (int j = 0; j < 3; ++j) {
    const Vector3 row{(&R_.column[0].x)[j], (&R_.column[1].x)[j], (&R_.column[2].x)[j]};
    turn_.column[j] = basis_.transposed_times(body_ == 0 ? R_.column[j] : row);
  }
  if (body_ != 0) way = -R_.transposed_times(t_);
  way = basis_.transposed_times(way - base_);
  placed_.corners = other_->corners;
  placed_.facets = other_->facets;
  if (other_->facets > 0) return placed_.place_mirrored(*other_, turn_, way);
  for (int i = 0; i < other_->corners; ++i) {
    const Vector3 x = -(turn_ * other_->corner_at(i) + way);
    for (int k = 0; k < 3; ++k) placed_.corner[k][i] = (&x.x)[k];
  }
}

// The point of the frustum and the height of the sum for the normal of each facet.
RAYGAUGE_VECTORS void FrustumDepth::measure_facets(const UprightFrustum& frustum, PolytopeFaces& of,
                                                   double (*point)[kFacets], double* height) noexcept {
  using Pack [[gnu::vector_size(4 * sizeof(double)), gnu::may_alias]] = double;
  const UprightFrustum f = frustum;
  constexpr double kAlongAxis = 1e-14;
  for (int i = 0; i < kFacets; ++i) {
    const double x = of.normal[0][i], y = of.normal[1][i], z = of.normal[2][i];
    const double rho = std::sqrt(x * x + y * y), inverse = 1 / rho;
    const bool is_top = z > f.along;
    const double radius = is_top ? f.top : f.base, scale = rho > kAlongAxis ? radius * inverse : 0.0;
    point[0][i] = x * scale;
    point[1][i] = y * scale;
    point[2][i] = is_top ? f.full : 0.0;
    const double of_top = z * f.full + f.top * rho, of_base = f.base * rho;
    height[i] = of_top > of_base ? of_top : of_base;
  }
  const auto* const nx = reinterpret_cast<const Pack*>(of.normal[0]);
  const auto* const ny = reinterpret_cast<const Pack*>(of.normal[1]);
  const auto* const nz = reinterpret_cast<const Pack*>(of.normal[2]);
  auto* const out = reinterpret_cast<Pack*>(height);
  for (int i = 0; 4 * i < of.facets; ++i) {
    Pack most = Pack{} - std::numeric_limits<double>::infinity();
    for (int k = 0; k < of.corners; ++k) {
      const Pack here = nx[i] * of.corner[0][k] + ny[i] * of.corner[1][k] + nz[i] * of.corner[2][k];
      most = here > most ? here : most;
    }
    out[i] += most;
  }
}

// F - P is D, or its mirror image.
Vector3 FrustumDepth::to_first(const Vector3& u) const noexcept {
  const Vector3 own = basis_ * u;
  return body_ == 0 ? own : -(R_ * own);
}

Vector3 FrustumDepth::point_in_first(const Vector3& of_frustum) const noexcept {
  const Vector3 own = base_ + basis_ * of_frustum;
  return body_ == 0 ? own : R_ * (own - basis_ * (at_ * height_)) + t_;
}

double FrustumDepth::height_of_corners(const Vector3& u) const noexcept {
  double most = -kInfinite;
  for (int k = 0; k < placed_.corners; ++k) most = std::max(most, dot(placed_.corner_at(k), u));
  return most;
}

// False where the origin is outside, or more are near than there is room for.
bool FrustumDepth::take(double height, double lower, const Vector3& u) noexcept {
  lower_ = std::min(lower_, lower);
  if (height > height_ + kNearby * size_) return true;
  if (height < height_) {
    height_ = height;
    at_ = u;
    count_ = static_cast<int>(
        std::remove_if(near_, near_ + count_,
                       [&](const Near& each) { return each.height > height + kNearby * size_; }) -
        near_);
  }
  if (count_ == kNear || !(height > 0)) return false;
  near_[count_++] = {height, u};
  return true;
}

bool FrustumDepth::take_discs() noexcept {
  const Vector3 up{0, 0, 1};
  const double above = frustum_.full + height_of_corners(up), below = height_of_corners(-up);
  return take(above, above - lost_, up) && take(below, below - lost_, -up);
}

// For a corner q the height of the side is not below  k + along q_z - across |q_⊥|. Where |q_⊥| is small, a
// direction against it may be another one by rounding.
bool FrustumDepth::take_side() noexcept {
  constexpr double kOnAxis = 1e-6;
  const double of_side = frustum_.base * frustum_.across;
  for (int k = 0; k < placed_.corners; ++k) {
    const Vector3 q = placed_.corner_at(k);
    const double rho = std::sqrt(q.x * q.x + q.y * q.y);
    const double least = of_side + frustum_.along * q.z - frustum_.across * rho;
    if (least > height_ + kNearby * size_) continue;
    if (!(rho > kOnAxis * size_)) return false;
    const double scale = -frustum_.across / rho;
    const Vector3 u{q.x * scale, q.y * scale, frustum_.along};
    const double height = of_side + height_of_corners(u);
    if (!take(height, height - lost_ * (1 + size_ / rho), u)) return false;
  }
  return true;
}

bool FrustumDepth::take_facets() noexcept {
  measure_facets(frustum_, placed_, point_, facet_);
  for (int i = 0; i < placed_.facets; ++i)
    if (!take(facet_[i], facet_[i] - lost_, placed_.normal_at(i))) return false;
  return true;
}

// Those that may be lower than what is known. With the points p_1, p_2 of D for both ends n_1, n_2 the height
// is nowhere below that of the line through both across the edge, h with
//
//     h² = ((p_1·n_1)(p_2·n_2) - (p_1·n_2)(p_2·n_1))² / (x² + y² - 2 x y n_1·n_2),
//
// x = (p_2 - p_1)·n_1, y = (p_2 - p_1)·n_2.
int FrustumDepth::list_arcs(Arc* arcs) const noexcept {
  constexpr double kMargin = 1e-6;  // of the size: far above what is lost where points are so far apart
  int count = 0;
  for (int k = 0; k < other_->edges; ++k) {
    const int i = other_->left[k], j = other_->right[k];
    const Vector3 n_1 = placed_.normal_at(i), n_2 = placed_.normal_at(j),
                  q = placed_.corner_at(other_->from[k]);
    if (n_1.z > frustum_.along && n_2.z > frustum_.along && !(frustum_.top > 0)) continue;  // of the tip
    const Vector3 p_1 = q + Vector3{point_[0][i], point_[1][i], point_[2][i]},
                  p_2 = q + Vector3{point_[0][j], point_[1][j], point_[2][j]};
    const double h_1 = facet_[i], h_2 = facet_[j], of_2 = dot(p_1, n_2), of_1 = dot(p_2, n_1);
    const double x = of_1 - h_1, y = h_2 - of_2, area = h_1 * h_2 - of_1 * of_2,
                 square = x * x + y * y - 2 * x * y * dot(n_1, n_2), least = height_ + kMargin * size_;
    if (area > 0 && square > kMargin * size_ * size_ && area * area > least * least * square) continue;
    arcs[count++] = {area > 0 && square > 0 ? area * area / square : 0.0, k};
  }
  std::sort(arcs, arcs + count, [](const Arc& a, const Arc& b) { return a.bound < b.bound; });
  return count;
}

bool FrustumDepth::take_found() noexcept {
  if (arc_.height() < height_ * (1 + 4 * gap_) + kNearby * size_) {
    if (arc_.is_ring()) return false;
    arc_.settle();
  }
  return take(arc_.height(), arc_.lower() - lost_, arc_.normal());
}

bool FrustumDepth::take_arc(int edge) noexcept {
  constexpr double kSame = 1e-9;
  const int i = other_->left[edge], j = other_->right[edge];
  const Vector3 n_1 = placed_.normal_at(i), n_2 = placed_.normal_at(j), way = turn_ * other_->way_at(edge);
  const double away = length(n_2 - n_1);
  if (away < kSame) {
    lower_ = std::min(lower_, facet_[i] - away * size_ - lost_);
    return true;
  }
  if (!arc_.set_edge(way * (1 / length(way)), n_1, placed_.corner_at(other_->from[edge]))) return false;
  const double x = arc_.along(n_2, 0), y = arc_.along(n_2, 1), size = std::sqrt(x * x + y * y);
  return y > 0 && arc_.search(1, 0, x / size, y / size, height_, gap_) && take_found();
}

// All directions across a segment.
bool FrustumDepth::take_circle() noexcept {
  constexpr double kUpright = 1e-3;
  const Vector3 way = placed_.corner_at(1) - placed_.corner_at(0), e = way * (1 / length(way));
  const Vector3 up{0, 0, 1}, across = cross(e, up);
  const bool is_upright = !(dot(across, across) > kUpright * kUpright);
  if (!arc_.set_edge(e, is_upright ? any_orthogonal(e) : cross(across, e), placed_.corner_at(0)))
    return false;
  constexpr double kHalf = 0.70710678118654752;  // no end is along the axis, where the least is searched for
  constexpr double kQuarter[5][2] = {
      {kHalf, kHalf}, {-kHalf, kHalf}, {-kHalf, -kHalf}, {kHalf, -kHalf}, {kHalf, kHalf}};
  for (int i = 0; i < 4; ++i) {
    const double *const from = kQuarter[i], *const to = kQuarter[i + 1];
    if (!arc_.search(from[0], from[1], to[0], to[1], height_, gap_) || !take_found()) return false;
  }
  return true;
}

bool FrustumDepth::solve(const SpatialShape& frustum, int body, const PolytopeFaces& other, const Matrix3& R,
                         const Vector3& t, double defect, double size, double gap) noexcept {
  if (!(size > kSmallest && size < kLargest)) return false;
  size_ = size;
  gap_ = gap;
  body_ = body;
  other_ = &other;
  if (!place(frustum, R, t)) return false;
  place_other();
  lost_ = (kLost + other.turned + 4 * defect) * size;
  arc_.begin(frustum_, size);
  lower_ = height_ = std::numeric_limits<double>::max();
  count_ = 0;
  if (!take_discs() || !take_facets() || !take_side()) return false;
  if (other.facets > 0) {
    Arc arcs[kEdges];
    const int count = list_arcs(arcs);
    for (int i = 0; i < count; ++i)
      if (!take_arc(arcs[i].edge)) return false;
  } else if (other.edges > 0 && !take_circle()) {
    return false;
  }
  const double rho = std::sqrt(at_.x * at_.x + at_.y * at_.y);
  height_ =
      height_of_corners(at_) + std::max(frustum_.base * rho, frustum_.full * at_.z + frustum_.top * rho);
  upper_ = height_ + kLost * size;
  normal_ = to_first(at_);
  return lower_ > 0;
}

// Of the frustum, where only one point of it is in the plane.
bool FrustumDepth::find_point(Vector3& of_frustum) const noexcept {
  const double rho = std::sqrt(at_.x * at_.x + at_.y * at_.y);
  const double base = frustum_.base * rho, top = frustum_.full * at_.z + frustum_.top * rho;
  const bool is_top = top > base;
  of_frustum = frustum_.point(at_, is_top);
  return std::fabs(top - base) > kNearby * size_ && (rho > kNearby || (is_top && !(frustum_.top > 0)));
}

// A line of the side, and an edge.
bool FrustumDepth::find_line(Vector3& of_frustum) const noexcept {
  Vector3 corner[2];
  int count = 0;
  const double least = height_of_corners(at_) - kNearby * size_;
  for (int k = 0; k < placed_.corners; ++k) {
    const Vector3 q = placed_.corner_at(k);
    if (dot(q, at_) < least) continue;
    if (count == 2) return false;
    corner[count++] = q;
  }
  if (count == 1) {
    of_frustum = at_ * height_ - corner[0];
    return true;
  }
  if (!(at_.x * at_.x + at_.y * at_.y > kNearby)) return false;
  const Vector3 base = frustum_.point(at_, false), top = frustum_.point(at_, true);
  const Vector3 x = (top - base) * 0.5, y = (corner[1] - corner[0]) * 0.5,
                to = at_ * height_ - (corner[0] + corner[1]) * 0.5;
  double s = 0, r = 0;
  nearest_of_segments(base + x, x, to, y, s, r);
  of_frustum = base + x + x * s;
  return true;
}

// Whether a point of the sum is that of the frustum and one of the other body.
bool FrustumDepth::holds(const Vector3& of_frustum, const Vector3& of_other) const noexcept {
  const Vector3 &x = of_frustum, &y = of_other;
  const double margin = kNearby * size_, share = x.z / frustum_.full;
  const double room = frustum_.base + share * (frustum_.top - frustum_.base) + margin;
  if (!(x.z > -margin && x.z < frustum_.full + margin && x.x * x.x + x.y * x.y < room * room)) return false;
  for (int i = 0; i < placed_.facets; ++i) {
    const Vector3 n = placed_.normal_at(i), point{point_[0][i], point_[1][i], point_[2][i]};
    if (dot(n, y + point) > facet_[i] + margin) return false;
  }
  if (placed_.facets > 0) return true;
  const Vector3 way = placed_.corner_at(placed_.corners - 1) - placed_.corner_at(0),
                from = y - placed_.corner_at(0);
  const double square = dot(way, way), t = square > 0 ? std::clamp(dot(from, way) / square, 0.0, 1.0) : 0.0;
  const Vector3 off = from - way * t;
  return dot(off, off) < margin * margin;
}

bool FrustumDepth::find_contact(Vector3& of_first) const noexcept {
  Vector3 of_frustum;
  if (!find_point(of_frustum) && !find_line(of_frustum)) return false;
  if (!holds(of_frustum, at_ * height_ - of_frustum)) return false;
  of_first = point_in_first(of_frustum);
  return true;
}

}  // namespace raygauge
