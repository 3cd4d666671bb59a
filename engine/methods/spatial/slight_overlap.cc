// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/slight_overlap.h"

#include <algorithm>
#include <cmath>

namespace raygauge {
namespace {

constexpr int kMostVertices = 8;  // that are added
constexpr double kClear = 16;     // of error(): how much farther than the face a vertex must be
constexpr int kFacets[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};  // facet f lacks corner f

class SlightOverlap {
 public:
  SlightOverlap(SpatialPair& pair, SpatialCombination& face, const Vector3& v, double v_error)
      : pair_(pair), face_(face), v_(v), v_error_(v_error), known_(face.count) {}

  bool run();

 private:
  enum class Side { inside, outside, unclear };

  Vector3 way_out() const;
  Side side_of(int f, Vector3& outward) const;
  bool look_beyond(const Vector3& u, int slot);
  void drop(int f);

  const Vector3& corner(int i) const { return face_.point[i].s; }

  SpatialPair& pair_;
  SpatialCombination& face_;
  const Vector3 v_;
  const double v_error_;
  const int known_;  // corners around v, the first
};

// From the hull of fewer than four corners to the origin, at v.
Vector3 SlightOverlap::way_out() const {
  if (face_.count == 1) return -v_;
  const Vector3 e = corner(1) - corner(0);
  if (face_.count == 2) return e * (dot(v_, e) / dot(e, e)) - v_;
  const Vector3 n = cross(e, corner(2) - corner(0));
  return dot(n, v_) < 0 ? n : -n;
}

// Where the origin is of facet f, with all that is uncertain: each corner by error(), so that an edge e is by
// little more than twice as much, and n = e × g by 3 error() (|e| + |g| + 2 error()), rounding included.
SlightOverlap::Side SlightOverlap::side_of(int f, Vector3& outward) const {
  const Vector3& a = corner(kFacets[f][0]);
  const Vector3 e = corner(kFacets[f][1]) - a, g = corner(kFacets[f][2]) - a;
  const Vector3 n = cross(e, g);
  const double error = pair_.error(), size = length(n);
  const double n_error = 3 * error * (length(e) + length(g) + 2 * error);
  const Vector3 inward = corner(f) - a;
  const double opposite = dot(n, inward);
  if (!(std::fabs(opposite) > n_error * (length(inward) + 3 * error) + 3 * error * size))
    return Side::unclear;
  outward = opposite < 0 ? n : -n;
  const bool holds_v = f >= known_;
  const Vector3& base = holds_v ? v_ : a;
  const double base_error = holds_v ? v_error_ : error;
  const double below = dot(outward, base);
  const double unclear =
      (n_error * (length(base) + base_error) + base_error * size + 0x1p-50 * size * length(base)) *
      (1 + 0x1p-50);
  if (below > unclear) return Side::inside;
  return below < -unclear ? Side::outside : Side::unclear;
}

// The support point for u becomes a corner; false if it is not clearly beyond the ones known.
bool SlightOverlap::look_beyond(const Vector3& u, int slot) {
  SpatialPoint w;
  pair_.support(u, w);
  if (!(dot(u, w.s) > kClear * pair_.error() * length(u))) return false;
  face_.point[slot] = w;
  face_.weight[slot] = 0;
  return true;
}

// The facet without corner f is all that is kept.
void SlightOverlap::drop(int f) {
  for (int i = f; i < 3; ++i) face_.point[i] = face_.point[i + 1];
  face_.count = 3;
}

bool SlightOverlap::run() {
  for (int added = 0; added < kMostVertices; ++added) {
    if (face_.count < 4) {
      const Vector3 u = way_out();
      if (!(dot(u, u) > 0) || !look_beyond(u, face_.count)) return false;
      if (++face_.count < 4) continue;
    }
    int beyond = 4;
    Vector3 outward, u;
    for (int f = 0; f < 4; ++f) {
      const Side side = side_of(f, outward);
      if (side == Side::unclear || (side == Side::outside && f < known_)) {
        drop(std::max(f, known_));
        return false;
      }
      if (side == Side::outside) beyond = f, u = outward;
    }
    if (beyond == 4) return true;
    if (look_beyond(u, beyond)) continue;
    drop(beyond);
    return false;
  }
  drop(3);
  return false;
}

}  // namespace

bool slight_overlap(SpatialPair& pair, SpatialCombination& face, const Vector3& v, double v_error) {
  return face.count >= 1 && face.count <= 3 && SlightOverlap(pair, face, v, v_error).run();
}

}  // namespace raygauge
