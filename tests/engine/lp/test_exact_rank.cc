// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/exact_rank.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

#include "tests/engine/point_clouds.h"

namespace raygauge::test_exact_rank {
namespace {

// Integers with B x = e_m for an x that is zero but in its last `support` components: the last columns, times
// the coefficients given, make e_m.
Eigen::MatrixXd matrix_with_support(int m, int support, Random& random) {
  Eigen::MatrixXd B = integer_points(m, m, 1000, random);
  B.col(m - 1) = Eigen::VectorXd::Unit(m, m - 1);
  for (int i = 1; i < support; ++i) B.col(m - 1) -= 3 * B.col(m - 1 - i);
  return B;
}

std::vector<int> first_positions(int count) {
  std::vector<int> positions;
  for (int i = 0; i < count; ++i) positions.push_back(i);
  return positions;
}

bool span(const Eigen::MatrixXd& M, const std::vector<int>& chosen,
          const Stopwatch& stopwatch = Stopwatch()) {
  return columns_span({M.data(), M.rows(), static_cast<int>(M.rows()), static_cast<int>(M.cols())}, chosen,
                      stopwatch);
}

// Whether B⁻¹ e_m is zero at these positions: whether the columns at the others span e_m.
bool are_zero(const Eigen::MatrixXd& B, const std::vector<int>& positions,
              const Stopwatch& stopwatch = Stopwatch()) {
  const auto m = static_cast<int>(B.cols());
  Eigen::MatrixXd M(m, 0);
  for (int i = 0; i < m; ++i) {
    if (std::find(positions.begin(), positions.end(), i) != positions.end()) continue;
    M.conservativeResize(m, M.cols() + 1);
    M.col(M.cols() - 1) = B.col(i);
  }
  const std::vector<int> chosen = first_positions(static_cast<int>(M.cols()));
  M.conservativeResize(m, M.cols() + 1);
  M.col(M.cols() - 1) =
      std::exp2(std::ilogb(B.row(m - 1).cwiseAbs().maxCoeff())) * Eigen::VectorXd::Unit(m, m - 1);
  return span(M, chosen, stopwatch);
}

TEST(ExactRank, ProvesComponentsThatAreZero) {
  Random random(41);
  for (const int m : {1, 2, 3, 11, 51}) {
    for (const int support : {1, 2, m / 2 + 1}) {
      if (support > m) continue;
      const Eigen::MatrixXd B = matrix_with_support(m, support, random);
      EXPECT_TRUE(are_zero(B, first_positions(m - support))) << "m = " << m << ", support = " << support;
    }
  }
}

TEST(ExactRank, FindsEveryComponentThatIsNot) {
  Random random(42);
  for (const int m : {2, 11, 51}) {
    const int support = m / 2 + 1;
    const Eigen::MatrixXd B = matrix_with_support(m, support, random);
    for (int i = m - support; i < m; ++i) {
      EXPECT_FALSE(are_zero(B, {i})) << "m = " << m << ", i = " << i;
    }
  }
}

// x_0 = ∓ 2^-40 to 2^-960 or so: no enclosure in a few doubles tells it from zero.
TEST(ExactRank, TellsTinyComponentsFromZero) {
  for (const int m : {2, 9, 25}) {
    Eigen::MatrixXd B = Eigen::MatrixXd::Identity(m, m) * 0x1p20;
    for (int k = 0; k + 1 < m; ++k) B(k, k + 1) = 0x1p-20;
    B(m - 1, m - 1) = 1;
    EXPECT_FALSE(are_zero(B, {0})) << "m = " << m;
    B(0, 1) = 0;
    EXPECT_TRUE(are_zero(B, {0})) << "m = " << m;
  }
}

TEST(ExactRank, DoesNotDependOnPowersOfTwoOfRows) {
  Random random(43);
  Eigen::MatrixXd B = matrix_with_support(11, 4, random);
  for (int k = 0; k < 11; ++k) B.row(k) *= std::ldexp(1.0, 90 * k - 450);
  EXPECT_TRUE(are_zero(B, first_positions(7)));
  EXPECT_FALSE(are_zero(B, first_positions(8)));
}

TEST(ExactRank, DecidesNothingWhereIntegersAreLongOrTheMatrixIsSingular) {
  Eigen::Matrix2d B;
  B << 1, 0x1p-70, 0, 1;
  EXPECT_FALSE(span(B, {0, 1})) << "71 bits";
  B << 0, 0, 1, 1;
  EXPECT_FALSE(span(B, {0, 1})) << "singular";
  B << 2147483647.0, 0, 0, 1;
  EXPECT_FALSE(span(B, {0, 1})) << "singular modulo the prime, and independent all the same";
}

TEST(ExactRank, EndsWithTheStopwatch) {
  Random random(44);
  const Eigen::MatrixXd B = matrix_with_support(11, 4, random);
  Stopwatch late;
  late.start(0);
  EXPECT_FALSE(are_zero(B, first_positions(7), late));
}

// Of rank r: r columns chosen, the others combinations of them; more of these than rows beyond r, and fewer.
TEST(ExactRank, ProvesAndDeniesThatColumnsSpanAMatrix) {
  Random random(45);
  for (const auto& [m, r, others] :
       {std::tuple{12, 5, 2}, {12, 10, 40}, {30, 1, 3}, {30, 29, 5}, {7, 7, 3}}) {
    const Eigen::MatrixXd chosen = integer_points(m, r, 1000, random);
    Eigen::MatrixXd M(m, others + r);
    M << chosen * integer_points(r, others, 5, random), chosen;
    std::vector<int> last(static_cast<std::size_t>(r));
    std::iota(last.begin(), last.end(), others);
    EXPECT_TRUE(span(M, last)) << "rank " << r << " of " << m;
    if (r == m) continue;
    M(m / 2, 1) += 1;
    EXPECT_FALSE(span(M, last)) << "rank " << r << " of " << m;
  }
}

TEST(ExactRank, RefusesChosenColumnsThatDepend) {
  Random random(46);
  Eigen::MatrixXd M = integer_points(9, 5, 1000, random);
  M.col(2) = M.col(0) - 2 * M.col(4);
  EXPECT_FALSE(span(M, {0, 2, 4}));
  EXPECT_TRUE(span(M, {0, 1, 3, 4}));
}

}  // namespace
}  // namespace raygauge::test_exact_rank
