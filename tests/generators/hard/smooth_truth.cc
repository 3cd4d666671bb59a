// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/generators/hard/smooth_truth.h"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "raygauge/sets/ball.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/p_norm_ball.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge {
namespace {

using RealVector = std::vector<Real>;

RealVector real(const Vector& x) { return {x.begin(), x.end()}; }

Real dot(const RealVector& x, const RealVector& y) {
  Real sum = 0;
  for (std::size_t k = 0; k < x.size(); ++k) sum += x[k] * y[k];
  return sum;
}

/// x + factor · y.
RealVector plus(RealVector x, const Real& factor, const RealVector& y) {
  for (std::size_t k = 0; k < x.size(); ++k) x[k] += factor * y[k];
  return x;
}

Real length(const RealVector& x) { return sqrt(dot(x, x)); }

void demand(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

void demand_around_origin(const ConvexSet& Q) { demand(Q.center().isZero(0), "Q has 0 as its centre"); }

/// The discs of a truncated cone or a cylinder.
struct Discs {
  RealVector base, top;
  Real base_radius, top_radius;
};

Real gauge(const PNormBall& Q, const RealVector& x) {
  demand_around_origin(Q);
  const Real p = Q.p();
  Real sum = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const Real share = abs(x[k]) / Q.semi_axes()[static_cast<Eigen::Index>(k)];
    if (share > 0) sum += pow(share, p);
  }
  return pow(sum, 1 / p);
}

// |L⁻¹x| by Gaussian elimination.
Real gauge(const Ellipsoid& Q, RealVector x) {
  demand_around_origin(Q);
  const std::size_t n = x.size();
  std::vector<RealVector> rows;
  for (const auto& row : Q.factor().rowwise()) rows.emplace_back(row.begin(), row.end());
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < n; ++i) {
      if (abs(rows[i][k]) > abs(rows[pivot][k])) pivot = i;
    }
    std::swap(rows[k], rows[pivot]);
    std::swap(x[k], x[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const Real factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j < n; ++j) rows[i][j] -= factor * rows[k][j];
      x[i] -= factor * x[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) x[k] -= rows[k][j] * x[j];
    x[k] /= rows[k][k];
  }
  return length(x);
}

// max(z/z_t, -z/z_b, (ρ + kz)/R).
Real gauge(const Discs& Q, const RealVector& x) {
  const RealVector way = plus(Q.top, -1, Q.base);
  const Real height = length(way);
  const Real z = dot(x, way) / height;
  const Real away = length(plus(x, -z / height, way));
  const Real above = dot(Q.top, way) / height, below = -dot(Q.base, way) / height;
  for (std::size_t k = 0; k < x.size(); ++k) {
    demand(dot(way, way) * Q.top[k] == dot(Q.top, way) * way[k], "the axis of Q passes through 0");
  }
  const Real slope = (Q.base_radius - Q.top_radius) / height;
  const Real radius = Q.base_radius - slope * below;
  return std::max({z / above, -z / below, (away + slope * z) / radius});
}

// By bisection: the least λ with a distance of x from the segment λ[p, q] of at most λr.
Real gauge(const Capsule& Q, const RealVector& x) {
  demand_around_origin(Q);
  const RealVector half = real(Q.q());
  const auto reached = [&](const Real& scale) {
    const Real along = dot(x, half) / (scale * dot(half, half));
    const Real nearest = std::clamp(along, Real(-1), Real(1));
    return length(plus(x, -nearest * scale, half)) <= scale * Q.radius();
  };
  Real outside = 0, inside = length(x) / Q.radius();
  constexpr int kHalvings = 250;
  for (int halving = 0; halving < kHalvings; ++halving) {
    const Real middle = (outside + inside) / 2;
    (reached(middle) ? inside : outside) = middle;
  }
  return inside;
}

// The least λ with |x - λc| <= λ|c|.
Real gauge(const Ball& Q, const RealVector& x) {
  const RealVector c = real(Q.center());
  demand(dot(c, c) == Real(Q.radius()) * Q.radius(), "Q touches 0");
  return dot(x, x) / (2 * dot(c, x));
}

/// A = center - factor · Q.
struct Homothety {
  RealVector center;
  Real factor;
};

Homothety homothety(const PNormBall& A, const PNormBall& Q) {
  const Real factor = Real(A.semi_axes()[0]) / Q.semi_axes()[0];
  for (Eigen::Index k = 0; k < A.dimension(); ++k)
    demand(A.semi_axes()[k] == factor * Q.semi_axes()[k], "semi-axes");
  demand(A.p() == Q.p(), "exponents");
  return {real(A.center()), factor};
}

Homothety homothety(const Ellipsoid& A, const Ellipsoid& Q) {
  const Real factor = A.factor().cwiseAbs().maxCoeff() / Real(Q.factor().cwiseAbs().maxCoeff());
  for (Eigen::Index k = 0; k < A.factor().size(); ++k) {
    demand(A.factor().data()[k] == factor * Q.factor().data()[k], "factors");
  }
  return {real(A.center()), factor};
}

Homothety homothety(const Discs& A, const Discs& Q) {
  const Real factor = A.base_radius / Q.base_radius;
  const RealVector center = plus(A.base, factor, Q.base);
  demand(A.top_radius == factor * Q.top_radius, "top radii");
  demand(A.top == plus(center, -factor, Q.top), "tops");
  return {center, factor};
}

Homothety homothety(const Capsule& A, const Capsule& Q) {
  const Real factor = Real(A.radius()) / Q.radius();
  const RealVector center = plus(real(A.p()), factor, real(Q.p()));
  demand(real(A.q()) == plus(center, -factor, real(Q.q())), "ends");
  return {center, factor};
}

/// The set as what the functions above take.
const PNormBall& seen(const PNormBall& S) { return S; }
const Ellipsoid& seen(const Ellipsoid& S) { return S; }
const Capsule& seen(const Capsule& S) { return S; }
Discs seen(const TruncatedCone& S) {
  return {real(S.base()), real(S.top()), S.base_radius(), S.top_radius()};
}
Discs seen(const Cylinder& S) { return {real(S.p()), real(S.q()), S.radius(), S.radius()}; }

template <class Set>
bool is_pair(const ConvexSet& A, const ConvexSet& Q, Real& distance) {
  const auto* set_Q = dynamic_cast<const Set*>(&Q);
  if (set_Q == nullptr) return false;
  if (const auto* points = dynamic_cast<const PointSet*>(&A)) {
    distance = gauge(seen(*set_Q), real(points->points().col(0)));
    return true;
  }
  const Homothety pair = homothety(seen(dynamic_cast<const Set&>(A)), seen(*set_Q));
  distance = std::max(Real(0), gauge(seen(*set_Q), pair.center) - pair.factor);
  return true;
}

}  // namespace

Real smooth_distance(const ConvexSet& A, const ConvexSet& Q) {
  Real distance = 0;
  if (const auto* ball = dynamic_cast<const Ball*>(&Q)) {
    return gauge(*ball, real(dynamic_cast<const PointSet&>(A).points().col(0)));
  }
  const bool known = is_pair<PNormBall>(A, Q, distance) || is_pair<Ellipsoid>(A, Q, distance) ||
                     is_pair<TruncatedCone>(A, Q, distance) || is_pair<Cylinder>(A, Q, distance) ||
                     is_pair<Capsule>(A, Q, distance);
  demand(known, "a pair of sets that no formula is known of");
  return distance;
}

}  // namespace raygauge
