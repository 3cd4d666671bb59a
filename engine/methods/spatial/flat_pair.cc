// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/flat_pair.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/numerics/exact_sum.h"

namespace raygauge {
namespace {

constexpr double kCollinear = 1e-14;  // sine of an angle that is a rounding error

// A body's vertices in the world: R x + t, the numbers of its pose.
struct PlacedVertices {
  const SpatialShape* shape = nullptr;
  double R[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  double t[3] = {0, 0, 0};

  PlacedVertices(const SpatialShape& of, const PoseNumbers& pose, int n) : shape(&of) {
    if (pose.R == nullptr) return;
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n; ++k) R[j][k] = pose.R[k * n + j];
      t[j] = pose.t[j];
    }
  }

  std::int32_t count() const { return static_cast<std::int32_t>(count_vertices(*shape)); }

  // But for rounding.
  Vector3 vertex(std::int32_t i) const {
    const Vector3 x = vertex_of(*shape, i);
    return {R[0][0] * x.x + R[0][1] * x.y + R[0][2] * x.z + t[0],
            R[1][0] * x.x + R[1][1] * x.y + R[1][2] * x.z + t[1],
            R[2][0] * x.x + R[2][1] * x.y + R[2][2] * x.z + t[2]};
  }

  // Adds ± n·(R x + t).
  void add_height(const Vector3& n, const Vector3& point, double sign, ExactSum& sum) const {
    const double x[3] = {point.x, point.y, point.z}, normal[3] = {sign * n.x, sign * n.y, sign * n.z};
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) {
        const DoubleDouble factor = two_product(normal[j], R[j][k]);
        sum.add_product(factor.high, x[k]);
        sum.add_product(factor.low, x[k]);
      }
      sum.add_product(normal[j], t[j]);
    }
  }
};

class FlatPair {
 public:
  FlatPair(SpatialPair& pair, bool with_centers)
      : pair_(pair),
        with_centers_(with_centers),
        body_{{pair.shape(0), pair.pose(0), pair.dimension()},
              {pair.shape(1), pair.pose(1), pair.dimension()}} {}

  bool run();

 private:
  bool share_pose() const;
  int candidates(Vector3* normal) const;
  bool holds_all(const Vector3& normal) const;

  // what(direction) for all vectors from the first vertex of the first body to others.
  template <class What>
  void for_directions(const What& what) const {
    const Vector3 from = body_[0].vertex(0);
    for (const PlacedVertices& body : body_) {
      for (std::int32_t i = 0; i < body.count(); ++i) what(body.vertex(i) - from);
    }
  }

  SpatialPair& pair_;
  bool with_centers_;
  PlacedVertices body_[2];
};

// D turned by a common rotation is as flat as it was, whatever rounding does to the rotation.
bool FlatPair::share_pose() const {
  return std::equal(&body_[0].R[0][0], &body_[0].R[0][0] + 9, &body_[1].R[0][0]) &&
         std::equal(body_[0].t, body_[0].t + 3, body_[1].t);
}

// The normal of the plane, or two of the line, that all vectors would be in; three of a point.
int FlatPair::candidates(Vector3* normal) const {
  Vector3 longest, across;
  double square = 0;
  for_directions([&](const Vector3& v) {
    if (!(dot(v, v) > square)) return;
    square = dot(v, v);
    longest = v;
  });
  double area = kCollinear * kCollinear * square * square;
  for_directions([&](const Vector3& v) {
    const Vector3 n = cross(longest, v);
    if (!(dot(n, n) > area)) return;
    area = dot(n, n);
    across = n;
  });
  const Vector3 axis[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const int n = pair_.dimension();
  if (!(square > 0)) {
    std::copy_n(axis, n, normal);
    return n;
  }
  if (dot(across, across) > 0) {
    normal[0] = across;
    return n - 2;
  }
  Vector3 of_line[3];
  for (int k = 0; k < 3; ++k) of_line[k] = cross(axis[k], longest);
  std::sort(of_line, of_line + 3, [](const Vector3& v, const Vector3& w) { return dot(v, v) > dot(w, w); });
  if (n == 2) of_line[0] = cross(axis[2], longest);
  std::copy_n(of_line, n - 1, normal);
  return n - 1;
}

// Whether D is across the normal, and the way between the centres if that is asked for, without rounding.
bool FlatPair::holds_all(const Vector3& normal) const {
  const Vector3 from = vertex_of(*body_[0].shape, 0);
  const auto holds = [&](const PlacedVertices& body, const Vector3& point) {
    ExactSum sum;
    body.add_height(normal, point, 1, sum);
    body_[0].add_height(normal, from, -1, sum);
    return sum.is_zero();
  };
  for (const PlacedVertices& body : body_) {
    if (with_centers_ && !holds(body, body.shape->center)) return false;
    for (std::int32_t i = 0; i < body.count(); ++i) {
      if (!holds(body, vertex_of(*body.shape, i))) return false;
    }
  }
  return true;
}

bool FlatPair::run() {
  if (pair_.radius() > 0 || body_[0].count() == 0 || body_[1].count() == 0) return false;
  const bool shared = share_pose();
  if (shared) {
    for (int i = 0; i < 2; ++i) body_[i] = {pair_.shape(i), PoseNumbers(), pair_.dimension()};
  }
  Vector3 normal[3];
  const int count = candidates(normal);
  for (int i = 0; i < count; ++i) {
    if (!holds_all(normal[i])) return false;
  }
  for (int i = 0; i < count; ++i) {
    const double n[3] = {normal[i].x, normal[i].y, normal[i].z};
    const Vector3 v = shared ? normal[i] : pair_.frame().to_body(n);
    pair_.add_prism(v * (pair_.size() / length(v)));
  }
  return count > 0;
}

}  // namespace

bool make_prism_of_flat(SpatialPair& pair, bool with_centers) { return FlatPair(pair, with_centers).run(); }

}  // namespace raygauge
