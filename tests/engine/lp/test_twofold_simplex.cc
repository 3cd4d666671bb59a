// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/twofold_simplex.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "engine/lp/exact_simplex.h"
#include "engine/proof/certificate.h"
#include "tests/engine/instruction_sets.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_twofold_simplex {
namespace {

using End = TwofoldSimplex::End;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

class TwofoldSimplexOnEveryKernel : public ::testing::TestWithParam<InstructionSet> {
 protected:
  const Kernels& kernels() const { return kernels_for(GetParam()); }

  End solve(const PointSet& A, const PointSet& Q, const std::vector<std::int64_t>& start = {}) {
    const std::vector<double> ones(static_cast<std::size_t>(A.dimension()), 1.0);
    return program_.solve({&A, ones.data()}, {&Q, ones.data()}, start, 0, kernels(), Stopwatch());
  }

  // What the duals prove.
  double lower(const PointSet& A, const PointSet& Q) const {
    const int n = A.dimension();
    const Vector u = Eigen::Map<const Eigen::VectorXd>(program_.normal(), n);
    const Vector u_low = Eigen::Map<const Eigen::VectorXd>(program_.normal_low(), n);
    const Vector v = -u, v_low = -u_low;
    return lower_bound(support_value_twofold(kernels(), A, u.data(), u_low.data()),
                       support_value_twofold(kernels(), Q, v.data(), v_low.data()));
  }

