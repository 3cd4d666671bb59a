// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/simulation.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "raygauge/exceptions.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/p_norm_ball.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/polytopes.h"
#include "raygauge/sets/prepared_set.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::test_moments {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRounding = 1e-13;  // relative, of some tens of operations

Eigen::Vector3d v(double x, double y, double z) { return {x, y, z}; }

void expect_moments(const Moments& found, double V, const Eigen::VectorXd& center,
                    const Eigen::MatrixXd& covariance, double relative = kRounding) {
  EXPECT_NEAR(found.measure, V, relative * V);
  EXPECT_LE((found.center - center).norm(), relative * (1 + center.norm()));
  EXPECT_LE((found.covariance - covariance).norm(), relative * covariance.norm());
}

// Independent of the formulas: the share of a fine grid that the set holds, by its gauge-free membership in
// cylindrical slices of revolution about the third axis with radius r(z).
template <class Radius>
Moments of_revolution(double from, double to, const Radius& radius) {
  constexpr int kSlices = 200000;
  double V = 0, first = 0, second = 0, across = 0;
  for (int i = 0; i < kSlices; ++i) {
    const double dz = (to - from) / kSlices, z = from + (i + 0.5) * dz, r = radius(z), area = kPi * r * r;
    V += area * dz;
    first += z * area * dz;
    second += z * z * area * dz;
    across += area * r * r / 4 * dz;
  }
  const double c = first / V;
  return {V, v(0, 0, c), Eigen::Vector3d(across, across, second - V * c * c).asDiagonal().toDenseMatrix()};
}

TEST(Moments, a_ball_has_two_fifths_of_m_r_squared) {
  const Moments found = moments_of(Ball(v(1, 2, 3), 2));
  const double V = 4 * kPi / 3 * 8;
  expect_moments(found, V, v(1, 2, 3), V * 4 / 5 * Eigen::Matrix3d::Identity());
  EXPECT_LE((found.inertia() - 0.4 * V * 4 * Eigen::Matrix3d::Identity()).norm(), kRounding * V);
}

TEST(Moments, a_box_has_a_twelfth_of_its_edges) {
  const Moments found = moments_of(Box(v(0, 0, 0), v(2, 4, 6)));
  EXPECT_LE((found.inertia() - 48.0 / 12 * v(16 + 36, 4 + 36, 4 + 16).asDiagonal().toDenseMatrix()).norm(),
            1e-11);
  expect_moments(found, 48, v(1, 2, 3), 48.0 / 12 * v(4, 16, 36).asDiagonal().toDenseMatrix());
}

TEST(Moments, an_ellipsoid_is_the_image_of_a_ball) {
  Eigen::Matrix3d L;
  L << 2, 0.5, 0, 0, 1, 0.3, 0.1, 0, 3;
  const double V = 4 * kPi / 3 * L.determinant();
  expect_moments(moments_of(Ellipsoid(v(1, 0, 0), L)), V, v(1, 0, 0), V / 5 * L * L.transpose());
  const auto ball = std::make_shared<Ball>(v(0, 0, 0), 1);
  expect_moments(moments_of(AffineImage(ball, L, v(1, 0, 0))), V, v(1, 0, 0), V / 5 * L * L.transpose());
}

TEST(Moments, bodies_of_revolution_agree_with_their_slices) {
  constexpr double kSlicing = 1e-8;  // of 200000 slices by the middle
  const auto compare = [](const ConvexSet& S, const Moments& slices) {
    expect_moments(moments_of(S), slices.measure, slices.center, slices.covariance, kSlicing);
  };
  compare(Cylinder(v(0, 0, 1), v(0, 0, 4), 0.5), of_revolution(1, 4, [](double) { return 0.5; }));
  compare(TruncatedCone(v(0, 0, 1), 2, v(0, 0, 4), 0.5),
          of_revolution(1, 4, [](double z) { return 2 - (z - 1) * 0.5; }));
  compare(TruncatedCone(v(0, 0, 0), 0, v(0, 0, 1), 1), of_revolution(0, 1, [](double z) { return z; }));
  compare(Capsule(v(0, 0, -1), v(0, 0, 2), 0.7), of_revolution(-1.7, 2.7, [](double z) {
            const double beyond = std::max({-1 - z, z - 2, 0.0});
            return std::sqrt(0.49 - beyond * beyond);
          }));
  compare(PNormBall(v(0, 0, 0), v(1, 1, 2), 2),
          of_revolution(-2, 2, [](double z) { return std::sqrt(1 - z * z / 4); }));
}

TEST(Moments, figures_of_the_plane_have_areas) {
  const Eigen::Vector2d o(0, 0);
  expect_moments(moments_of(Ball(o, 2)), 4 * kPi, o, 4 * kPi * Eigen::Matrix2d::Identity());
  const Moments triangle = moments_of(Simplex(o, Eigen::Vector2d(3, 3)));
  EXPECT_NEAR(triangle.measure, 4.5, 1e-12);
  EXPECT_LE((triangle.center - Eigen::Vector2d(1, 1)).norm(), 1e-12);
  // A trapezoid by formula and as points; a stadium of no length is a disc.
  Eigen::MatrixXd corners(2, 4);
  corners << 0, 0, 3, 3, -2, 2, -1, 1;
  const Moments by_points = moments_of(PointSet(corners));
  expect_moments(moments_of(TruncatedCone(o, 2, Eigen::Vector2d(3, 0), 1)), 9, by_points.center,
                 by_points.covariance);
  expect_moments(moments_of(Capsule(o, o, 1)), kPi, o, kPi / 4 * Eigen::Matrix2d::Identity());
  EXPECT_NEAR(moments_of(Ball(o, 2)).inertia()(2, 2), 8 * kPi, 1e-12);
}

