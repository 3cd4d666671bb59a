// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/round_growth.h"

#include <algorithm>
#include <cmath>

#include "engine/methods/spatial/gjk.h"
#include "engine/methods/spatial/tuning.h"

namespace raygauge {
namespace {

constexpr int kMostNewtonSteps = 12;
constexpr int kMostRaySteps = 30;

/// Whether the Hessian of h_B has rank 2 somewhere.
bool is_round(const SpatialPair& pair) {
  const bool round =
      pair.radius() > 0 || has_curved_surface(pair.shape(0)) || has_curved_surface(pair.shape(1));
  return round && pair.prisms().empty();
}

/// The Hessian of h_B at the unit vector u, whose support point is `at`, added up.
Matrix3 hessian(const SpatialPair& pair, const Vector3& u, const SpatialPoint& at) {
  Matrix3 H;
  pair.add_hessian(u, at.index_1, at.index_2, 1, H);
  const double r = pair.radius();  // that of its ball, r (1 - u uᵀ)
  H.column[0] = H.column[0] + (Vector3{1, 0, 0} - u * u.x) * r;
  H.column[1] = H.column[1] + (Vector3{0, 1, 0} - u * u.y) * r;
  H.column[2] = H.column[2] + (Vector3{0, 0, 1} - u * u.z) * r;
  return H;
}

// A ball of the rolling radius ρ touches B from inside at w, the support point of the unit vector u; that of
// an ellipsoid is off by error() and by what that turns the normal.
bool bound_in_rolling_ball(GrowthBounds& growth, const Vector3& u, const SpatialPoint& w) {
  const SpatialPair& pair = growth.pair();
  if (!pair.prisms().empty()) return false;
  double radius = pair.radius(), slack = 2;
  for (int i = 0; i < 2; ++i) {
    const SpatialShape& shape = pair.shape(i);
    radius += shape.rolling_radius;
    if (shape.rolling_radius > 0) slack += 2 * shape.extent / shape.inner_radius;
  }
  return growth.bound_in_ball(w.s - u * radius, radius, pair.error() * slack);
}

// A solve of the 3 × 3 system K x = b for a positive definite K; false where it is singular to working
// precision, against the third power of its trace.
bool solve(const Matrix3& K, const Vector3& b, Vector3& x) {
  const Vector3 c0 = cross(K.column[1], K.column[2]);
  const double determinant = dot(K.column[0], c0);
  const double scale = K.column[0].x + K.column[1].y + K.column[2].z;
  if (!(determinant > 1e-15 * scale * scale * scale)) return false;
  x = Vector3{dot(b, c0), dot(b, cross(K.column[2], K.column[0])), dot(b, cross(K.column[0], K.column[1]))} *
      (1 / determinant);
  return true;
}

// p, or beside an ellipsoid M⁻¹p with the form M at p: for |p| = 1 and |u| = 1, 2 h_B(u) <= uᵀMu + h_B(p)
// where all are ellipsoids and balls, equal at p.
Vector3 first_direction(const GrowthBounds& growth) {
  Vector3 u;
  Matrix3 M;
  return growth.pair().smooth_form(growth.p(), M) && solve(M, growth.p(), u) ? u : growth.p();
}

/// Polytopes with balls: see round_growth().
class RayToCores {
 public:
  explicit RayToCores(GrowthBounds& growth)
      : growth_(growth), pair_(growth.pair()), simplex_(growth.answer().combination), p_(growth.p()) {}

  bool run(const SpatialStart& start);

 private:
  bool begin(const SpatialStart& start);
  double look(const Vector3& u, SpatialPoint& w);

