// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Sets made of other sets. Each answer is known: the program ends with status 1 if one is off.
#include <raygauge/raygauge.h>

#include <cmath>
#include <cstdio>
#include <memory>

namespace {

using Eigen::Vector3d;
using SetPointer = std::shared_ptr<const raygauge::ConvexSet>;

template <class Set, class... Arguments>
SetPointer make(const Arguments&... arguments) {
  return std::make_shared<const Set>(arguments...);
}

/// Whether d_Q(A) is as expected, to the tolerance of the solver.
bool holds(const char* what, const raygauge::ConvexSet& A, const raygauge::ConvexSet& Q, double expected) {
  raygauge::DistanceSolver solver;
  const raygauge::DistanceResult& r = solver.solve(A, Q);
  std::printf("%-34s %.6f in [%.9f, %.9f]\n", what, r.distance, r.lower, r.upper);
  return std::abs(r.distance - expected) <= solver.options().tolerance * expected;
}

}  // namespace

int main() {
  const Vector3d zero = Vector3d::Zero();
  const Vector3d one = Vector3d::Ones();
  const auto cube = make<raygauge::Box>(Vector3d(-one), one);
  const auto ball = make<raygauge::Ball>(zero, 1.0);
  bool right = true;

  // Rounded corners: a box and a small ball, added point by point.
  const auto small_box = make<raygauge::Box>(Vector3d(3.5, -0.5, -0.5), Vector3d(4.5, 0.5, 0.5));
  const auto small_ball = make<raygauge::Ball>(zero, 0.5);
  right &= holds("box with rounded corners", raygauge::MinkowskiSum(small_box, small_ball), *cube, 3);

  // What a moving ball sweeps: the hull of where it begins and ends.
  const auto begin = make<raygauge::Ball>(Vector3d(4, 0, 0), 1.0);
  const auto end = make<raygauge::Ball>(Vector3d(6, 3, 0), 1.0);
  right &= holds("swept ball", raygauge::UnionHull({begin, end}), *cube, 3);

  // Stretched, turned and moved: x -> M x + t.
  const Eigen::Matrix3d stretch = Vector3d(2, 1, 1).asDiagonal();
  right &= holds("stretched ball", raygauge::AffineImage(ball, stretch, Vector3d(5, 0, 0)), *cube, 3);

  // Two bodies: how far are they apart in the metric of Q? It is the distance of their difference from 0.
  const auto rod = make<raygauge::Capsule>(Vector3d(4, -1, 0), Vector3d(4, 1, 0), 0.5);
  right &= holds("rod and ball, Euclidean metric", raygauge::MinkowskiDifference(rod, ball), *ball, 2.5);
  return right ? 0 : 1;
}
