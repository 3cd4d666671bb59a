// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/bodies/facet_lanes.h"

#include <cmath>
#include <cstdlib>  // defines __GLIBC__ where it is

#include "engine/methods/bodies/facet_rounding.h"

// Compiled once more for wider vectors; no sum is contracted.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__AVX2__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define RAYGAUGE_VECTORS [[gnu::target_clones("arch=x86-64-v4", "avx2", "default")]]
#else
#define RAYGAUGE_VECTORS
#endif

namespace raygauge {
namespace {

// Branches would be guessed wrong as often as right; lanes choose.
inline Vector3 chosen(bool first, const Vector3& a, const Vector3& b) {
  return {first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z};
}
inline double least_of(double a, double b) { return a < b ? a : b; }
inline double most_of(double a, double b) { return a > b ? a : b; }

}  // namespace

RAYGAUGE_VECTORS void measure_facets(double size, FacetLanes& lanes) {
  for (int i = 0; i < FacetLanes::kCount; ++i) {
    const auto corner = [&](int c) {
      return Vector3{lanes.corner[c][0][i], lanes.corner[c][1][i], lanes.corner[c][2][i]};
    };
    const Vector3 a = corner(0), b = corner(1), c = corner(2);
    const Vector3 ab = b - a, bc = c - b, ca = a - c;
    const double of_ab = dot(ab, ab), of_bc = dot(bc, bc), of_ca = dot(ca, ca);
    // The two shorter edges: bc and ca, ca and ab, or ab and bc.
    const bool is_ab = of_ab >= most_of(of_bc, of_ca), is_bc = of_bc >= of_ca;
    const Vector3 first = chosen(is_ab, bc, chosen(is_bc, ca, ab)),
                  second = chosen(is_ab, ca, chosen(is_bc, ab, bc));
    const double edges = (is_ab ? of_bc : is_bc ? of_ca : of_ab) * (is_ab ? of_ca : is_bc ? of_ab : of_bc);
    const Vector3 across = cross(first, second);
    const double length = std::sqrt(dot(across, across)), inverse = 1 / length;
    const double scale = length > 0 ? inverse : 0.0;
    const Vector3 n = across * scale;
    const double of_a = dot(n, a), of_b = dot(n, b), of_c = dot(n, c);
    const double least = least_of(least_of(of_a, of_b), of_c);
    const double offset = least - kFacetProduct<double> * size - std::fabs(least) * 0x1p-52;
    const double needed = (kFacetEdges<double> * std::sqrt(edges) * scale + kFacetProduct<double>)*size;
    const bool is_certain = (length > kLeastFacetNormal) & (least > needed);
    lanes.n[0][i] = n.x;
    lanes.n[1][i] = n.y;
    lanes.n[2][i] = n.z;
    lanes.reach[i] = most_of(most_of(of_a, of_b), of_c);
    lanes.offset[i] = is_certain ? offset : least_of(offset, 0);
  }
}

}  // namespace raygauge
