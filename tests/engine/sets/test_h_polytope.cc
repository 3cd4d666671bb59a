// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/capability_queries.h"
#include "raygauge/sets/polytopes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "engine/numerics/double_double.h"
#include "raygauge/exceptions.h"
#include "raygauge/queries/membership.h"
#include "raygauge/queries/solver.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/point_set.h"
#include "tests/engine/point_clouds.h"

namespace raygauge {
namespace {

HPolytope cube(int n, double half = 1) {
  Eigen::MatrixXd G(2 * n, n);
  G << Eigen::MatrixXd::Identity(n, n), -Eigen::MatrixXd::Identity(n, n);
  return {G, Vector::Constant(2 * n, half)};
}

// {x : Σ|x_k| <= 1} by its 2^n inequalities.
HPolytope cross_polytope(int n) {
  Eigen::MatrixXd G(1 << n, n);
  for (int i = 0; i < 1 << n; ++i) {
    for (int k = 0; k < n; ++k) G(i, k) = (i >> k & 1) == 1 ? 1 : -1;
  }
  return {G, Vector::Ones(1 << n)};
}

// {x : x >= 0, Σ x_k <= 1}.
HPolytope corner_simplex(int n) {
  Eigen::MatrixXd G(n + 1, n);
  G << -Eigen::MatrixXd::Identity(n, n), Eigen::RowVectorXd::Ones(n);
  return {G, Vector::Unit(n + 1, n)};
}

TEST(HPolytope, HasTheSupportFunctionsOfCubesCrossPolytopesAndSimplices) {
  Random random(1);
  for (const int n : {1, 2, 3, 6, 9}) {
    const HPolytope box = cube(n, 2), cross = cross_polytope(n), simplex = corner_simplex(n);
    for (int trial = 0; trial < 40; ++trial) {
      const Vector u = gaussian_points(n, 1, random);
      EXPECT_NEAR(box.support_function(u), 2 * u.lpNorm<1>(), 1e-13 * u.lpNorm<1>()) << n;
      EXPECT_NEAR(cross.support_function(u), u.lpNorm<Eigen::Infinity>(), 1e-13 * u.lpNorm<1>()) << n;
      EXPECT_NEAR(simplex.support_function(u), std::max(0.0, u.maxCoeff()), 1e-13 * u.lpNorm<1>()) << n;
    }
  }
}

TEST(HPolytope, HasTheSupportPointsOfADegenerateVertexInManyDimensions) {
  const int n = 60;
  const HPolytope box = cube(n);
  for (int k = 0; k < n; k += 7) EXPECT_DOUBLE_EQ(box.support_function(Vector::Unit(n, k)), 1);
  EXPECT_DOUBLE_EQ(box.support_function(Vector::Ones(n)), n);
}

TEST(HPolytope, KnowsItsGaugeAndTheBallsInside) {
  const HPolytope box = cube(3, 2);
  const Vector x{{1, -3, 0.5}};
  Vector normal(3);
  EXPECT_NEAR(gauge_bound(box, x.data(), normal.data()), 1.5, 1e-14);
  EXPECT_GE(gauge_bound(box, x.data(), normal.data()), 1.5);
  EXPECT_EQ(normal.normalized(), (Vector{{0, -1, 0}}));
  const Vector off{{1, 0, 0}}, origin = Vector::Zero(3);
  EXPECT_NEAR(box.inner_radius_unchecked(origin.data()), 2, 1e-13);
  EXPECT_LE(box.inner_radius_unchecked(origin.data()), 2);
  EXPECT_NEAR(box.inner_radius_unchecked(off.data()), 1, 1e-13);
  EXPECT_NEAR(cross_polytope(4).inner_radius_unchecked(Vector::Zero(4).eval().data()), 0.5, 1e-13);
  const HPolytope simplex = corner_simplex(3);
  EXPECT_EQ(gauge_bound(simplex, x.data(), normal.data()), std::numeric_limits<double>::infinity());
}

TEST(HPolytope, HasACentreInside) {
  EXPECT_LT(cube(5).center().norm(), 1e-12);
  const Vector c = corner_simplex(3).center();
  EXPECT_GT(c.minCoeff(), 0.2);
  EXPECT_LT(c.sum(), 0.8);
}

TEST(HPolytope, IsGaugeBodyAndObjectAsTheBoxIs) {
  Random random(3);
  for (const int n : {2, 3, 5, 8}) {
    const HPolytope polytope = cube(n);
    const Box box(-Vector::Ones(n), Vector::Ones(n));
    Eigen::MatrixXd points = gaussian_points(n, 3 * n, random);
    points.row(0).array() += 6;
    const PointSet A(points);
    DistanceSolver solver;
    const double expected = solver.solve(A, box).distance;
    const DistanceResult as_Q = solver.solve(A, polytope);
    EXPECT_EQ(as_Q.status, DistanceStatus::optimal) << n;
    EXPECT_NEAR(as_Q.distance, expected, 2e-6 * expected) << n;
    Eigen::MatrixXd around = sphere_points(n, 8 * n, random);
    const PointSet Q((Eigen::MatrixXd(n, 10 * n) << around, Eigen::MatrixXd::Identity(n, n),
                      -Eigen::MatrixXd::Identity(n, n))
                         .finished());
    const Vector shift = 9 * Vector::Unit(n, 0);
    Eigen::MatrixXd G(2 * n, n);
    G << Eigen::MatrixXd::Identity(n, n), -Eigen::MatrixXd::Identity(n, n);
    const HPolytope moved(G, G * shift + Vector::Ones(2 * n));
    const DistanceResult as_A = solver.solve(moved, Q);
    const DistanceResult of_box = solver.solve(Box(shift - Vector::Ones(n), shift + Vector::Ones(n)), Q);
    EXPECT_EQ(as_A.status, of_box.status) << n;
    EXPECT_NEAR(as_A.lower, of_box.lower, 2e-6 * of_box.lower) << n;
  }
}

TEST(HPolytope, ContainsWhatItsInequalitiesAllow) {
  const HPolytope simplex = corner_simplex(3);
  EXPECT_EQ(contains(simplex, Vector{{0.2, 0.3, 0.1}}), Membership::inside);
  EXPECT_EQ(contains(simplex, Vector{{0.5, 0.6, 0.1}}), Membership::outside);
  EXPECT_EQ(contains(simplex, Vector{{0.5, -0.1, 0.1}}), Membership::outside);
}

// Many inequalities whose planes are nearly the same: bases that rounding all but makes singular.
HPolytope nearly_parallel(int n, double apart, Random& random) {
  const int planes = 6 * n;
  Eigen::MatrixXd G(planes + 2 * n, n);
  const Vector common = gaussian_points(n, 1, random).col(0).normalized();
  for (int i = 0; i < planes; ++i)
    G.row(i) = (common + apart * gaussian_points(n, 1, random).col(0)).transpose();
  G.bottomRows(2 * n) << Eigen::MatrixXd::Identity(n, n), -Eigen::MatrixXd::Identity(n, n);
  Vector g = Vector::Ones(planes + 2 * n);
  g.tail(2 * n) *= 10;
  return {G, g};
}

// g_i - G_i·x for the inequality that x breaks most, in twice the precision.
double least_slack(const HPolytope& S, const Vector& x) {
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < S.g().size(); ++i) {
    DoubleDouble slack{S.g()[i], 0};
    for (Eigen::Index k = 0; k < x.size(); ++k) slack = slack - two_product(S.G()(i, k), x[k]);
    least = std::min(least, slack.rounded());
  }
  return least;
}

TEST(HPolytope, SupportIsProvenWhereBasesAreNearlySingular) {
  Random random(7);
  for (const double apart : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
    for (const int n : {2, 3, 8, 20}) {
      const HPolytope S = nearly_parallel(n, apart, random);
      Vector magnitude(n);
      S.magnitude_unchecked(magnitude.data());
      const double rounding = ConvexSet::rounding_error(n);
      Eigen::MatrixXd inside(n, 12), directions(n, 12);
      for (int j = 0; j < 12; ++j) {
        directions.col(j) = gaussian_points(n, 1, random).col(0);
        if (j >= 6) directions.col(j) = S.G().row(j).transpose() + 1e-3 * apart * directions.col(j);
        inside.col(j) = S.support_mapping(directions.col(j));
        EXPECT_GE(least_slack(S, inside.col(j)), -rounding * S.G().cwiseAbs().maxCoeff() * magnitude.sum());
      }
      for (int j = 0; j < 12; ++j) {
        const double h = S.support_function(directions.col(j));
        const double greatest = (directions.col(j).transpose() * inside).maxCoeff();
        EXPECT_GE(h, greatest - rounding * directions.col(j).cwiseAbs().dot(magnitude)) << n << ' ' << apart;
      }
    }
  }
}

TEST(HPolytope, RefusesWhatHasNoInterior) {
  Eigen::MatrixXd G(6, 2);
  G << 1, 0, -1, 0, 0, 1, 0, -1, 1, 1, -1, -1;
  EXPECT_THROW(HPolytope(G, Vector{{2, 2, 2, 2, 1, -1}}), InvalidParameterError);        // x + y = 1
  EXPECT_THROW(HPolytope(G.topRows(4), Vector{{3, -3, 4, -4}}), InvalidParameterError);  // a point
}

TEST(HPolytope, TellsEmptyFromUnboundedWhereThereIsNoVertexToSeeItAt) {
  const auto complaint = [](const Eigen::MatrixXd& G, const Vector& g) -> std::string {
    try {
      const HPolytope set(G, g);
    } catch (const Error& error) {
      return error.what();
    }
    return "nothing was thrown";
  };
  const std::string empty = "h_polytope: {x : G x <= g} is empty";
  const std::string unbounded = "h_polytope: {x : G x <= g} is not bounded";
  for (const double size : {1e-9, 1.0, 1e9}) {
    const Vector apart{{-size, -size}};
    EXPECT_EQ(complaint(Eigen::MatrixXd{{1, 0, 0}, {-1, 0, 0}}, apart), empty) << size;
    EXPECT_EQ(complaint(Eigen::MatrixXd{{1, 2, 3}, {-1, -2, -3}}, apart), empty) << size;
    EXPECT_EQ(complaint(Eigen::MatrixXd{{1, 0}, {-1, 0}, {0, 1}}, Vector{{-size, -size, 5}}), empty) << size;
    EXPECT_EQ(
        complaint(Eigen::MatrixXd{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}, Vector{{size, size, -size, -size}}),
        empty)
        << size;
    EXPECT_EQ(complaint(Eigen::MatrixXd{{1, 0, 0}, {-1, 0, 0}}, -2 * apart), unbounded) << size;
    EXPECT_EQ(complaint(Eigen::MatrixXd{{-1, 0}, {0, -1}}, apart), unbounded) << size;
    // Points begin at x = 3e5, y = 1e6: two lines that meet far away
    EXPECT_EQ(complaint(Eigen::MatrixXd{{-1, 0}, {1, -0.3}}, Vector{{-3e5 * size, 0}}), unbounded) << size;
  }
}

TEST(HPolytope, RefusesWhatIsEmptyUnboundedOrMisshapen) {
  const Eigen::MatrixXd I = Eigen::MatrixXd::Identity(2, 2);
  Eigen::MatrixXd strip(2, 2);
  strip << 1, 0, -1, 0;
  EXPECT_THROW(HPolytope(I, Vector::Ones(2)), InvalidParameterError);
  EXPECT_THROW(HPolytope(strip, Vector::Ones(2)), InvalidParameterError);
  Eigen::MatrixXd square(4, 2);
  square << I, -I;
  EXPECT_THROW(HPolytope(square, Vector{{1, 1, -2, 1}}), EmptySetError);
  EXPECT_THROW(HPolytope(I, Vector::Ones(3)), DimensionMismatchError);
  EXPECT_THROW(HPolytope(Eigen::MatrixXd::Zero(1, 2), Vector::Ones(1)), InvalidParameterError);
  EXPECT_THROW(HPolytope(Eigen::MatrixXd::Zero(0, 2), Vector::Zero(0)), InvalidParameterError);
  EXPECT_THROW(HPolytope(I, Vector::Constant(2, std::numeric_limits<double>::quiet_NaN())), NonFiniteError);
}

}  // namespace
}  // namespace raygauge
