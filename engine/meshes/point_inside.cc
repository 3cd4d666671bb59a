// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/meshes/point_inside.h"

#include <array>
#include <cmath>

#include "engine/numerics/exact_sum.h"
#include "engine/numerics/precise_vector.h"
#include "engine/numerics/real.h"

namespace raygauge {
namespace {

constexpr int kUnknown = 2;  // of a sign

int sign_of(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

/// A point by its place along the ray and its two coordinates across it.
struct RayPoint {
  double x, y, z;
};

RayPoint turned(const Vector3& v, int axis) {
  if (axis == 0) return {v.x, v.y, v.z};
  if (axis == 1) return {v.y, v.z, v.x};
  return {v.z, v.x, v.y};
}

// The sign of (b - a) × (p - a) across the ray, p moved by (e, e²) for an infinitely small e.
int side(const RayPoint& a, const RayPoint& b, const RayPoint& p) {
  const double left = (b.y - a.y) * (p.z - a.z), right = (b.z - a.z) * (p.y - a.y);
  constexpr double kRounding = 4 * 0x1p-53;  // Shewchuk's bound is 3 units and a little
  if (std::fabs(left - right) > kRounding * (std::fabs(left) + std::fabs(right)) + 0x1p-1000)
    return sign_of(left - right);
  ExactSum sum;
  sum.add_product(b.y, p.z);
  sum.add_product(-b.y, a.z);
  sum.add_product(-a.y, p.z);
  sum.add_product(-b.z, p.y);
  sum.add_product(b.z, a.y);
  sum.add_product(a.z, p.y);
  const ExactSum::Rounded exact = sum.rounded();
  if (std::fabs(exact.value) > exact.error) return sign_of(exact.value);
  if (!sum.is_zero()) return kUnknown;
  return b.z != a.z ? sign_of(a.z - b.z) : sign_of(b.y - a.y);
}

PreciseVector3 difference_of(const RayPoint& a, const RayPoint& b) {
  return {two_sum(a.x, -b.x), two_sum(a.y, -b.y), two_sum(a.z, -b.z)};
}

// The sign of det(a - p, b - p, c - p): on which side of the plane p is.
int side_of_plane(const RayPoint& a, const RayPoint& b, const RayPoint& c, const RayPoint& p) {
  const PreciseVector3 x = difference_of(a, p), y = difference_of(b, p), z = difference_of(c, p);
  const DoubleDouble determinant = dot(x, cross(y, z));
  const double size = length_of(x) * length_of(y) * length_of(z);
  return std::fabs(determinant.high) > 0x1p-96 * size + 0x1p-900 ? sign_of(determinant.high) : kUnknown;
}

/// Counts along one axis.
class Ray {
 public:
  Ray(const Vector3& p, int axis) : axis_(axis), p_(turned(p, axis)) {}

  bool meets(const BoxNode& box) const {
    const auto above = [&](int k, double x) {  // how far x is above the middle, and what the box may reach
      constexpr double kUp = 1 + 1e-9;
      const double reach = box.reach(k) * kUp + std::fabs(x) * 1e-14;
      return std::array<double, 2>{x - double{box.center[k]}, reach};
    };
    const auto [along, reach] = above(axis_, p_.x);
    const auto [y, reach_y] = above((axis_ + 1) % 3, p_.y);
    const auto [z, reach_z] = above((axis_ + 2) % 3, p_.z);
    return along <= reach && std::fabs(y) <= reach_y && std::fabs(z) <= reach_z;
  }

  // False: unknown.
  bool count(const TriangleCorners& t) {
    const RayPoint a = turned(t.corner[0], axis_), b = turned(t.corner[1], axis_),
                   c = turned(t.corner[2], axis_);
    const int ab = side(a, b, p_), bc = side(b, c, p_), ca = side(c, a, p_);
    if (ab == kUnknown || bc == kUnknown || ca == kUnknown) return false;
    if (ab == 0 || ab != bc || ab != ca) return true;
    const int plane = side_of_plane(a, b, c, p_);
    if (plane == kUnknown) return false;
    if (plane == ab) winding_ += ab;  // the triangle is ahead
    return true;
  }

  int winding() const { return winding_; }

 private:
  int axis_;
  RayPoint p_;
  int winding_ = 0;
};

bool count_all(const BoxTree& tree, Ray& ray) {
  constexpr int kDeepest = 64;  // a tree of 2^31 triangles has 31 levels
  std::int32_t open[kDeepest];
  int size = 0;
  open[size++] = 0;
  while (size > 0) {
    const std::int32_t i = open[--size];
    const BoxNode& node = tree.node(i);
    if (!ray.meets(node)) continue;
    if (!node.is_leaf()) {
      open[size++] = node.next;
      open[size++] = i + 1;
      continue;
    }
    for (std::int32_t k = 0; k < node.count; ++k) {
      if (!ray.count(tree.triangle(node.next + k))) return false;
    }
  }
  return true;
}

}  // namespace

Inside point_inside(const BoxTree& tree, const Vector3& p) {
  for (int axis = 0; axis < 3; ++axis) {
    Ray ray(p, axis);
    if (count_all(tree, ray)) return ray.winding() != 0 ? Inside::yes : Inside::no;
  }
  return Inside::unknown;
}

}  // namespace raygauge
