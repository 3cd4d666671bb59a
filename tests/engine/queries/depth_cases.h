// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/pose.h"
#include "raygauge/sets/prepared_set.h"
#include "raygauge/sets/truncated_cone.h"
#include "tests/engine/point_clouds.h"

namespace raygauge {

/// A body of every kind, none much larger than another, and its name.
inline std::vector<std::pair<std::string, std::shared_ptr<const ConvexSet>>> depth_bodies() {
  using V = Eigen::Vector3d;
  Random random(5);
  Eigen::Matrix3d axes;
  axes << 0.9, 0.1, 0, 0, 0.6, 0.2, 0, 0, 0.4;
  return {{"ball", std::make_shared<Ball>(V(0, 0, 0), 0.7)},
          {"box", std::make_shared<Box>(V(-0.75, -0.5, -0.25), V(0.75, 0.5, 0.25))},
          {"capsule", std::make_shared<Capsule>(V(0, 0, -0.75), V(0, 0, 0.75), 0.25)},
          {"cylinder", std::make_shared<Cylinder>(V(0, 0, -0.5), V(0, 0, 0.5), 0.5)},
          {"cone", std::make_shared<TruncatedCone>(V(0, 0, -0.5), 0.75, V(0, 0, 0.75), 0.0)},
          {"frustum", std::make_shared<TruncatedCone>(V(0, 0, -0.5), 0.75, V(0, 0, 0.5), 0.25)},
          {"ellipsoid", std::make_shared<Ellipsoid>(V(0, 0, 0), axes)},
          {"hull of 8",
           std::make_shared<PointSet>(0.6 * (cube_vertices(3) + 0.3 * gaussian_points(3, 8, random)))},
          {"hull of 100", std::make_shared<PreparedSet>(sphere_points(3, 100, random))},
          {"cube as points", std::make_shared<PointSet>(0.5 * cube_vertices(3))}};
}

inline Pose random_pose(Random& random, double away) {
  std::normal_distribution<double> normal;
  const Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
  return {q.normalized(), Eigen::Vector3d(away * sphere_points(3, 1, random))};
}

/// h_D(u) of D = A2 - A1 in their poses, by the sets' own support functions.
inline double height_of(const Posed& A1, const Posed& A2, const Vector& u) {
  const auto height = [](const Posed& A, const Vector& v) {
    if (A.pose == nullptr) return A.set.support_function(v);
    return A.set.support_function(A.pose->rotation().transpose() * v) + v.dot(A.pose->translation());
  };
  return height(A2, u) + height(A1, -u);
}

/// The depth of two polytopes in R^3, not flat: the least height over the normals of all triples of points of
/// either one and of all pairs of edges, of which the facets of the difference are some.
inline double depth_of_polytopes(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  using LongVector = Eigen::Matrix<long double, 3, 1>;
  long double least = INFINITY;
  const auto look = [&](const LongVector& n) {
    const long double size = n.norm();
    if (!(size > 1e-14L)) return;
    for (const LongVector& u : {LongVector(n / size), LongVector(-n / size)}) {
      const long double height = (u.transpose() * B.cast<long double>()).maxCoeff() -
                                 (u.transpose() * A.cast<long double>()).minCoeff();
      least = std::min(least, height);
    }
  };
  const auto edge = [](const Eigen::MatrixXd& P, int i, int k) -> LongVector {
    return P.col(i).cast<long double>() - P.col(k).cast<long double>();
  };
  for (const Eigen::MatrixXd* P : {&A, &B}) {
    for (int i = 2; i < P->cols(); ++i)
      for (int j = 1; j < i; ++j)
        for (int k = 0; k < j; ++k) look(edge(*P, i, j).cross(edge(*P, i, k)));
  }
  for (int i = 1; i < A.cols(); ++i)
    for (int j = 0; j < i; ++j)
      for (int k = 1; k < B.cols(); ++k)
        for (int l = 0; l < k; ++l) look(edge(A, i, j).cross(edge(B, k, l)));
  return static_cast<double>(least);
}

}  // namespace raygauge
