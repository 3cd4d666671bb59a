// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/hard/polytopes.h"

#include <gtest/gtest.h>

#include "generators/random.h"
#include "raygauge/exceptions.h"
#include "tests/generators/hard/brute_force.h"

namespace raygauge::test_polytopes {
namespace {

TEST(Polytopes, TheGaugeOfIntegerPointsIsThatOfTheVertices) {
  RandomStream stream({}, "test_polytopes", RandomPurpose::shape);
  for (const Body body : {Body::cross_polytope, Body::cube, Body::simplex}) {
    for (int i = 0; i < 20; ++i) {
      Vector x(3);
      for (double& coordinate : x) coordinate = static_cast<double>(stream.integer(-9, 9));
      EXPECT_EQ(brute_force_distance(x, vertices(body, 3)), Rational(gauge(body, x))) << x.transpose();
    }
  }
}

TEST(Polytopes, HaveTheirNumberOfVertices) {
  EXPECT_EQ(vertices(Body::cross_polytope, 50).cols(), 100);
  EXPECT_EQ(vertices(Body::simplex, 50).cols(), 51);
  EXPECT_EQ(vertices(Body::cube, 12).cols(), 4096);
}

TEST(Polytopes, ACubeOfTooManyVerticesIsRefused) {
  EXPECT_THROW(vertices(Body::cube, 13), InvalidParameterError);
  EXPECT_THROW(box(Vector::Zero(50), Vector::Ones(50)), InvalidParameterError);
}

TEST(Polytopes, AFacetStandsOnItsPlaneUnderItsApex) {
  const Eigen::MatrixXd points = facet_and_apex(3, 0.5, 2);
  ASSERT_EQ(points.cols(), 5);
  EXPECT_EQ(points.row(0), (Eigen::RowVectorXd(5) << 0.5, 0.5, 0.5, 0.5, 2).finished());
  EXPECT_EQ(points.rowwise().sum().tail(2), Vector::Zero(2));
  EXPECT_EQ(points.bottomRows(2).cwiseAbs().rowwise().sum(), Vector::Constant(2, 2));
}

}  // namespace
}  // namespace raygauge::test_polytopes
