// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "raygauge/exceptions.h"
#include "tests/linear_algebra.h"

namespace raygauge::test_random {
namespace {

constexpr int kSamples = 100000;

RandomStream stream_of(const InstanceKey& key = {}, RandomPurpose purpose = RandomPurpose::shape) {
  return RandomStream(key, "test", purpose);
}

TEST(RandomStream, ReproducesItsGoldenValues) {
  RandomStream stream = stream_of();
  EXPECT_EQ(stream.bits(), 0xe1497c87298347fcu);
  EXPECT_EQ(stream.uniform(), 0x1.1e384dc66c7c2p-1);
  EXPECT_EQ(stream.normal(), -0x1.1b423f8bbb36dp-6);
  EXPECT_EQ(stream.integer(1, 1000), 386);
  EXPECT_EQ(stream.unit_vector(3)[0], -0x1.38a8014783bf6p-1);
  EXPECT_EQ(stream.rotation(4)(0, 3), -0x1.fb12bb70b5955p-2);
  EXPECT_EQ(stable_hash("example2"), 0xc2344eee4445e369u);
}

TEST(RandomStream, IsAFunctionOfItsKeyNotOfTheOrderOfUse) {
  RandomStream first = stream_of({7, 4, 10, 2});
  RandomStream other = stream_of({8, 4, 10, 2});
  std::array<std::uint64_t, 9> alone{};
  for (auto& word : alone) word = first.bits();
  RandomStream again = stream_of({7, 4, 10, 2});
  for (const auto word : alone) {
    other.bits();
    EXPECT_EQ(again.bits(), word);
  }
}

TEST(RandomStream, EveryPartOfTheKeyMatters) {
  std::set<std::uint64_t> firsts;
  for (const InstanceKey& key : {InstanceKey{1, 3, 9, 0}, InstanceKey{2, 3, 9, 0}, InstanceKey{1, 4, 9, 0},
                                 InstanceKey{1, 3, 8, 0}, InstanceKey{1, 9, 3, 0}, InstanceKey{1, 3, 9, 1}}) {
    firsts.insert(stream_of(key).bits());
  }
  firsts.insert(stream_of({1, 3, 9, 0}, RandomPurpose::order).bits());
  firsts.insert(RandomStream({1, 3, 9, 0}, "tests", RandomPurpose::shape).bits());
  EXPECT_EQ(firsts.size(), 8u);
}

TEST(RandomStream, UniformNumbersFillTheUnitInterval) {
  constexpr int kBins = 20;
  std::array<int, kBins> histogram{};
  RandomStream stream = stream_of();
  for (int i = 0; i < kSamples; ++i) {
    const double x = stream.uniform();
    ASSERT_TRUE(0 <= x && x < 1);
    ++histogram[static_cast<std::size_t>(x * kBins)];
  }
  double chi2 = 0;
  const double expected = static_cast<double>(kSamples) / kBins;
  for (const int count : histogram) chi2 += (count - expected) * (count - expected) / expected;
  EXPECT_LT(chi2, 43.8);  // the 99.9 % quantile of chi-squared with 19 degrees of freedom
  EXPECT_GT(chi2, 5.4);   // and its 0.1 % quantile: too even is not random either
}

TEST(RandomStream, NormalNumbersHaveTheMomentsOfTheNormalDistribution) {
  RandomStream stream = stream_of();
  std::array<double, 4> moments{};
  for (int i = 0; i < kSamples; ++i) {
    const double x = stream.normal();
    double power = 1;
    for (double& moment : moments) moment += (power *= x) / kSamples;
  }
  // Four standard errors of each mean: the variances of x, x², x³, x⁴ are 1, 2, 15, 96.
  const double error = 4 / std::sqrt(kSamples);
  EXPECT_NEAR(moments[0], 0, error);
  EXPECT_NEAR(moments[1], 1, error * std::sqrt(2));
  EXPECT_NEAR(moments[2], 0, error * std::sqrt(15));
  EXPECT_NEAR(moments[3], 3, error * std::sqrt(96));
}

TEST(RandomStream, IntegersCoverTheirRangeEvenly) {
  RandomStream stream = stream_of();
  std::array<int, 7> histogram{};
  for (int i = 0; i < kSamples; ++i) ++histogram[static_cast<std::size_t>(stream.integer(-3, 3) + 3)];
  const double expected = kSamples / 7.0;
  for (const int count : histogram) EXPECT_NEAR(count, expected, 4 * std::sqrt(expected));
  EXPECT_EQ(stream.integer(5, 5), 5);
  EXPECT_THROW(stream.integer(1, 0), InvalidParameterError);
}

TEST(RandomStream, IntegersMayHaveTheWholeRange) {
  RandomStream stream = stream_of();
  RandomStream raw = stream_of();
  EXPECT_EQ(stream.integer(INT64_MIN, INT64_MAX), static_cast<std::int64_t>(raw.bits()));
}

TEST(RandomStream, UnitVectorsAreUniformOnTheSphere) {
  RandomStream stream = stream_of();
  constexpr int n = 5;
  Eigen::Matrix<double, n, n> covariance = Eigen::Matrix<double, n, n>::Zero();
  Vector mean = Vector::Zero(n);
  constexpr int kVectors = kSamples / n;
  for (int i = 0; i < kVectors; ++i) {
    const Vector x = stream.unit_vector(n);
    ASSERT_NEAR(x.norm(), 1, 4e-16);
    mean += x / kVectors;
    covariance += x * x.transpose() / kVectors;
  }
  // Four standard errors; a coordinate has variance 1/n.
  EXPECT_LT(mean.cwiseAbs().maxCoeff(), 4 / std::sqrt(1.0 * n * kVectors));
  EXPECT_LT((n * covariance - Eigen::Matrix<double, n, n>::Identity()).cwiseAbs().maxCoeff(),
            4 * std::sqrt(2.0 / kVectors));
}

TEST(RandomStream, RotationsAreOrthogonalWithDeterminantOne) {
  RandomStream stream = stream_of();
  for (int n = 1; n <= 12; ++n) {
    const Eigen::MatrixXd R = stream.rotation(n);
    EXPECT_LT((R.transpose() * R - Eigen::MatrixXd::Identity(n, n)).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_NEAR(determinant(R), 1, 1e-13);
  }
}

TEST(RandomStream, RotationsAreUniformInEveryEntry) {
  RandomStream stream = stream_of();
  constexpr int n = 3;
  constexpr int kRotations = 20000;
  Eigen::Matrix3d mean = Eigen::Matrix3d::Zero(), square = Eigen::Matrix3d::Zero();
  for (int i = 0; i < kRotations; ++i) {
    const Eigen::Matrix3d R = stream.rotation(n);
    mean += R / kRotations;
    square += R.cwiseAbs2() / kRotations;
  }
  // An entry of a random rotation of R^3 is uniform on [-1, 1]: variances 1/3 and, of the square, 4/45.
  EXPECT_LT(mean.cwiseAbs().maxCoeff(), 4 * std::sqrt(1.0 / 3 / kRotations));
  EXPECT_LT((square - Eigen::Matrix3d::Constant(1.0 / 3)).cwiseAbs().maxCoeff(),
            4 * std::sqrt(4.0 / 45 / kRotations));
}

TEST(RandomStream, PermutationsHoldEveryIndexOnce) {
  RandomStream stream = stream_of();
  const auto order = stream.permutation(100);
  EXPECT_EQ(std::set<std::ptrdiff_t>(order.begin(), order.end()).size(), 100u);
  EXPECT_EQ(*std::max_element(order.begin(), order.end()), 99);
  EXPECT_NE(order, stream.permutation(100));
}

TEST(RandomStream, VectorsOfNoDimensionAreRefused) {
  RandomStream stream = stream_of();
  EXPECT_THROW(stream.unit_vector(0), InvalidParameterError);
  EXPECT_THROW(stream.rotation(0), InvalidParameterError);
}

}  // namespace
}  // namespace raygauge::test_random
