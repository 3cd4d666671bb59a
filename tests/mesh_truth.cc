// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/mesh_truth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "raygauge/numerics/quad.h"

namespace raygauge::testing {
namespace {

constexpr double kSure = 1e-9;       // relative to the size: long double errs by less
constexpr double kSame = 1e-28;      // relative to the size: what quadruple precision cannot tell from 0
constexpr double kParallel = 1e-16;  // relative to the size: what parallel edges take away

template <class Real>
struct Point {
  Real x, y, z;
  Point operator+(const Point& b) const { return {x + b.x, y + b.y, z + b.z}; }
  Point operator-(const Point& b) const { return {x - b.x, y - b.y, z - b.z}; }
  Point operator*(Real s) const { return {x * s, y * s, z * s}; }
};

template <class Real>
Real dot(const Point<Real>& a, const Point<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Real>
Point<Real> cross(const Point<Real>& a, const Point<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Real>
using Triangle = std::array<Point<Real>, 3>;

template <class Real>
Point<Real> placed(const Pose& at, const Eigen::Vector3d& v) {
  const double *R = at.rotation_data(), *t = at.translation_data();
  const auto row = [&](int i) {
    return Real(R[i]) * v[0] + Real(R[i + 3]) * v[1] + Real(R[i + 6]) * v[2] + Real(t[i]);
  };
  return {row(0), row(1), row(2)};
}

template <class Real>
Triangle<Real> corners(const MeshShape& mesh, const Pose& at, std::size_t number) {
  const MeshTriangle& t = mesh.triangles[number];
  return {placed<Real>(at, mesh.vertices.col(t[0])), placed<Real>(at, mesh.vertices.col(t[1])),
          placed<Real>(at, mesh.vertices.col(t[2]))};
}

template <class Real>
Real clamped(Real s) {
  return s > 0 ? (s < 1 ? s : Real(1)) : Real(0);  // NaN: 0
}

// The squared distance of p and the segment from a along d.
template <class Real>
Real to_segment(const Point<Real>& p, const Point<Real>& a, const Point<Real>& d) {
  const Point<Real> far = p - a;
  const Point<Real> off = far - d * clamped(dot(far, d) / dot(d, d));
  return dot(off, off);
}

// Of two segments that are nearest to each other inside, else more than that.
template <class Real>
Real of_segments(const Point<Real>& a, const Point<Real>& d, const Point<Real>& b, const Point<Real>& e) {
  const Point<Real> w = b - a, n = cross(d, e);
  const Real nn = dot(n, n);
  const Real s = clamped(dot(cross(w, e), n) / nn), t = clamped(dot(cross(w, d), n) / nn);
  const Point<Real> off = w + e * t - d * s;
  return dot(off, off);
}

// Of a point and a triangle that is nearest to it inside, else infinite.
template <class Real>
Real to_inside(const Point<Real>& p, const Triangle<Real>& t, const Point<Real>& normal) {
  for (int k = 0; k < 3; ++k) {
    const Point<Real>&a = t[static_cast<std::size_t>(k)], &b = t[static_cast<std::size_t>((k + 1) % 3)];
    if (!(dot(cross(b - a, p - a), normal) >= 0)) return std::numeric_limits<double>::infinity();
  }
  const Real high = dot(p - t[0], normal), nn = dot(normal, normal);
  return nn > 0 ? high * high / nn : Real(std::numeric_limits<double>::infinity());
}

enum class Way : std::uint8_t { past, touches, crosses };

// How the segment from p to q goes by the triangle; `past` where it lies in its plane.
template <class Real>
Way way_of(const Point<Real>& p, const Point<Real>& q, const Triangle<Real>& t, const Point<Real>& normal) {
  const Real from = dot(p - t[0], normal), to = dot(q - t[0], normal);
  if ((from > 0 && to > 0) || (from < 0 && to < 0) || from == to) return Way::past;
  int positive = 0, negative = 0;
  for (int k = 0; k < 3; ++k) {
    const Point<Real> a = t[static_cast<std::size_t>(k)] - p,
                      b = t[static_cast<std::size_t>((k + 1) % 3)] - p;
    const Real side = dot(cross(a, b), q - p);
    positive += side > 0 ? 1 : 0;
    negative += side < 0 ? 1 : 0;
  }
  if (positive > 0 && negative > 0) return Way::past;
  return positive + negative == 3 && from != 0 && to != 0 ? Way::crosses : Way::touches;
}

// -1 of triangles that cross each other.
template <class Real>
Real squared_distance(const Triangle<Real>& s, const Triangle<Real>& t, bool may_cross = true) {
  Real least = std::numeric_limits<double>::infinity();
  const auto take = [&](Real d) {
    if (d < least) least = d;
  };
  for (const auto& [from, to] : {std::pair(&s, &t), std::pair(&t, &s)}) {
    const Point<Real> normal = cross((*to)[1] - (*to)[0], (*to)[2] - (*to)[0]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Point<Real>&p = (*from)[k], &q = (*from)[(k + 1) % 3];
      const Way way = may_cross ? way_of(p, q, *to, normal) : Way::past;
      if (way == Way::crosses) return -1;
      if (way == Way::touches) take(0);
      take(to_inside(p, *to, normal));
      for (std::size_t m = 0; m < 3; ++m) take(to_segment(p, (*to)[m], (*to)[(m + 1) % 3] - (*to)[m]));
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t m = 0; m < 3; ++m)
      take(of_segments(s[k], s[(k + 1) % 3] - s[k], t[m], t[(m + 1) % 3] - t[m]));
  }
  return least;
}

// A ball about each triangle.
struct Balls {
  Balls(const MeshShape& mesh, const Pose& at) : center(3, static_cast<Eigen::Index>(mesh.triangles.size())) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      Eigen::Matrix3d p;
      for (int k = 0; k < 3; ++k)
        p.col(k) = at.apply(mesh.vertices.col(mesh.triangles[i][static_cast<std::size_t>(k)]));
      const Eigen::Vector3d middle = p.rowwise().mean();
      center.col(static_cast<Eigen::Index>(i)) = middle;
      radius.push_back((p.colwise() - middle).colwise().norm().maxCoeff() * (1 + kSure));
      size = std::max(size, p.cwiseAbs().maxCoeff());
    }
  }

  Eigen::Matrix3Xd center;
  std::vector<double> radius;
  double size = 0;
};

// A pair of triangles, and how near their balls are.
struct Candidate {
  double lower;
  std::int32_t s, t;
};

// All pairs, the nearest balls first.
std::vector<Candidate> all_pairs(const Balls& first, const Balls& second) {
  std::vector<Candidate> pairs;
  pairs.reserve(first.radius.size() * second.radius.size());
  double least = std::numeric_limits<double>::infinity();  // of the distances' upper bounds
  for (std::size_t s = 0; s < first.radius.size(); ++s) {
    const Eigen::Vector3d from = first.center.col(static_cast<Eigen::Index>(s));
    for (std::size_t t = 0; t < second.radius.size(); ++t) {
      const double far = (second.center.col(static_cast<Eigen::Index>(t)) - from).norm(),
                   radii = first.radius[s] + second.radius[t];
      if (far - radii > least) continue;
      least = std::min(least, far + radii);
      pairs.push_back({far - radii, static_cast<std::int32_t>(s), static_cast<std::int32_t>(t)});
    }
  }
  std::erase_if(pairs, [&](const Candidate& pair) { return pair.lower > least; });
  std::ranges::sort(pairs, {}, &Candidate::lower);
  return pairs;
}

// Of two triangles that meet by doubles, those of edges in the other one's plane may be apart.
double rough_distance(const MeshShape& one, const Pose& at_1, std::size_t s, const MeshShape& two,
                      const Pose& at_2, std::size_t t) {
  const double square = squared_distance(corners<double>(one, at_1, s), corners<double>(two, at_2, t));
  if (square > 0) return std::sqrt(square);
  const Quad sure = squared_distance(corners<Quad>(one, at_1, s), corners<Quad>(two, at_2, t));
  return sure > 0 ? std::sqrt(static_cast<double>(sure)) : 0.0;
}

// Those that may be the nearest ones, by doubles.
std::vector<Candidate> near_pairs(const MeshShape& one, const Pose& at_1, const MeshShape& two,
                                  const Pose& at_2, double& size) {
  const Balls first(one, at_1), second(two, at_2);
  size = std::max(first.size, second.size);
  const double margin = kSure * size;
  std::vector<Candidate> found;
  double least = std::numeric_limits<double>::infinity();
  for (const Candidate& pair : all_pairs(first, second)) {
    if (pair.lower > least + margin) break;
    const double d = rough_distance(one, at_1, static_cast<std::size_t>(pair.s), two, at_2,
                                    static_cast<std::size_t>(pair.t));
    least = std::min(least, d);
    if (d <= least + margin) found.push_back({d, pair.s, pair.t});
  }
  std::erase_if(found, [&](const Candidate& pair) { return pair.lower > least + margin; });
  std::ranges::sort(found, {}, &Candidate::lower);
  return found;
}

}  // namespace

BruteForce brute_force(const MeshShape& one, const Pose& at_1, const MeshShape& two, const Pose& at_2) {
  double size = 0;
  Quad least = std::numeric_limits<double>::infinity();
  for (const Candidate& pair : near_pairs(one, at_1, two, at_2, size)) {
    const Quad d = squared_distance(corners<Quad>(one, at_1, static_cast<std::size_t>(pair.s)),
                                    corners<Quad>(two, at_2, static_cast<std::size_t>(pair.t)),
                                    pair.lower < kSure * size);
    if (d < least) least = d;
    if (least < 0) break;
  }
  BruteForce found;
  found.cross = least < 0;
  const double distance = found.cross ? 0 : static_cast<double>(elementary::sqrt(least));
  found.meet = distance <= kSame * size;
  found.upper = std::nextafter(distance, std::numeric_limits<double>::infinity());
  found.lower = std::max(0.0, distance - kParallel * size);
  if (found.meet) found.lower = found.upper = 0;
  return found;
}

BruteForce rough_force(const MeshShape& one, const Pose& at_1, const MeshShape& two, const Pose& at_2) {
  double size = 0;
  BruteForce found;
  found.upper = near_pairs(one, at_1, two, at_2, size).front().lower;
  found.meet = !(found.upper > 0);
  found.lower = std::max(0.0, found.upper - kSure * size);
  return found;
}

bool winds_about(const MeshShape& solid, const Pose& at, const Eigen::Vector3d& point) {
  double angle = 0;  // Van Oosterom and Strackee
  const Pose back = at.inverse();
  const Eigen::Vector3d here = back.apply(point);
  for (const MeshTriangle& t : solid.triangles) {
    const Eigen::Vector3d a = solid.vertices.col(t[0]) - here, b = solid.vertices.col(t[1]) - here,
                          c = solid.vertices.col(t[2]) - here;
    const double x = a.norm(), y = b.norm(), z = c.norm();
    angle += 2 * std::atan2(a.dot(b.cross(c)), x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y);
  }
  return std::abs(angle) > 2 * std::numbers::pi;
}

}  // namespace raygauge::testing
