// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/meshes/triangle_pair.h"

#include <cmath>

#include "engine/methods/spatial/nearest_on_simplex.h"

namespace raygauge {
namespace {

// The highest of three corners along u.
int highest(const TriangleCorners& t, const Vector3& u, double& height) {
  const double a = dot(t.corner[0], u), b = dot(t.corner[1], u), c = dot(t.corner[2], u);
  int best = 0;
  height = a;
  if (b > height) {
    best = 1;
    height = b;
  }
  if (c > height) {
    best = 2;
    height = c;
  }
  return best;
}

/// Corner i of triangle 1 less corner k of triangle 2.
struct Difference {
  Vector3 v;
  int i = 0, k = 0;
};

class Descent {
 public:
  Descent(const TriangleCorners& one, const TriangleCorners& two) : one_(one), two_(two) {}

  TriangleDistance run(const Vector3& from, double tolerance, double enough) {
    step(from, length(from));
    if (answer_.lower >= enough) {
      weight_[0] = 1;
      keep();
      return answer_;
    }
    for (int steps = 0; steps < kMostSteps; ++steps) {
      const Vector3 v = combination();
      const double size = length(v);
      if (size < answer_.upper || steps == 0) keep();
      if (!(size > 0) || answer_.lower >= enough ||
          answer_.upper - answer_.lower <= tolerance * answer_.upper)
        break;
      if (!step(-v, size)) break;
    }
    return answer_;
  }

 private:
  static constexpr int kMostSteps = 24;  // three or four in nearly all cases

  // The corners of 1 - 2 farthest along u; false where they are known already. All of 1 is u·x <= height_1,
  // all of 2 is u·x >= -height_2.
  bool step(const Vector3& u, double size) {
    double height_1 = 0, height_2 = 0;
    Difference fresh;
    fresh.i = highest(one_, u, height_1);
    fresh.k = highest(two_, -u, height_2);
    const double lower = -(height_1 + height_2) / size;
    if (lower > answer_.lower) {
      answer_.lower = lower;
      answer_.normal = u * (1 / size);
    }
    for (int c = 0; c < count_; ++c) {
      if (corners_[c].i == fresh.i && corners_[c].k == fresh.k) return false;
    }
    fresh.v = one_.corner[fresh.i] - two_.corner[fresh.k];
    corners_[count_++] = fresh;
    return true;
  }

  // The nearest point to the origin of what is held; what it does not need is dropped.
  Vector3 combination() {
    const Vector3* points[4];
    for (int c = 0; c < count_; ++c) points[c] = &corners_[c].v;
    const SimplexFace<double> face = nearest_face<double>(points, count_);
    Vector3 v;
    count_ = face.count;
    for (int c = 0; c < count_; ++c) {
      corners_[c] = corners_[face.corner[c]];
      weight_[c] = face.weight[c];
      v = v + corners_[c].v * weight_[c];
    }
    if (count_ < 4) return v;
    inside_ = true;
    return {};
  }

  void keep() {
    answer_.point_1 = answer_.point_2 = {};
    for (int c = 0; c < count_; ++c) {
      answer_.point_1 = answer_.point_1 + one_.corner[corners_[c].i] * weight_[c];
      answer_.point_2 = answer_.point_2 + two_.corner[corners_[c].k] * weight_[c];
    }
    answer_.upper = inside_ ? 0 : length(answer_.point_1 - answer_.point_2);
  }

  const TriangleCorners& one_;
  const TriangleCorners& two_;
  Difference corners_[5];
  double weight_[4] = {};
  int count_ = 0;
  bool inside_ = false;
  TriangleDistance answer_;
};

}  // namespace

TriangleDistance triangle_distance(const TriangleCorners& one, const TriangleCorners& two, Vector3 from,
                                   double tolerance, double enough) {
  return Descent(one, two).run(from, tolerance, enough);
}

}  // namespace raygauge
