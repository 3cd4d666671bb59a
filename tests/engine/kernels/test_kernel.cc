// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/kernels/kernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "engine/numerics/aligned_buffer.h"
#include "engine/proof/certificate.h"
#include "raygauge/exceptions.h"
#include "raygauge/sets/point_set.h"
#include "tests/engine/instruction_sets.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_kernel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class EveryInstructionSet : public ::testing::TestWithParam<InstructionSet> {
 protected:
  const Kernels& kernels() const { return kernels_for(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(Machine, EveryInstructionSet, ::testing::ValuesIn(instruction_sets_here()),
                         [](const auto& instance) { return std::string(to_string(instance.param)); });

long double exact_maximum(const Eigen::MatrixXd& points, const Vector& u) {
  return (points.transpose().cast<long double>() * u.cast<long double>()).maxCoeff();
}

// (index, value) of a collection, indices of filling lanes replaced by that of the point they copy.
std::vector<std::int64_t> collected_points(const Collection& collection, std::ptrdiff_t size) {
  std::vector<std::int64_t> indices;
  for (std::ptrdiff_t c = 0; c < collection.count; ++c) {
    indices.push_back(std::min<std::int64_t>(collection.index[c], size - 1));
  }
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  return indices;
}

TEST_P(EveryInstructionSet, FindsTheMaximumWithinItsErrorBound) {
  Random random(11);
  for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 20, 50}) {
    for (const int N : {1, 5, 8, 31, 32, 33, 64, 100, 1000}) {
      const Eigen::MatrixXd points = gaussian_points(n, N, random);
      const Vector u = gaussian_points(n, 1, random);
      const PointSet S(points);
      std::ptrdiff_t index = -1;
      const double value = kernels().price(S.data(), S.block_count(), n, u.data(), &index);
      const double error = dot_error(S, u.data());
      ASSERT_NEAR(value, static_cast<double>(exact_maximum(points, u)), error)
          << "n = " << n << ", N = " << N;
      ASSERT_GE(index, 0);
      ASSERT_LT(index, N);
      ASSERT_NEAR(points.col(index).dot(u), value, 2 * error);
    }
  }
}

TEST_P(EveryInstructionSet, GivesTheSmallestOfTiedIndices) {
  Random random(12);
  for (const int n : {1, 2, 3, 7, 10, 13}) {
    const Eigen::MatrixXd few = integer_points(n, 6, 2, random);
    Eigen::MatrixXd points(n, 600);
    for (int i = 0; i < 600; ++i) points.col(i) = few.col(i % 6);
    const PointSet S(points);
    for (int trial = 0; trial < 20; ++trial) {
      const Vector u = integer_points(n, 1, 2, random);
      std::ptrdiff_t index = -1;
      const double value = kernels().price(S.data(), S.block_count(), n, u.data(), &index);
      Eigen::Index first = 0;
      ASSERT_EQ(value, (few.transpose() * u).maxCoeff(&first));
      ASSERT_EQ(index, first);
    }
  }
}

TEST_P(EveryInstructionSet, CollectsExactlyThePointsAboveTheThreshold) {
  Random random(13);
  for (const int n : {1, 2, 3, 5, 10, 17}) {
    for (const int N : {1, 8, 30, 257}) {
      const Eigen::MatrixXd points = integer_points(n, N, 4, random);
      const Vector u = integer_points(n, 1, 4, random);
      const PointSet S(points);
      const Vector values = points.transpose() * u;
      const double threshold = values.mean();
      std::vector<std::int64_t> index(static_cast<std::size_t>(N + 16));
      std::vector<double> value(index.size());
      Collection collection{index.data(), value.data(), N + 16, 0, threshold};
      const double maximum = kernels().collect(S.data(), 0, S.block_count(), n, u.data(), &collection);

      std::vector<std::int64_t> expected;
      for (int i = 0; i < N; ++i) {
        if (values[i] > threshold) expected.push_back(i);
      }
      ASSERT_EQ(maximum, values.maxCoeff());
      ASSERT_EQ(collected_points(collection, N), expected) << "n = " << n << ", N = " << N;
      ASSERT_EQ(collection.threshold, threshold);

      // In single precision likewise: integers are exact there.
      const Eigen::VectorXf single = u.cast<float>();
      const auto at_half = static_cast<float>(std::floor(threshold) + 0.5);
      Collection collected{index.data(), value.data(), N + 16, 0, at_half};
      ASSERT_EQ(
          kernels().collect_single(S.single_data(), 0, S.single_block_count(), n, single.data(), &collected),
          values.maxCoeff());
      expected.clear();
      for (int i = 0; i < N; ++i) {
        if (values[i] > at_half) expected.push_back(i);
      }
      ASSERT_EQ(collected_points(collected, N), expected) << "n = " << n << ", N = " << N;
    }
  }
}

TEST_P(EveryInstructionSet, CollectsFromTheBlocksItIsGivenOnly) {
  const Eigen::MatrixXd points = Eigen::MatrixXd::Ones(3, 80);
  const PointSet S(points);
  std::vector<std::int64_t> index(80);
  std::vector<double> value(80);
  Collection collection{index.data(), value.data(), 80, 0, 0.0};
  const Vector u = Vector::Ones(3);
  EXPECT_EQ(kernels().collect(S.data(), 2, 9, 3, u.data(), &collection), 3);
  ASSERT_EQ(collection.count, 56);
  std::sort(index.begin(), index.begin() + collection.count);
  EXPECT_EQ(index[0], 16);
  EXPECT_EQ(index[55], 71);
}

