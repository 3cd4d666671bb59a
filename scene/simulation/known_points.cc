// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/known_points.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <vector>

#include "engine/numerics/decompositions.h"
#include "engine/sets/hull_3d.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/polytopes.h"

namespace raygauge {
namespace {

using Points = Eigen::MatrixXd;

constexpr Eigen::Index kMost = 200000;

// None where there are none of either, or too many of both.
Points sums(const Points& A, const Points& B) {
  const Eigen::Index count = A.cols() * B.cols();
  if (count == 0 || count > kMost) return Points();
  Points all(A.rows(), count);
  for (Eigen::Index j = 0; j < B.cols(); ++j) {
    all.middleCols(j * A.cols(), A.cols()) = A.colwise() + B.col(j);
  }
  return all;
}

// c + Σ ± g_i, every sign.
Points corners(const Eigen::VectorXd& center, const Eigen::MatrixXd& generators) {
  Points all = center;
  for (Eigen::Index i = 0; i < generators.cols() && all.cols() > 0; ++i) {
    Points pair(center.size(), 2);
    pair << generators.col(i), -generators.col(i);
    all = sums(all, pair);
  }
  return all;
}

Points of_box(const Box& S) {
  const Eigen::VectorXd half = (S.upper() - S.lower()) / 2;
  return corners(S.lower() + half, Eigen::MatrixXd(half.asDiagonal()));
}

Points of_simplex(const Simplex& S) {
  const Eigen::Index n = S.dimension();
  Points all(n, n + 1);
  all.colwise() = Eigen::VectorXd(S.corner());
  all.rightCols(n) += Eigen::MatrixXd(Eigen::VectorXd(S.legs()).asDiagonal());
  return all;
}

// {x : G x <= g} about its centre c has the polar conv{G_i / (g_i - G_i c)}: a facet y·x = 1 of the polar is
// the vertex c + x.
Points of_inequalities(const HPolytope& S) {
  const Eigen::VectorXd c = S.center();
  const Eigen::MatrixXd G = S.G();
  const Eigen::VectorXd margin = Eigen::VectorXd(S.g()) - G * c;
  const Points polar = (margin.cwiseInverse().asDiagonal() * G).transpose();
  const Points facets = surface_simplices(polar);
  const Eigen::Index n = c.size();
  Points all(n, facets.cols() / n);
  for (Eigen::Index f = 0; f < all.cols(); ++f) {
    const Eigen::MatrixXd facet = facets.middleCols(f * n, n).transpose();
    all.col(f) = c + lu_inverse(facet) * Eigen::VectorXd::Ones(n);
  }
  return all;
}

Points of_union(const UnionHull& S) {
  Points all(S.dimension(), 0);
  for (const auto& set : S.sets()) {
    const Points one = known_points(*set);
    if (one.cols() == 0 || all.cols() + one.cols() > kMost) return Points();
    const Eigen::Index before = all.cols();
    all.conservativeResize(Eigen::NoChange, before + one.cols());
    all.rightCols(one.cols()) = one;
  }
  return all;
}

double turn(const Points& P, Eigen::Index a, Eigen::Index b, Eigen::Index c) {
  return (P(0, b) - P(0, a)) * (P(1, c) - P(1, a)) - (P(1, b) - P(1, a)) * (P(0, c) - P(0, a));
}

// Andrew's monotone chain, counterclockwise.
std::vector<Eigen::Index> polygon(const Points& P) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(P.cols()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::sort(order.begin(), order.end(), [&P](Eigen::Index i, Eigen::Index j) {
    return P(0, i) != P(0, j) ? P(0, i) < P(0, j) : P(1, i) < P(1, j);
  });
  std::vector<Eigen::Index> hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t first = hull.size();
    for (const Eigen::Index i : order) {
      while (hull.size() >= first + 2 && turn(P, hull[hull.size() - 2], hull.back(), i) <= 0) hull.pop_back();
      hull.push_back(i);
    }
    hull.pop_back();
    std::reverse(order.begin(), order.end());
  }
  return hull;
}

Points edges(const Points& P) {
  const std::vector<Eigen::Index> corner = polygon(P);
  if (corner.size() < 3) return Points();
  Points all(2, 2 * static_cast<Eigen::Index>(corner.size()));
  for (std::size_t i = 0; i < corner.size(); ++i) {
    all.col(2 * static_cast<Eigen::Index>(i)) = P.col(corner[i]);
    all.col(2 * static_cast<Eigen::Index>(i) + 1) = P.col(corner[(i + 1) % corner.size()]);
  }
  return all;
}

Points faces_of_tetrahedron(const Points& P) {
  Points all(3, 12);
  const Eigen::Vector3d a = P.col(0), b = P.col(1), c = P.col(2), d = P.col(3);
  all << a, c, b, a, b, d, b, c, d, c, a, d;
  if ((b - a).cross(c - a).dot(d - a) < 0) {
    for (Eigen::Index f = 0; f < 4; ++f) all.col(3 * f).swap(all.col(3 * f + 1));
  }
  return all;
}

}  // namespace

Eigen::MatrixXd known_points(const ConvexSet& S) {
  if (const PointSet* points = as_point_set(S)) return points->points();
  if (const auto* box = dynamic_cast<const Box*>(&S)) return of_box(*box);
  if (const auto* simplex = dynamic_cast<const Simplex*>(&S)) return of_simplex(*simplex);
  if (const auto* zonotope = dynamic_cast<const Zonotope*>(&S))
    return corners(zonotope->center(), zonotope->generators());
  if (const auto* polytope = dynamic_cast<const HPolytope*>(&S)) return of_inequalities(*polytope);
  if (const auto* hull = dynamic_cast<const UnionHull*>(&S)) return of_union(*hull);
  if (const auto* sum = dynamic_cast<const MinkowskiSum*>(&S))
    return sums(known_points(*sum->A()), known_points(*sum->B()));
  if (const auto* image = dynamic_cast<const AffineImage*>(&S)) {
    const Points inner = known_points(*image->S());
    return inner.cols() == 0 ? inner : Points((image->M() * inner).colwise() + Eigen::VectorXd(image->t()));
  }
  return Points();
}

Eigen::MatrixXd surface_simplices(const Eigen::MatrixXd& points) {
  if (points.cols() <= points.rows()) return Points();
  if (points.rows() == 2) return edges(points);
  if (points.rows() != 3) return Points();
  if (points.cols() == 4) return faces_of_tetrahedron(points);
  const Hull3 hull = hull_3d(points, points.rowwise().mean());
  Points all(3, static_cast<Eigen::Index>(hull.triangles.size()));
  for (std::size_t i = 0; i < hull.triangles.size(); ++i) {
    all.col(static_cast<Eigen::Index>(i)) = points.col(hull.triangles[i]);
  }
  return all;
}

}  // namespace raygauge
