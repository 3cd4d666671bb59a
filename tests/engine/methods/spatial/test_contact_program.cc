// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/contact_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/numerics/real.h"

namespace raygauge::test_contact_program {
namespace {

// The optimality conditions of the program, whose solution is unique.
template <class Real>
void expect_solution(const ContactPiece<Real>* pieces, int count, double error) {
  const ContactStep<Real> step = contact_step(pieces, count);
  ASSERT_GE(step.count, 1);
  Real sum{}, y[2] = {};
  for (int i = 0; i < step.count; ++i) {
    EXPECT_GE(rounded(step.weight[i]), -error);
    sum = sum + step.weight[i];
    for (int k = 0; k < 2; ++k) y[k] = y[k] - step.weight[i] * pieces[step.piece[i]].slope[k];
  }
  EXPECT_LE(std::fabs(rounded(sum - Real{1})), error);
  for (int k = 0; k < 2; ++k) EXPECT_LE(std::fabs(rounded(y[k] - step.y[k])), error);
  const auto after = [&](int i) {
    return pieces[i].height + pieces[i].slope[0] * step.y[0] + pieces[i].slope[1] * step.y[1];
  };
  for (int i = 1; i < step.count; ++i)
    EXPECT_LE(std::fabs(rounded(after(step.piece[i]) - after(step.piece[0]))), error);
  for (int i = 0; i < count; ++i) EXPECT_LE(rounded(after(i) - after(step.piece[0])), 1e-12);
}

TEST(ContactProgram, SatisfiesTheOptimalityConditions) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  int active[4] = {0, 0, 0, 0};
  for (int trial = 0; trial < 20000; ++trial) {
    const int count = 1 + trial % kMostContactPieces;
    const double near = std::pow(10.0, -(trial % 7));  // how much the heights differ
    ContactPiece<double> pieces[kMostContactPieces];
    ContactPiece<DoubleDouble> precise[kMostContactPieces];
    for (int i = 0; i < count; ++i) {
      pieces[i].height = near * normal(random);
      precise[i].height = {pieces[i].height, 0};
      for (int k = 0; k < 2; ++k) {
        pieces[i].slope[k] = normal(random);
        precise[i].slope[k] = {pieces[i].slope[k], 0};
      }
    }
    expect_solution(pieces, count, 1e-10);
    expect_solution(precise, count, 1e-25);
    ++active[contact_step(pieces, count).count];
  }
  EXPECT_GT(std::min({active[1], active[2], active[3]}), 500);
}

TEST(TangentMetric, StepsSolveTheSystemOfTheHessian) {
  const Vector3 u{0, 0, 1};
  const Matrix3 H{{{2, 0.5, 0}, {0.5, 3, 0}, {0, 0, 0}}};
  const TangentMetric metric(u, H, 0.25);
  const Vector3 g{0.3, -0.7, 0};
  double y[2], d[2];
  metric.image(dot(metric.tangent[0], g), dot(metric.tangent[1], g), y);
  metric.step(y, d);
  const Vector3 step = metric.tangent[0] * d[0] + metric.tangent[1] * d[1];
  EXPECT_LT(length(H * step + step * 0.25 - g), 1e-14);
}

}  // namespace
}  // namespace raygauge::test_contact_program