TEST_P(EveryInstructionSet, KeepsTheBestPointsWhenMoreAreCollectedThanFit) {
  Random random(14);
  for (const int capacity : {2, 7, 64}) {
    const Eigen::MatrixXd points = gaussian_points(3, 2000, random);
    const PointSet S(points);
    const Vector u = gaussian_points(3, 1, random);
    std::vector<std::int64_t> index(static_cast<std::size_t>(capacity));
    std::vector<double> value(index.size());
    Collection collection{index.data(), value.data(), capacity, 0, -kInfinity};
    const double maximum = kernels().collect(S.data(), 0, S.block_count(), 3, u.data(), &collection);

    ASSERT_GT(collection.count, 0);
    ASSERT_LE(collection.count, capacity);
    ASSERT_GT(collection.threshold, -kInfinity);
    EXPECT_EQ(*std::max_element(value.begin(), value.begin() + collection.count), maximum);
    // What was kept is all there is above the raised threshold, so it is the best.
    const double error = dot_error(S, u.data());
    const Vector values = points.transpose() * u;
    const std::vector<std::int64_t> kept = collected_points(collection, S.size());
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      if (std::binary_search(kept.begin(), kept.end(), i)) {
        EXPECT_GE(values[i], collection.threshold - 2 * error);
      } else {
        EXPECT_LE(values[i], collection.threshold + 2 * error);
      }
    }
  }
}

TEST(Kernels, AutomaticIsTheBestInstructionSetOfThisMachine) {
  EXPECT_EQ(&kernels_for(InstructionSet::automatic), &kernels_for(best_instruction_set()));
  EXPECT_EQ(&best_kernels(), &kernels_for(best_instruction_set()));
  EXPECT_EQ(instruction_sets_here().back(), best_instruction_set());
}

TEST(Kernels, RefuseAnInstructionSetThatTheMachineLacks) {
  const std::vector<InstructionSet> here = instruction_sets_here();
  for (const InstructionSet isa : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (std::find(here.begin(), here.end(), isa) != here.end()) {
      EXPECT_NO_THROW(kernels_for(isa)) << to_string(isa);
    } else {
      EXPECT_THROW(kernels_for(isa), InvalidParameterError) << to_string(isa);
    }
  }
}

// A matrix as Kernels::invert takes it, and what it made of it.
struct Inverted {
  Inverted(const Kernels& kernels, const Eigen::MatrixXd& B, double smallest)
      : m(static_cast<int>(B.rows())), exchanged(static_cast<std::size_t>(m)) {
    const std::ptrdiff_t ld = padded_rows(m);
    memory.reserve(static_cast<std::size_t>(ld * m));
    Eigen::Map<Eigen::MatrixXd> M(memory.data(), ld, m);
    M.setZero();
    M.topRows(m) = B;
    done = kernels.invert(memory.data(), ld, m, smallest, exchanged.data());
    inverse = M.topRows(m);
    padding = M.bottomRows(ld - m).cwiseAbs().sum();
  }

  int m;
  AlignedBuffer<double> memory;
  std::vector<int> exchanged;
  bool done = false;
  Eigen::MatrixXd inverse;
  double padding = 0;
};

// Whole numbers, of which no operation rounds.
TEST_P(EveryInstructionSet, AddsAMultipleAndFindsTheLargestEntry) {
  Random random(7);
  std::uniform_int_distribution<int> number(-1000, 1000);
  for (const int m : {1, 2, 7, 8, 9, 33, 501}) {
    const int length = padded_rows(m);
    AlignedBuffer<double> v, w;
    v.reserve(static_cast<std::size_t>(length));
    w.reserve(static_cast<std::size_t>(length));
    Vector sum = Vector::Zero(length);
    for (int k = 0; k < length; ++k) {
      const auto i = static_cast<std::size_t>(k);
      v[i] = k < m ? number(random) : 0;
      w[i] = k < m ? number(random) : 0;
      sum[k] = v[i] - 3 * w[i];
    }
    const double largest = kernels().add_multiple(v.data(), w.data(), length, -3);
    EXPECT_EQ(Vector::Map(v.data(), length), sum);
    EXPECT_EQ(largest, sum.cwiseAbs().maxCoeff());
  }
}

TEST_P(EveryInstructionSet, InvertsWithExchangesOfRows) {
  Random random(12);
  for (const int m : {1, 2, 3, 7, 8, 9, 16, 17, 31, 50, 64, 101, 203}) {
    Eigen::MatrixXd B = gaussian_points(m, m, random);
    for (int k = 0; k < m && m > 1; k += 3) B(k, k) = 0;
    const Inverted inverted(kernels(), B, 1e-14);
    ASSERT_TRUE(inverted.done) << m;
    const Eigen::MatrixXd& R = inverted.inverse;
    const double scale = (R.cwiseAbs() * B.cwiseAbs()).maxCoeff();
    EXPECT_LT((R * B - Eigen::MatrixXd::Identity(m, m)).cwiseAbs().maxCoeff(), 1e-15 * m * scale) << m;
    EXPECT_EQ(inverted.padding, 0) << m;
  }
}

TEST_P(EveryInstructionSet, InvertsNoSingularMatrix) {
  Random random(13);
  for (const int m : {1, 2, 9, 40}) {
    Eigen::MatrixXd B = gaussian_points(m, m, random);
    B.col(m - 1) = m > 1 ? Vector(B.col(0)) : Vector(Vector::Zero(m));
    EXPECT_FALSE(Inverted(kernels(), B, 1e-13).done) << m;
  }
}

}  // namespace
}  // namespace raygauge::test_kernel
