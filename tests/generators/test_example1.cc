// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/example1.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "raygauge/exceptions.h"
#include "raygauge/queries/solver.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/truncated_cone.h"
#include "tests/generators/points_of.h"

namespace raygauge::test_example1 {
namespace {

// The emitted doubles are rounded, and with them the contact; see generators/example1.h.
constexpr double kTruth = 0x1p-46;

const std::string kConeEllipsoid = "cone_ellipsoid";
const std::string kEllipsoidCone = "ellipsoid_cone";

Instance pair(int repetition, double distance, const std::string& roles, int n = 3) {
  return generate("example1", {1, n, 1, repetition}, {{"distance", distance}, {"roles", roles}});
}

const TruncatedCone& cone_of(const std::shared_ptr<const ConvexSet>& set) {
  return dynamic_cast<const TruncatedCone&>(*set);
}

const Ellipsoid& ellipsoid_of(const std::shared_ptr<const ConvexSet>& set) {
  return dynamic_cast<const Ellipsoid&>(*set);
}

TEST(Example1, HasTheDistanceThatItClaims) {
  DistanceOptions options;
  options.method = DistanceMethod::zheng_yamane;
  options.tolerance = 1e-8;
  DistanceSolver solver(options);
  for (const int n : {2, 3, 5}) {
    for (int repetition = 0; repetition < 20; ++repetition) {
      for (const double distance : {1.0, 2.0, 0.5, 1e-3, 1e3}) {
        for (const std::string& roles : {kConeEllipsoid, kEllipsoidCone}) {
          const Instance instance = pair(repetition, distance, roles, n);
          const DistanceResult& result = solver.solve(*instance.A, *instance.Q);
          ASSERT_EQ(instance.exact_distance, distance);
          EXPECT_LE(result.lower, distance * (1 + kTruth)) << n << " " << repetition << " " << roles;
          EXPECT_GE(result.upper, distance * (1 - kTruth)) << n << " " << repetition << " " << roles;
        }
      }
    }
  }
}

// On these, `column_generation` once met the same support points for ever: reduced costs made of rounding, at
// bounds on the normal that were never raised.
TEST(Example1, DirectClosesTheGapWhereItOnceStalled) {
  DistanceOptions options;
  options.tolerance = 1e-8;
  options.time_limit = 20;
  DistanceSolver solver(options);
  const std::vector<std::pair<std::string, std::vector<int>>> stalled = {
      {kConeEllipsoid, {362, 2328, 2334, 2700}},
      {kEllipsoidCone, {339, 352, 731, 733, 811, 1087, 1115, 1272}}};
  for (const auto& [roles, repetitions] : stalled) {
    for (const int repetition : repetitions) {
      const Instance instance = pair(repetition, 1, roles);
      const DistanceResult& result = solver.solve(*instance.A, *instance.Q);
      EXPECT_EQ(result.status, DistanceStatus::optimal) << roles << " " << repetition;
      EXPECT_LE(result.counters.support_queries, 2000) << roles << " " << repetition;
      EXPECT_LE(result.lower, 1 + kTruth);
      EXPECT_GE(result.upper, 1 - kTruth);
    }
  }
}

TEST(Example1, GivesBothBodiesTheRolesAskedFor) {
  const Instance one = pair(0, 1, kConeEllipsoid), other = pair(0, 1, kEllipsoidCone);
  const TruncatedCone& cone_A = cone_of(one.A);
  const TruncatedCone& cone_Q = cone_of(other.Q);
  EXPECT_EQ(cone_A.base_radius(), cone_Q.base_radius());
  EXPECT_EQ(ellipsoid_of(one.Q).factor(), ellipsoid_of(other.A).factor());
  EXPECT_EQ(one.Q->center(), Vector::Zero(3));
  EXPECT_EQ(other.Q->center(), Vector::Zero(3));
  // The relative position of the two is the same.
  EXPECT_LT((one.A->center() + other.A->center()).norm(), 1e-15);
}

TEST(Example1, ScalesQAloneByTheDistance) {
  for (const std::string& roles : {kConeEllipsoid, kEllipsoidCone}) {
    const Instance contact = pair(3, 1, roles), separated = pair(3, 2, roles),
                   penetrating = pair(3, 0.5, roles);
    const Vector u = Vector::LinSpaced(3, -1, 2);
    EXPECT_EQ(contact.A->support_mapping(u), separated.A->support_mapping(u));
    EXPECT_EQ(contact.A->support_mapping(u), penetrating.A->support_mapping(u));
    EXPECT_EQ(contact.Q->support_mapping(u), 2 * separated.Q->support_mapping(u));
    EXPECT_EQ(2 * contact.Q->support_mapping(u), penetrating.Q->support_mapping(u));
  }
}

TEST(Example1, DrawsSizesFromTheDocumentedRanges) {
  for (int repetition = 0; repetition < 500; ++repetition) {
    const Instance instance = pair(repetition, 1, kConeEllipsoid);
    const TruncatedCone& cone = cone_of(instance.A);
    const double height = (cone.top() - cone.base()).norm();
    const Vector axes = ellipsoid_of(instance.Q).factor().colwise().norm();
    for (const double size : {height, cone.base_radius(), axes.minCoeff(), axes.maxCoeff()}) {
      EXPECT_GE(size, 0.5 - 1e-15);
      EXPECT_LE(size, 1.5 + 1e-15);
    }
    EXPECT_LE(cone.top_radius(), cone.base_radius());
    EXPECT_GE(cone.top_radius(), 0);
  }
}

TEST(Example1, RefusesALineAndDistancesThatAreNone) {
  EXPECT_THROW(pair(0, 1, kConeEllipsoid, 1), InvalidParameterError);
  EXPECT_THROW(pair(0, 0, kConeEllipsoid), InvalidParameterError);
  EXPECT_THROW(pair(0, 1, "cone"), UnknownNameError);
}

TEST(Example1, ReproducesItsGoldenSizes) {
  const Instance instance = pair(0, 1, kConeEllipsoid);
  EXPECT_EQ(cone_of(instance.A).base_radius(), 0x1.2498850f79854p-1);
  EXPECT_EQ(cone_of(instance.A).base()[0], 0x1.254b7487c652p+0);
  EXPECT_EQ(ellipsoid_of(instance.Q).factor()(2, 2), -0x1.0d21079dc4ba9p-1);
}

}  // namespace
}  // namespace raygauge::test_example1