  TwofoldSimplex program_;
};

INSTANTIATE_TEST_SUITE_P(Machine, TwofoldSimplexOnEveryKernel, ::testing::ValuesIn(instruction_sets_here()),
                         [](const auto& instance) { return std::string(to_string(instance.param)); });

// Both stretched along one direction, by 2^bits: the condition of a basis.
void stretch(Eigen::MatrixXd& a, Eigen::MatrixXd& q, int bits, Random& random) {
  const Vector w = sphere_points(static_cast<int>(a.rows()), 1, random);
  for (Eigen::MatrixXd* points : {&a, &q})
    *points += std::ldexp(1.0, bits) * w * (w.transpose() * *points).eval();
}

TEST_P(TwofoldSimplexOnEveryKernel, AgreesWithTheExactSimplexWhereDoublesFail) {
  Random random(61);
  for (const int n : {2, 3, 8, 12}) {
    for (const int bits : {0, 30, 50}) {
      Eigen::MatrixXd a = sphere_points(n, 5 * n, random);
      Eigen::MatrixXd q = sphere_points(n, 5 * n, random);
      a.colwise() += 3 * sphere_points(n, 1, random).col(0);
      stretch(a, q, bits, random);
      const PointSet A(a), Q(q);
      ExactSimplex exact;
      ASSERT_EQ(exact.solve({&A, {}}, {&Q, {}}, {}, Stopwatch()), ExactSimplex::End::solved);
      ASSERT_EQ(solve(A, Q), End::solved) << "n = " << n << ", bits = " << bits;
      const double d = exact.distance().nearest;
      const double upper = program_.basis().upper(Stopwatch());
      EXPECT_GE(upper, exact.distance().below) << "n = " << n << ", bits = " << bits;
      EXPECT_LE(upper, d * (1 + 1e-13)) << "n = " << n << ", bits = " << bits;
      EXPECT_LE(lower(A, Q), exact.distance().above) << "n = " << n << ", bits = " << bits;
      EXPECT_GE(lower(A, Q), d * (1 - 1e-13)) << "n = " << n << ", bits = " << bits;
    }
  }
}

// Thousands of ties: the optimum has n - 1 weights that are exactly zero.
TEST_P(TwofoldSimplexOnEveryKernel, ProvesDegenerateOptimaExactly) {
  for (const int n : {2, 3, 6}) {
    Eigen::MatrixXd a = lattice_points(n, 2).array() + 3;
    const PointSet A(a), Q(cube_vertices(n));
    ASSERT_EQ(solve(A, Q), End::solved) << "n = " << n;
    EXPECT_NEAR(program_.basis().upper(Stopwatch()), 3, 1e-14) << "n = " << n;
    EXPECT_GE(program_.basis().upper(Stopwatch()), 3) << "n = " << n;
  }
}

TEST_P(TwofoldSimplexOnEveryKernel, FindsTheOriginInAFaceOfA) {
  Eigen::MatrixXd a(3, 4);
  a << 1, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
  const PointSet A(a), Q(cross_polytope_vertices(3));
  ASSERT_EQ(solve(A, Q), End::solved);
  EXPECT_EQ(program_.basis().upper(Stopwatch()), 0);
  std::vector<PointWeight> weights;
  program_.basis().weights_of_A(weights);
  ASSERT_EQ(weights.size(), 2U);
  for (const PointWeight& point : weights) EXPECT_NEAR(point.weight, 0.5, 1e-15);
}

TEST_P(TwofoldSimplexOnEveryKernel, FindsADirectionWithAMarginWhereNothingIsReached) {
  Random random(62);
  for (const int n : {2, 5, 12}) {
    Eigen::MatrixXd q = sphere_points(n, 3 * n, random);
    Eigen::MatrixXd a = sphere_points(n, 3 * n, random);
    q.row(0) = q.row(0).cwiseAbs().array() + 0x1p-50;  // 0 outside Q, by very little
    a.row(0) = -a.row(0).cwiseAbs().array() - 1;
    const PointSet A(a), Q(q);
    ASSERT_EQ(solve(A, Q), End::unreachable) << "n = " << n;
    EXPECT_EQ(lower(A, Q), kInfinite) << "n = " << n;
  }
}

// Small integers, stretched or not: ties, duplicates, flat sets, the origin in A, on faces, outside Q.
TEST_P(TwofoldSimplexOnEveryKernel, NeverContradictsTheExactSimplex) {
  Random random(64);
  int solved = 0, unreachable = 0, undecided = 0;
  for (int instance = 0; instance < 2000; ++instance) {
    const int n = 1 + instance % 6;
    const int N = 1 + static_cast<int>(random() % (3 * static_cast<unsigned>(n) + 3));
    Eigen::MatrixXd a = integer_points(n, N, 1 + instance % 3, random);
    Eigen::MatrixXd q = integer_points(n, N + n, 2, random);
    if (instance % 4 == 0) a.row(0).array() += 4;
    if (instance % 5 == 0) stretch(a, q, 40, random);
    const PointSet A(a), Q(q);
    ExactSimplex exact;
    const ExactSimplex::End truth = exact.solve({&A, {}}, {&Q, {}}, {}, Stopwatch());
    const End end = solve(A, Q);
    const double below = end == End::failed ? 0 : lower(A, Q);
    if (truth == ExactSimplex::End::unreachable) {
      EXPECT_NE(end, End::solved) << "instance " << instance;
      (end == End::unreachable && below == kInfinite ? unreachable : undecided) += 1;
      continue;
    }
    ASSERT_EQ(truth, ExactSimplex::End::solved);
    EXPECT_LE(below, exact.distance().above) << "instance " << instance;
    if (end != End::solved) {
      ++undecided;
      continue;
    }
    const double above = program_.basis().upper(Stopwatch());
    EXPECT_GE(above, exact.distance().below) << "instance " << instance;
    EXPECT_EQ(above == 0, exact.distance().above == 0) << "instance " << instance;
    (above < kInfinite ? solved : undecided) += 1;
  }
  EXPECT_GT(solved, 1000);
  EXPECT_GT(unreachable, 100);
  EXPECT_LT(undecided, 200);
}

TEST_P(TwofoldSimplexOnEveryKernel, StopsWithTheStopwatch) {
  Random random(63);
  const PointSet A(sphere_points(5, 20, random)), Q(sphere_points(5, 20, random));
  const std::vector<double> ones(5, 1.0);
  Stopwatch late;
  late.start(0);
  EXPECT_EQ(program_.solve({&A, ones.data()}, {&Q, ones.data()}, {}, 0, kernels(), late), End::stopped);
}

}  // namespace
}  // namespace raygauge::test_twofold_simplex
