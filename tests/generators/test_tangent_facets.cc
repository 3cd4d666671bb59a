// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/tangent_facets.h"

#include <gtest/gtest.h>

#include "raygauge/exceptions.h"
#include "raygauge/queries/solver.h"
#include "raygauge/sets/polytopes.h"
#include "tests/generators/points_of.h"

namespace raygauge::test_tangent_facets {
namespace {

// Of c, of the bounds 1 - g·c and of the distance itself: a few roundings of numbers about 3.
constexpr double kTruth = 1e-13;

const HPolytope& polytope(const std::shared_ptr<const ConvexSet>& set) {
  return dynamic_cast<const HPolytope&>(*set);
}

TEST(TangentFacets, EveryInequalityOfQTouchesTheUnitSphere) {
  const Instance instance = generate("tangent_facets", {1, 4, 21, 0});
  const HPolytope& Q = polytope(instance.Q);
  ASSERT_EQ(Q.G().rows(), 21);
  for (Eigen::Index i = 0; i < Q.G().rows(); ++i) EXPECT_NEAR(Q.g()[i] / Q.G().row(i).norm(), 1, 1e-14);
}

TEST(TangentFacets, BothMethodsEncloseTheDistanceThatItStates) {
  for (const DistanceMethod method : {DistanceMethod::column_generation, DistanceMethod::zheng_yamane}) {
    DistanceOptions options;
    options.method = method;
    DistanceSolver solver(options);
    for (const int n : {2, 3, 5, 12}) {
      for (const double separation : {1.0, 1.5, 20.0}) {
        const Instance instance =
            generate("tangent_facets", {1, n, 4 * n + 1, 0}, {{"separation", separation}});
        const double truth = 2 * separation - 1;
        ASSERT_EQ(instance.exact_distance, truth);
        const DistanceResult& result = solver.solve(*instance.A, *instance.Q);
        EXPECT_EQ(result.status, DistanceStatus::optimal) << n << ' ' << separation;
        EXPECT_LE(result.lower, truth * (1 + kTruth)) << n << ' ' << separation;
        EXPECT_GE(result.upper, truth * (1 - kTruth)) << n << ' ' << separation;
      }
    }
  }
}

// d of the polytope and of points against each other: one method proves what the other finds.
TEST(TangentFacets, StandsInEitherRoleWithPointsInTheOther) {
  DistanceSolver columns;
  DistanceOptions options;
  options.method = DistanceMethod::zheng_yamane;
  DistanceSolver rays(options);
  for (const std::string roles : {"polytope_points", "points_polytope"}) {
    const Instance instance = generate("tangent_facets", {3, 4, 60, 1}, {{"roles", roles}});
    EXPECT_FALSE(instance.exact_distance);
    const ConvexSet& of_facets = roles == "polytope_points" ? *instance.A : *instance.Q;
    EXPECT_NE(dynamic_cast<const HPolytope*>(&of_facets), nullptr) << roles;
    const DistanceResult found = columns.solve(*instance.A, *instance.Q);
    const DistanceResult& other = rays.solve(*instance.A, *instance.Q);
    EXPECT_EQ(found.status, DistanceStatus::optimal) << roles;
    EXPECT_EQ(other.status, DistanceStatus::optimal) << roles;
    EXPECT_LE(found.lower, other.upper) << roles;
    EXPECT_LE(other.lower, found.upper) << roles;
    EXPECT_GT(found.lower, 0) << roles;
  }
}

TEST(TangentFacets, RefusesFewerFacetsThanBoundAPolytope) {
  EXPECT_THROW(generate("tangent_facets", {1, 5, 9, 0}), InvalidParameterError);
}

}  // namespace
}  // namespace raygauge::test_tangent_facets