TEST(Moments, the_same_polytope_by_all_its_names) {
  if (!PreparedSet::has_hulls()) return;  // hulls of points of R^3 need Qhull
  const Moments box = moments_of(Box(v(-1, 0, 2), v(1, 1, 5)));
  const auto same = [&box](const ConvexSet& S) {
    expect_moments(moments_of(S), box.measure, box.center, box.covariance, 1e-11);
  };
  Eigen::MatrixXd corners(3, 9);
  corners << -1, 1, -1, 1, -1, 1, -1, 1, 0, 0, 0, 1, 1, 0, 0, 1, 1, 0.5, 2, 2, 2, 2, 5, 5, 5, 5, 3;
  same(PointSet(corners));
  same(PreparedSet(corners));
  Eigen::MatrixXd G(6, 3);
  G << Eigen::Matrix3d::Identity(), -Eigen::Matrix3d::Identity();
  Eigen::VectorXd g(6);
  g << 1, 1, 5, 1, 0, -2;
  same(HPolytope(G, g));
  same(Zonotope(v(0, 0.5, 3.5), v(1, 0.5, 1.5).asDiagonal().toDenseMatrix()));
  same(MinkowskiSum(std::make_shared<Box>(v(-1, 0, 2), v(0, 0.5, 3)),
                    std::make_shared<Box>(v(0, 0, 0), v(1, 0.5, 2))));
  same(PNormBall(v(0, 0.5, 3.5), v(1, 0.5, 1.5), std::numeric_limits<double>::infinity()));
}

TEST(Moments, an_octahedron_is_the_ball_of_the_1_norm) {
  if (!PreparedSet::has_hulls()) return;  // hulls of points of R^3 need Qhull
  Eigen::MatrixXd tips(3, 6);
  tips << Eigen::Matrix3d::Identity(), -Eigen::Matrix3d::Identity();
  const Moments found = moments_of(PointSet(tips)),
                formula = moments_of(PNormBall(v(0, 0, 0), v(1, 1, 1), 1));
  expect_moments(found, 4.0 / 3, v(0, 0, 0), 4.0 / 3 / 10 * Eigen::Matrix3d::Identity());
  expect_moments(formula, 4.0 / 3, v(0, 0, 0), 4.0 / 3 / 10 * Eigen::Matrix3d::Identity());
}

RC_GTEST_PROP(Moments, a_tetrahedron_moves_with_its_points, ()) {
  const auto number = [] { return *rc::gen::inRange(-1000, 1000) * 1e-3; };
  Eigen::Matrix<double, 3, 4> corners = Eigen::Matrix<double, 3, 4>::NullaryExpr(number);
  const Eigen::Matrix3d M = Eigen::Matrix3d::NullaryExpr(number) + 3 * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d legs = corners.rightCols(3).colwise() - corners.col(0);
  RC_PRE(std::fabs(legs.determinant()) > 1e-3);
  const Moments one = moments_of(PointSet(corners));
  const Moments image = moments_of(PointSet((M * corners).colwise() + v(5, 6, 7)));
  const double size = M.determinant();
  RC_ASSERT(std::fabs(one.measure - std::fabs(legs.determinant()) / 6) < 1e-12);
  RC_ASSERT(std::fabs(image.measure - size * one.measure) < 1e-11 * size);
  RC_ASSERT((image.center - (M * one.center + v(5, 6, 7))).norm() < 1e-10);
  RC_ASSERT((image.covariance - size * M * one.covariance * M.transpose()).norm() < 1e-9 * size);
}

TEST(Moments, parts_add_up) {
  const std::vector<std::shared_ptr<const ConvexSet>> halves = {
      std::make_shared<Box>(v(0, 0, 0), v(1, 2, 3)), std::make_shared<Box>(v(1, 0, 0), v(4, 2, 3))};
  const Moments whole = moments_of(Box(v(0, 0, 0), v(4, 2, 3)));
  expect_moments(moments_of(halves), whole.measure, whole.center, whole.covariance);
}

TEST(Moments, what_has_no_volume_or_no_formula_is_refused) {
  EXPECT_THROW(moments_of(Ball(v(0, 0, 0), 0)), InvalidParameterError);
  EXPECT_THROW(moments_of(Box(v(0, 0, 0), v(1, 1, 0))), InvalidParameterError);
  EXPECT_THROW(moments_of(Ball(Eigen::VectorXd::Zero(4), 1)), InvalidParameterError);
  const auto ball = std::make_shared<Ball>(v(0, 0, 0), 1);
  EXPECT_THROW(moments_of(MinkowskiSum(ball, std::make_shared<Box>(v(0, 0, 0), v(1, 1, 1)))),
               InvalidParameterError);
}

}  // namespace
}  // namespace raygauge::test_moments
