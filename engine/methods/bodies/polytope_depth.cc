// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/bodies/polytope_depth.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "engine/methods/spatial/nearest_of_segments.h"
#include "engine/numerics/fused.h"

namespace raygauge {
namespace {

constexpr double kParallel = 1e-6;        // sine of an angle
constexpr double kTurned = 32 * 0x1p-53;  // of n, relative to |e_1||e_2|/|e_1 × e_2|
constexpr double kNearby = 1e-8;          // of the size: more than what is lost

}  // namespace

RAYGAUGE_VECTORS void PolytopeDepth::place(const PolytopeFaces& from, const Matrix3& R, const Vector3& t,
                                           PolytopeFaces& placed) noexcept {
  placed.place_mirrored(from, R, t);
  const Vector3 a = R.column[0], b = R.column[1], c = R.column[2];
  for (int i = 0; i < kEdges; ++i) {
    const double x = from.way[0][i], y = from.way[1][i], z = from.way[2][i];
    placed.way[0][i] = a.x * x + b.x * y + c.x * z;
    placed.way[1][i] = a.y * x + b.y * y + c.y * z;
    placed.way[2][i] = a.z * x + b.z * y + c.z * z;
  }
}

RAYGAUGE_VECTORS void PolytopeDepth::measure_heights(const PolytopeFaces& of, const PolytopeFaces& other,
                                                     double* height) noexcept {
  using Pack [[gnu::vector_size(4 * sizeof(double)), gnu::may_alias]] = double;
  const auto* const nx = reinterpret_cast<const Pack*>(of.normal[0]);
  const auto* const ny = reinterpret_cast<const Pack*>(of.normal[1]);
  const auto* const nz = reinterpret_cast<const Pack*>(of.normal[2]);
  auto* const out = reinterpret_cast<Pack*>(height);
  for (int i = 0; 4 * i < of.facets; ++i) {
    Pack sum{};
    for (const PolytopeFaces* body : {&of, &other}) {
      Pack most = Pack{} - std::numeric_limits<double>::infinity();
      for (int k = 0; k < body->corners; ++k) {
        const Pack here =
            nx[i] * body->corner[0][k] + ny[i] * body->corner[1][k] + nz[i] * body->corner[2][k];
        most = here > most ? here : most;
      }
      sum += most;
    }
    out[i] = sum;
  }
}

// With L, R the normals beside an edge e, along L × R, and those beside f likewise: the arcs from L to R
// cross where the products (L_e·f)(R_e·f), (L_f·e)(R_f·e) and, as they cross on the same side of the origin,
// (L_e·f)(L_f·e) are not above 0. Where |L·f| is so small that rounding hides its sign, a product is at most
// that times an edge's length.
RAYGAUGE_VECTORS void PolytopeDepth::list_crossings(const PolytopeFaces& of, const PolytopeFaces& other,
                                                    double hidden, std::uint32_t* crossings) noexcept {
  using Pack [[gnu::vector_size(4 * sizeof(double)), gnu::may_alias]] = double;
  using Bits [[gnu::vector_size(4 * sizeof(double))]] = std::int64_t;
  constexpr int kPacks = kEdges / 4;
  const int packs = (other.edges + 3) / 4;
  alignas(64) double beside[2][3][kEdges];  // L_f and R_f
  for (int k = 0; k < 4 * packs; ++k) {
    for (int j = 0; j < 3; ++j) {
      beside[0][j][k] = other.normal[j][other.left[k]];
      beside[1][j][k] = other.normal[j][other.right[k]];
    }
  }
  const auto pack = [](const double* row, int k) { return reinterpret_cast<const Pack*>(row)[k]; };
  Pack along[kFacets][kPacks];
  for (int k = 0; k < packs; ++k) {
    const Pack x = pack(other.way[0], k), y = pack(other.way[1], k), z = pack(other.way[2], k);
    for (int i = 0; i < of.facets; ++i)
      along[i][k] = x * of.normal[0][i] + y * of.normal[1][i] + z * of.normal[2][i];
  }
  for (int i = 0; i < of.edges; ++i) {
    const double x = of.way[0][i], y = of.way[1][i], z = of.way[2][i];
    const Pack *const of_left = along[of.left[i]], *const of_right = along[of.right[i]];
    Bits found{}, bit = {1, 2, 4, 8};
    for (int k = 0; k < packs; ++k, bit <<= 4) {
      const auto of_e = [&](const double(*n)[kEdges]) {
        return x * pack(n[0], k) + y * pack(n[1], k) + z * pack(n[2], k);
      };
      const Pack left = of_e(beside[0]), right = of_e(beside[1]);
      const Pack one = of_left[k] * of_right[k], two = left * right, both = of_left[k] * left;
      Pack most = one > two ? one : two;
      most = both > most ? both : most;
      found |= (most <= hidden) & bit;
    }
    crossings[i] = static_cast<std::uint32_t>(found[0] | found[1] | found[2] | found[3]);
  }
}

// False where more are near than there is room for.
bool PolytopeDepth::take(double height, double lower, const Vector3& n, int edge_1, int edge_2) noexcept {
  lower_ = std::min(lower_, lower);
  if (height > height_ + kNearby * size_) return true;
  if (height < height_) {
    height_ = height;
    normal_ = n;
    edge_[0] = edge_1;
    edge_[1] = edge_2;
    count_ = static_cast<int>(
        std::remove_if(near_, near_ + count_,
                       [&](const Near& each) { return each.height > height + kNearby * size_; }) -
        near_);
  }
  if (count_ == kNear) return false;
  near_[count_++] = {height, n};
  return true;
}

bool PolytopeDepth::take_facets(const PolytopeFaces& of, const PolytopeFaces& other) noexcept {
  alignas(64) double height[kFacets];
  measure_heights(of, other, height);
  for (int i = 0; i < of.facets; ++i)
    if (!take(height[i], height[i] - (of.turned + kHeight) * size_, of.normal_at(i), -1, -1)) return false;
  return true;
}

// Of both arcs the middle is on the same side as the crossing. Far facets are told by squares, on the side of
// one arc.
bool PolytopeDepth::take_edges(int edge_1, int edge_2) noexcept {
  const Vector3 e = first_->way_at(edge_1), f = second_.way_at(edge_2), across = cross(e, f);
  const double square = dot(across, across), product = dot(e, e) * dot(f, f);
  if (!(square > kParallel * kParallel * product)) return false;
  const auto side_of = [&](const PolytopeFaces& of, int i) {
    return dot(across, of.normal_at(of.left[i]) + of.normal_at(of.right[i]));
  };
  const auto is_certain = [&](double side) { return side * side > kParallel * kParallel * square; };
  const double of_1 = side_of(*first_, edge_1);
  if (!is_certain(of_1)) return false;
  const double along =
      dot(across, first_->corner_at(first_->from[edge_1]) + second_.corner_at(second_.from[edge_2]));
  const double reach = of_1 > 0 ? along : -along, far = height_ + 2 * kNearby * size_;
  if (reach > 0 && reach * reach > far * far * square) return true;
  const double of_2 = side_of(second_, edge_2);
  if (!is_certain(of_2)) return false;
  if ((of_1 > 0) != (of_2 > 0)) return true;
  const double scale = 1 / std::sqrt(square), height = reach * scale;
  return take(height, height - (kTurned * std::sqrt(product) * scale + kHeight) * size_,
              across * (of_1 > 0 ? scale : -scale), edge_1, edge_2);
}

bool PolytopeDepth::take_all_edges() noexcept {
  const double hidden = (std::max(first_->turned, second_.turned) + kTurned) * 4 * size_ * size_;
  std::uint32_t crossings[kEdges];
  list_crossings(*first_, second_, hidden, crossings);
  const std::uint32_t all = (std::uint32_t{1} << second_.edges) - 1;
  for (int i = 0; i < first_->edges; ++i)
    for (std::uint32_t left = crossings[i] & all; left != 0; left &= left - 1)
      if (!take_edges(i, std::countr_zero(left))) return false;
  return true;
}

bool PolytopeDepth::solve(const PolytopeFaces& first, const PolytopeFaces& second, const Matrix3& R,
                          const Vector3& t, double defect, double size) noexcept {
  if (!(size > kSmallest && size < kLargest)) return false;
  first_ = &first;
  second_.corners = second.corners;
  second_.facets = second.facets;
  second_.edges = second.edges;
  second_.turned = second.turned + 4 * defect + kTurned;
  std::copy_n(second.from, kEdges, second_.from);
  std::copy_n(second.left, kEdges, second_.left);
  std::copy_n(second.right, kEdges, second_.right);
  place(second, R, t, second_);
  size_ = size;
  lower_ = height_ = std::numeric_limits<double>::max();
  count_ = 0;
  if (!take_facets(first, second_) || !take_facets(second_, first) || !(lower_ > 0) || !take_all_edges())
    return false;
  upper_ = kHeight * size;
  for (const PolytopeFaces* body : {first_, static_cast<const PolytopeFaces*>(&second_)}) {
    double most = -std::numeric_limits<double>::infinity();
    for (int k = 0; k < body->corners; ++k) most = std::max(most, dot(body->corner_at(k), normal_));
    upper_ += most;
  }
  return lower_ > 0;
}

bool PolytopeDepth::find_contact(Vector3& of_first) const noexcept {
  if (edge_[0] >= 0) {
    const Vector3 x = first_->way_at(edge_[0]) * 0.5, y = second_.way_at(edge_[1]) * 0.5;
    const Vector3 p = first_->corner_at(first_->from[edge_[0]]) + x,
                  q = y - second_.corner_at(second_.from[edge_[1]]);
    double s = 0, r = 0;
    nearest_of_segments(p, x, q, y, s, r);
    of_first = p + x * s;
    return true;
  }
  const auto highest = [&](const PolytopeFaces& of, Vector3& corner) {
    double most = -std::numeric_limits<double>::infinity(), next = most;
    for (int k = 0; k < of.corners; ++k) {
      const Vector3 x = of.corner_at(k);
      const double here = dot(x, normal_);
      next = std::max(next, std::min(here, most));
      if (here > most) corner = x;
      most = std::max(here, most);
    }
    return most - next > kNearby * size_;
  };
  Vector3 corner;
  if (highest(*first_, of_first)) return true;
  const bool is_one = highest(second_, corner);
  of_first = normal_ * height_ - corner;
  return is_one;
}

}  // namespace raygauge
