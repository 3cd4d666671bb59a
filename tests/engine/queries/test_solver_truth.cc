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

namespace raygauge::test_solver_truth {
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

TEST_P(Truth, HoldsWhereTheProgramIsLostInOverflow) {
  Matrix A(3, 4);
  A << 8.5350584740862135e+242, -1.8909140209225187e-124, -6.365737426045269e+88, 2.9290953396399042e-244,  //
      0, 0, -4.0564819207303341e+31, 0,                                                                     //
      524288, -2.3792270535644529e+285, -2.6727647100921956e-51, -2.259211166966574e+220;
  Matrix Q(3, 6);
  Q << 2.5971138516352352e-266, -9.9764280515985282e+142, 1.2803682754477129e-121, 6.3580633550034209e-140,
      -3.6284801164032965e-71, 1.7335252528715833e-298,  //
      -1.1834392701356432e-152, -7.5115667952295464e-38, 2.1945890180959678e+272, -6.1934945100457412e+81,
      -1.8701295567345085e-268, -3.4157586545090045e+285,  //
      1.6779544074025752e-270, 1.1807347700204712e+73, 2.2059225191769664e+129, 1.4805169142520184e-90,
      -1.5829246511567016e-125, -2.1129079194869055e+109;
  EXPECT_TRUE(is_true(solve(A, Q), A, Q));
}

TEST_P(Truth, HoldsForADistanceOutsideTheRangeOfDoubles) {
  const Matrix large = Matrix::Constant(1, 1, 2.1598472426453074e+191);
  const Matrix small = Matrix::Constant(1, 1, 6.1859455619826217e-172);
  const DistanceResult above = solve(large, small);
  EXPECT_TRUE(is_true(above, large, small));
  EXPECT_EQ(above.status, DistanceStatus::precision_limit);
  const DistanceResult below = solve(small, large);
  EXPECT_TRUE(is_true(below, small, large));
  EXPECT_EQ(below.status, DistanceStatus::precision_limit);
  EXPECT_GT(below.upper, 0);
}

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
}  // namespace raygauge::test_solver_truth