  GrowthBounds& growth_;
  SpatialPair& pair_;
  SpatialCombination& simplex_;  // points of K about the centres
  Vector3 p_;
  double t_ = 0;
};

// The support point of K for the unit vector u, with the bound that it proves; at least t as far as it knows.
double RayToCores::look(const Vector3& u, SpatialPoint& w) {
  pair_.support(u, w);
  w.s = w.s + p_;
  ++growth_.answer().iterations;
  growth_.bound_from_below(u, w.s + u * pair_.radius());
  return (dot(u, w.s) + pair_.radius()) / dot(u, p_);
}

// At the vertices of the last solve, or at the highest ones along the ray.
bool RayToCores::begin(const SpatialStart& start) {
  simplex_.count = 0;
  const Vector3 ahead = p_ * (1 / length(p_));
  double height = 0;
  for (int i = 0; i < std::min(start.count, 3); ++i) {
    SpatialPoint& corner = simplex_.point[i];
    if (!pair_.vertex(start.index_1[i], start.index_2[i], corner)) return false;
    corner.s = corner.s + p_;
    simplex_.weight[i] = 1;
    height = std::max(height, dot(ahead, corner.s));
    ++simplex_.count;
  }
  const bool steered = start.has_normal && dot(start.normal, p_) > 0;
  if (steered || simplex_.count == 0) {
    SpatialPoint w;
    t_ = look(steered ? start.normal * (1 / length(start.normal)) : ahead, w);
    simplex_.weight[simplex_.count] = 1;
    if (!holds(simplex_, w)) simplex_.point[simplex_.count++] = w;
  } else {
    t_ = (height + pair_.radius()) / dot(ahead, p_);
  }
  return true;
}

bool RayToCores::run(const SpatialStart& start) {
  if (!begin(start)) return false;
  double nearest = __builtin_inf();
  for (int i = 0; i < kMostRaySteps; ++i) {
    const Vector3 x = p_ * t_;
    Vector3 away[4];
    const Vector3* points[4] = {&away[0], &away[1], &away[2], &away[3]};
    for (int k = 0; k < simplex_.count; ++k) away[k] = simplex_.point[k].s - x;
    const SimplexFace<double> face = nearest_face(points, simplex_.count);
    keep(face, simplex_);
    const Vector3 center = combine(simplex_, face), way = x - center;
    const double size = length(way);
    if (simplex_.count == 4 || !(size > 0) || !(dot(way, p_) > 0)) return false;
    const bool bounded = growth_.bound_in_ball(center, pair_.radius(), 0);
    if (bounded && !start.fine_normal && growth_.is_done()) return true;
    SpatialPoint& w = simplex_.point[simplex_.count];
    const double t = look(way * (1 / size), w);
    if (!bounded) growth_.bound_in_ball(center, pair_.radius(), 0);
    const bool settled = !start.fine_normal || std::fabs(t - t_) <= growth_.tolerance() * t_;
    if (growth_.is_done() && settled) return true;
    if (holds(simplex_, w)) {
      if (!(t < nearest)) break;
    } else {
      simplex_.weight[simplex_.count++] = 1;
    }
    nearest = std::min(nearest, t);
    t_ = nearest;
  }
  return growth_.answer().end != SpatialEnd::open;
}

}  // namespace

bool newton_growth(GrowthBounds& growth, Vector3 u, bool fine_normal) {
  const SpatialPair& pair = growth.pair();
  const Vector3& p = growth.p();
  u = u * (1 / length(u));
  SpatialPoint w = growth.support(u);
  double ratio = dot(u, p) / dot(u, w.s);
  for (int i = 0; i < kMostNewtonSteps; ++i) {
    growth.bound_from_below(u, w.s);
    if (fine_normal || !bound_in_rolling_ball(growth, u, w)) growth.bound_from_above(&w, 1, &ratio);
    if (growth.is_done()) return true;
    if (!(ratio > 0)) return false;
    Matrix3 H = hessian(pair, u, w);
    const double trace = H.column[0].x + H.column[1].y + H.column[2].z;
    H.column[0] = H.column[0] + u * (trace * u.x);  // H u = 0: any multiple of u uᵀ makes it regular
    H.column[1] = H.column[1] + u * (trace * u.y);
    H.column[2] = H.column[2] + u * (trace * u.z);
    Vector3 step;
    if (!solve(H, p * (1 / ratio) - w.s, step)) return false;
    step = step - u * dot(u, step);
    const double long_by = length(step) / tuned::kLongestGrowthStep;
    if (long_by > 1) step = step * (1 / long_by);
    double share = 1, higher = 0;
    Vector3 next;
    SpatialPoint at_next;
    // Where a step does not rise, a body with edges has one there, which no shorter step gets past.
    const int trials = pair.is_smooth() ? 4 : 1;
    for (int trial = 0; trial < trials; ++trial) {
      next = u + step * share;
      next = next * (1 / length(next));
      at_next = growth.support(next);
      higher = dot(next, p) / dot(next, at_next.s);
      if (higher >= ratio * (1 - 1e-14)) break;
      share *= 0.35;
    }
    if (!(higher >= ratio * (1 - 1e-9))) return false;
    u = next;
    w = at_next;
    ratio = higher;
  }
  return false;
}

bool round_growth(SpatialPair& pair, double tolerance, double threshold, const SpatialStart& start,
                  SpatialAnswer& answer) {
  if (!is_round(pair)) return false;
  GrowthBounds growth(pair, tolerance, threshold, answer);
  const bool balls = is_point(pair.shape(0)) && is_point(pair.shape(1));  // the first normal is the last
  if (pair.has_vertices() && !balls && RayToCores(growth).run(start)) return true;
  answer.combination.count = 0;
  const bool steered = start.has_normal && dot(start.normal, growth.p()) > 0;
  return newton_growth(growth, steered ? start.normal : first_direction(growth), balls || start.fine_normal);
}

}  // namespace raygauge
