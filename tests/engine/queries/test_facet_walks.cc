// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/facet_walks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "raygauge/queries/membership.h"
#include "raygauge/queries/solver.h"
#include "tests/engine/instruction_sets.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_facet_walks {
namespace {

using Answers = std::vector<WalkAnswer>;

// The gauges at all columns of X, about `facets` facets that solves found, with normals.
Answers walk(const PointSet& S, const Eigen::MatrixXd& X, int facets, const Kernels& kernels, int threads = 1,
             std::vector<double>* normals = nullptr, double tolerance = 1e-6) {
  const int n = S.dimension();
  Vector axes(n);
  for (int k = 0; k < n; ++k)
    axes[k] = std::max(gauge(S, Vector::Unit(n, k)).upper, gauge(S, -Vector::Unit(n, k)).upper);
  FacetWalks walks(S, axes, tolerance, threads, kernels);
  EXPECT_TRUE(walks.usable());
  DistanceSolver solver{DistanceOptions{}};
  for (int i = 0; i < facets; ++i) walks.add_facet(-solver.solve(PointSet(X.col(i)), S).normal);
  std::vector<std::size_t> all(static_cast<std::size_t>(X.cols()));
  std::iota(all.begin(), all.end(), std::size_t{0});
  Answers answers(all.size());
  std::vector<double> unused(normals == nullptr ? 0 : all.size() * static_cast<std::size_t>(n));
  if (normals != nullptr) *normals = unused;
  walks.solve(X, all, {}, answers, normals == nullptr ? std::span<double>{} : std::span<double>(*normals));
  return answers;
}

double share_closed(const Answers& answers) {
  double closed = 0;
  for (const WalkAnswer& answer : answers) closed += answer.closed ? 1 : 0;
  return closed / static_cast<double>(answers.size());
}

class FacetWalksByKernels : public ::testing::TestWithParam<InstructionSet> {
 protected:
  const Kernels& kernels() const { return kernels_for(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(Machine, FacetWalksByKernels, ::testing::ValuesIn(instruction_sets_here()),
                         [](const auto& instance) { return std::string(to_string(instance.param)); });

// Quarters, so that neither sums nor the points are rounded.
Eigen::MatrixXd quarters(int n, int count, int most, Random& random) {
  return 0.25 * integer_points(n, count, most, random);
}

// Hulls with many points on each facet, and many in them: [-1, 1]^n has the gauge max |x_k|.
TEST_P(FacetWalksByKernels, BoundsTheGaugeOfACube) {
  Random random(41);
  for (const int n : {2, 3, 5, 6}) {
    Eigen::MatrixXd P(n, (1 << n) + 80 * n);
    P << cube_vertices(n), quarters(n, 80 * n, 4, random);
    const Eigen::MatrixXd X = gaussian_points(n, 2000, random);
    const Answers answers = walk(PointSet(P), X, 30, kernels());
    EXPECT_GE(share_closed(answers), 0.9) << "n = " << n;
    for (Eigen::Index i = 0; i < X.cols(); ++i) {
      const WalkAnswer& answer = answers[static_cast<std::size_t>(i)];
      if (!answer.closed) continue;
      const double truth = X.col(i).cwiseAbs().maxCoeff();
      ASSERT_LE(answer.lower, truth) << "n = " << n << ": " << X.col(i).transpose();
      ASSERT_GE(answer.upper, truth) << "n = " << n << ": " << X.col(i).transpose();
      ASSERT_LE(answer.upper - answer.lower, 1e-6 * truth);
    }
  }
}

// conv{±e_k} has the gauge Σ |x_k|, whatever both are scaled by.
TEST_P(FacetWalksByKernels, BoundsTheGaugeOfACrossPolytope) {
  Random random(42);
  for (const int n : {2, 4, 9, 16}) {
    for (const double scale : {1.0, 0x1p-300, 0x1p200}) {
      Eigen::MatrixXd P(n, 62 * n);
      P << 0.5 / n * quarters(n, 60 * n, 4, random), cross_polytope_vertices(n);
      const Eigen::MatrixXd X = quarters(n, 1000, 9, random);
      const Answers answers = walk(PointSet(scale * P), scale * X, 30, kernels());
      EXPECT_GE(share_closed(answers), 0.9) << "n = " << n << ", scale " << scale;
      for (Eigen::Index i = 0; i < X.cols(); ++i) {
        const WalkAnswer& answer = answers[static_cast<std::size_t>(i)];
        if (!answer.closed) continue;
        ASSERT_LE(answer.lower, X.col(i).cwiseAbs().sum()) << "n = " << n << ", scale " << scale;
        ASSERT_GE(answer.upper, X.col(i).cwiseAbs().sum()) << "n = " << n << ", scale " << scale;
      }
    }
  }
}

// Points of a sphere whose centre is not the origin: single solves agree, and each normal proves its bound.
TEST_P(FacetWalksByKernels, AgreesWithSingleSolvesAndProvesItsNormals) {
  Random random(43);
  for (const int n : {2, 3, 7, 10, 12}) {
    Eigen::MatrixXd P = sphere_points(n, 90 * n, random);
    P.colwise() += Vector::Constant(n, 0.3 / std::sqrt(n));
    const PointSet S(P);
    const Eigen::MatrixXd X = gaussian_points(n, 600, random);
    std::vector<double> normals;
    const Answers answers = walk(S, X, 20, kernels(), 1, &normals, 1e-9);
    EXPECT_GE(share_closed(answers), 0.9) << "n = " << n;
    for (Eigen::Index i = 0; i < X.cols(); ++i) {
      const WalkAnswer& answer = answers[static_cast<std::size_t>(i)];
      if (!answer.closed) continue;
      const GaugeBounds alone = gauge(S, X.col(i), 1e-9);
      ASSERT_LE(answer.lower, alone.upper);
      ASSERT_GE(answer.upper, alone.lower);
      const Vector w = -Vector::Map(normals.data() + i * n, n);
      ASSERT_LE((w.transpose() * P).maxCoeff(), 1 + 1e-12);
      ASSERT_NEAR(w.dot(X.col(i)), answer.lower, 1e-12 * answer.lower);
    }
  }
}

// Planes close to the origin: their normals are too long for integers, and single precision tells more.
TEST_P(FacetWalksByKernels, BoundsTheGaugeOfAFlatSet) {
  Random random(48);
  for (const int n : {2, 4, 7}) {
    Eigen::MatrixXd P = sphere_points(n, 90 * n, random);
    const Vector d = Vector::Constant(n, 1 / std::sqrt(n));
    P -= 0.9985 * d * (d.transpose() * P).eval();
    const PointSet S(P);
    const Eigen::MatrixXd X = gaussian_points(n, 600, random);
    const Answers answers = walk(S, X, 20, kernels());
    EXPECT_GE(share_closed(answers), 0.9) << "n = " << n;
    for (Eigen::Index i = 0; i < X.cols(); ++i) {
      const WalkAnswer& answer = answers[static_cast<std::size_t>(i)];
      if (!answer.closed) continue;
      const GaugeBounds alone = gauge(S, X.col(i), 1e-9);
      ASSERT_LE(answer.lower, alone.upper) << "n = " << n;
      ASSERT_GE(answer.upper, alone.lower) << "n = " << n;
    }
  }
}

TEST(FacetWalks, GiveTheSameOnAnyNumberOfThreads) {
  Random random(44);
  const PointSet S(sphere_points(6, 600, random));
  const Eigen::MatrixXd X = gaussian_points(6, 3000, random);
  std::vector<double> normals_1, normals_many;
  const Answers one = walk(S, X, 40, best_kernels(), 1, &normals_1);
  const Answers many = walk(S, X, 40, best_kernels(), 500, &normals_many);
  EXPECT_EQ(normals_1, normals_many);
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ(one[i].lower, many[i].lower);
    ASSERT_EQ(one[i].upper, many[i].upper);
    ASSERT_EQ(one[i].closed, many[i].closed);
  }
}

// What they cannot do is left open: the origin, lengths beyond single precision, a stop.
TEST(FacetWalks, LeaveOpenWhatTheyCannotProve) {
  Random random(45);
  const PointSet S(sphere_points(3, 300, random));
  Eigen::MatrixXd X = gaussian_points(3, 60, random);
  X.col(50).setZero();
  X.col(51) *= 1e200;
  X.col(52) *= 1e-200;
  const Answers answers = walk(S, X, 10, best_kernels());
  for (const std::size_t i : {50, 51, 52}) EXPECT_FALSE(answers[i].closed) << i;
  EXPECT_GE(share_closed(answers), 0.9);
}

TEST(FacetWalks, AreNotForEverySet) {
  Random random(46);
  const auto usable = [&](const Eigen::MatrixXd& P, double tolerance) {
    return FacetWalks(PointSet(P), Vector::Constant(P.rows(), 2), tolerance, 1).usable();
  };
  const Eigen::MatrixXd P = gaussian_points(4, 300, random);
  EXPECT_TRUE(usable(P, 1e-6));
  EXPECT_FALSE(usable(P, 1e-12));
  EXPECT_FALSE(usable(P.leftCols(200), 1e-6));
  EXPECT_FALSE(usable(gaussian_points(17, 1200, random), 1e-6));
  EXPECT_FALSE(usable(Vector{{1, 1, 1, 1e-5}}.asDiagonal() * P, 1e-6));
}

// gauges() of a set for which walks are made and of one for which they leave most points open, against
// closed forms.
TEST(Gauges, OfManyPointsAreBounded) {
  Random random(47);
  for (const int repeats : {1, 40}) {
    Eigen::MatrixXd P(5, 32 * repeats + 300);
    P << cube_vertices(5).replicate(1, repeats), quarters(5, 300, 3, random);
    const Eigen::MatrixXd X = gaussian_points(5, 6000, random);
    const std::vector<GaugeBounds> bounds = gauges(PointSet(P), X);
    for (Eigen::Index i = 0; i < X.cols(); ++i) {
      const GaugeBounds& b = bounds[static_cast<std::size_t>(i)];
      const double truth = X.col(i).cwiseAbs().maxCoeff();
      ASSERT_LE(b.lower, truth);
      ASSERT_GE(b.upper, truth);
      ASSERT_LE(b.upper - b.lower, 1e-6 * truth);
    }
  }
}

}  // namespace
}  // namespace raygauge::test_facet_walks
