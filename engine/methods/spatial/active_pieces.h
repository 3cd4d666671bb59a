// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "engine/methods/spatial/contact_program.h"
#include "engine/methods/spatial/precise_pair.h"
#include "engine/methods/spatial/spatial_distance.h"

namespace raygauge {

/// Support points of the difference of two cores with weights: vertices, or the pieces of curved cores, that
/// are active near a normal u. They are what Newton steps on u need of the cores, over both pairs.
template <class Pair>
struct ActivePieces {
  using Real = typename Pair::Real;
  using Vector = typename Pair::Vector;
  using Point = typename Pair::Point;

  static constexpr int kMost = kIsDouble<Real> ? kMostContactPieces : 4;
  static constexpr int kMostToBegin = kIsDouble<Real> ? 4 : 3;

  int count = 0;
  Point point[kMost];
  double weight[kMost] = {1};

  /// The pieces of a combination, each once with all its weight; their points have to follow.
  void begin(const SpatialCombination& combination);

  /// Which of them is this piece; count: none.
  int find(const Point& piece) const;

  /// Adds a piece whose point has followed, with weight 0 beside others, if there is room.
  void add(const Point& piece);

  /// Points on rims and curved surfaces follow u; the piece of its support point, if given, joins them.
  void follow(const Pair& pair, const Vector& u, const Point* highest);

  /// Of the pieces with their weights, in the frame of the pair: H + λ + error() + `damping` times the trace
  /// of H, across u.
  TangentMetric metric(const Pair& pair, const Vector& u, double lambda, double damping) const;

  /// The step of these pieces at u: at(i) is the point of piece i relative to the height of no step.
  template <class At>
  ContactStep<Real> step(const TangentMetric& metric, const Vector& u, const At& at) const {
    ContactPiece<Real> pieces[kMost];
    for (int i = 0; i < count; ++i) {
      const auto& x = at(i);
      pieces[i].height = dot(u, x);
      metric.image(dot(x, metric.tangent[0]), dot(x, metric.tangent[1]), pieces[i].slope);
    }
    return contact_step(pieces, count);
  }

  /// The active pieces with the weights of a step.
  void keep(const ContactStep<Real>& found);

  /// Their combination with these weights over their sum, those that rounding has left negative without.
  Point combine(const ContactStep<Real>& found) const;

 private:
  bool share(const Pair& pair, int k, int i) const;
  Matrix3 hessian(const Pair& pair, const Vector3& u) const;
};

/// Turns the unit vector u by a step y, but by no more than `longest`. Returns how far the step would go.
template <class Real>
double turn(const TangentMetric& metric, const Real* y, double longest, BasicVector3<Real>& u) {
  Real d[2];
  metric.step(y, d);
  const double long_by = std::sqrt(high(d[0]) * high(d[0]) + high(d[1]) * high(d[1]));
  const Real share{long_by > longest ? longest / long_by : 1.0};
  u = u + vector_of<Real>(metric.tangent[0]) * (d[0] * share) +
      vector_of<Real>(metric.tangent[1]) * (d[1] * share);
  u = u * Real{1 / std::sqrt(high(dot(u, u)))};
  return long_by;
}

extern template struct ActivePieces<SpatialPair>;
extern template struct ActivePieces<PrecisePair>;

}  // namespace raygauge
