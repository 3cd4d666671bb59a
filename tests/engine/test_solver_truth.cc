// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "tests/engine/both_methods.h"
#include "tests/engine/point_clouds.h"
#include "tests/engine/rational.h"
#include "tests/generators/hard/brute_force.h"

namespace raygauge {
namespace {

using Matrix = Eigen::MatrixXd;

// Whether the result says nothing false of the exact distance (empty: no multiple of Q meets A).
::testing::AssertionResult is_true(const DistanceResult& result, const Matrix& A, const Matrix& Q) {
  const std::optional<Rational> exact = brute_force_distance(A, Q);
  const bool says_unreachable = result.status == DistanceStatus::unreachable;
  const bool says_zero = result.status == DistanceStatus::contains_origin;
  const bool claims_width = result.status == DistanceStatus::optimal;
  const bool ordered = result.lower <= result.distance && result.distance <= result.upper;
  bool holds = ordered && (exact ? encloses(result.lower, result.upper, *exact) && !says_unreachable
                                 : std::isinf(result.upper) && !says_zero && !claims_width);
  if (says_zero) holds = holds && *exact == 0;
  if (claims_width) holds = holds && std::isfinite(result.upper);
  if (holds) return ::testing::AssertionSuccess();
  std::ostringstream data;
  data.precision(17);
  data << "A =\n" << A << "\nQ =\n" << Q << "\nexact ";
  data << (exact ? exact->convert_to<double>() : std::numeric_limits<double>::infinity());
  return ::testing::AssertionFailure()
         << to_string(result.status) << " [" << result.lower << ", " << result.upper << "]\n"
         << data.str();
}

// Doubles as they come: ties, zeros, and magnitudes that differ by up to 2^spread within one coordinate.
Matrix wild_points(int n, int N, int spread, Random& random) {
  Matrix points = random() % 2 == 0 ? gaussian_points(n, N, random) : integer_points(n, N, 2, random);
  if (spread == 0) return points;
  for (double& x : points.reshaped()) {
    x = std::ldexp(x, static_cast<int>(random() % static_cast<unsigned>(2 * spread)) - spread);
  }
  return points;
}

class Truth : public BothMethods {
 protected:
  static void hold_random_instances(int count, int spread, std::uint64_t seed) {
    Random random(seed);
    for (int trial = 0; trial < count; ++trial) {
      const int n = 1 + trial % 3;
      const Matrix A = wild_points(n, 1 + static_cast<int>(random() % 5), spread, random);
      const Matrix Q = wild_points(n, 1 + static_cast<int>(random() % 6), spread, random);
      ASSERT_TRUE(is_true(solve(A, Q, trial % 2 == 0 ? 1e-6 : 1e-12, Effects::witness), A, Q));
    }
  }
};
RAYGAUGE_BOTH_METHODS(Truth);

TEST_P(Truth, HoldsOnSmallSetsOfAnyRank) { hold_random_instances(600, 0, 141); }

TEST_P(Truth, HoldsWhereCoordinatesDifferByTwentyBinaryOrders) { hold_random_instances(300, 20, 142); }

TEST_P(Truth, HoldsWhereCoordinatesDifferByTwoHundredBinaryOrders) { hold_random_instances(150, 200, 143); }

TEST_P(Truth, HoldsOverTheWholeRangeOfDoubles) { hold_random_instances(150, 1000, 144); }

TEST_P(Truth, HoldsForSinglePointsAndSegments) {
  Random random(145);
  for (int trial = 0; trial < 300; ++trial) {
    const int n = 1 + trial % 4;
    const Matrix A = integer_points(n, 1 + trial % 2, 4, random);
    const Matrix Q = trial % 3 == 0 ? cube_vertices(n).eval() : integer_points(n, 1 + trial % 7, 3, random);
    ASSERT_TRUE(is_true(solve(A, Q, 1e-9), A, Q));
  }
}

TEST_P(Truth, HoldsForTheContactPointToo) {
  // v lies in A and in d·Q: both checked with rational arithmetic, by how much A about its centre and Q about
  // the origin must grow to hold the rounded v.
  Random random(146);
  for (int trial = 0; trial < 30; ++trial) {
    const int n = 2 + trial % 2;
    Matrix A = gaussian_points(n, 6, random);
    A.row(0).array() += 4;
    Matrix Q(n, 6);
    Q.leftCols(3) = gaussian_points(n, 3, random);
    Q.rightCols(3) = -Q.leftCols(3);
    const DistanceResult result = solve(A, Q, 1e-9, Effects::witness);
    ASSERT_EQ(result.status, DistanceStatus::optimal);
    const Vector& v = result.contact_point;
    const auto gauge = brute_force_distance(v, Q);
    ASSERT_TRUE(gauge);
    EXPECT_NEAR(gauge->convert_to<double>(), result.distance, 1e-8 * result.distance);
    const Vector center = A.rowwise().mean();
    const auto growth = brute_force_distance(v - center, A.colwise() - center);
    ASSERT_TRUE(growth);
    EXPECT_LE(growth->convert_to<double>(), 1 + 1e-8);
  }
}

TEST_P(Truth, SaysSoWhereTheOriginIsInsideOnAFaceOrAtAVertexOfA) {
  for (const int n : {1, 2, 3, 4}) {
    const Matrix cube = cube_vertices(n);
    for (const double shift : {0.0, 0.5, 1.0}) {
      Matrix face = cube;
      face.row(0).array() += shift;
      const DistanceResult result = solve(face, cross_polytope_vertices(n));
      EXPECT_EQ(result.status, DistanceStatus::contains_origin) << "n = " << n << ", shift " << shift;
      EXPECT_EQ(result.distance, 0);
      EXPECT_EQ(result.upper, 0);
    }
    EXPECT_EQ(solve(cube.array() + 1, cross_polytope_vertices(n)).status, DistanceStatus::contains_origin);
  }
}

TEST_P(Truth, ShowsAFarkasDirectionWhereNoMultipleOfQReaches) {
  Matrix half(2, 3);
  half << 0, 0, 2, 1, -1, 0;
  Matrix behind(2, 2);
  behind << -1, -2, 3, 0.5;
  const DistanceResult result = solve(behind, half);
  EXPECT_EQ(result.status, DistanceStatus::unreachable);
  EXPECT_LT(exact_support(behind, result.normal), 0);
  EXPECT_LE(exact_support(half, -result.normal), 0);
}

}  // namespace
}  // namespace raygauge
