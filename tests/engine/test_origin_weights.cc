// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A result `contains_origin` carries its proof: the points it names combine to the origin, exactly.
#include <gtest/gtest.h>

#include <optional>

#include "tests/engine/both_methods.h"
#include "tests/engine/point_clouds.h"
#include "tests/engine/rational.h"

namespace raygauge::test_origin_weights {
namespace {

using OriginWeights = BothMethods;
RAYGAUGE_BOTH_METHODS(OriginWeights);

// The solution of Σ α_i p_i = 0, Σ α_i = 1 by Gauss-Jordan in rational arithmetic; nothing unless it is
// unique.
std::optional<std::vector<Rational>> combination_to_origin(const Eigen::MatrixXd& points) {
  const auto rows = static_cast<std::size_t>(points.rows()) + 1,
             columns = static_cast<std::size_t>(points.cols());
  std::vector<std::vector<Rational>> system(rows, std::vector<Rational>(columns + 1));
  for (std::size_t k = 0; k < rows; ++k) {
    for (std::size_t i = 0; i < columns; ++i) {
      system[k][i] = k + 1 == rows ? 1.0 : points(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i));
    }
  }
  system[rows - 1][columns] = 1;
  for (std::size_t i = 0; i < columns; ++i) {
    std::size_t pivot = i;
    while (pivot < rows && system[pivot][i] == 0) ++pivot;
    if (pivot == rows) return std::nullopt;  // affinely dependent points
    std::swap(system[i], system[pivot]);
    for (std::size_t k = 0; k < rows; ++k) {
      if (k == i || system[k][i] == 0) continue;
      const Rational multiple = system[k][i] / system[i][i];
      for (std::size_t j = i; j <= columns; ++j) system[k][j] -= multiple * system[i][j];
    }
  }
  for (std::size_t k = columns; k < rows; ++k) {
    if (system[k][columns] != 0) return std::nullopt;  // the origin is not in their affine hull
  }
  std::vector<Rational> weights(columns);
  for (std::size_t i = 0; i < columns; ++i) weights[i] = system[i][columns] / system[i][i];
  return weights;
}

void expect_proof(const DistanceResult& result, const Eigen::MatrixXd& A) {
  ASSERT_EQ(result.status, DistanceStatus::contains_origin);
  const auto count = static_cast<Eigen::Index>(result.origin_weights.size());
  ASSERT_GE(count, 1);
  Eigen::MatrixXd chosen(A.rows(), count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const PointWeight& point = result.origin_weights[static_cast<std::size_t>(i)];
    ASSERT_LT(point.index, A.cols());
    chosen.col(i) = A.col(point.index);
  }
  const auto exact = combination_to_origin(chosen);
  ASSERT_TRUE(exact.has_value());
  for (std::size_t i = 0; i < exact->size(); ++i) {
    EXPECT_GE((*exact)[i], 0);
    EXPECT_NEAR((*exact)[i].convert_to<double>(), result.origin_weights[i].weight, 1e-12);
  }
}

TEST_P(OriginWeights, ProveTheOriginInTheInterior) {
  Random random(5);
  for (const int n : {1, 2, 3, 6}) {
    const Eigen::MatrixXd A = cube_vertices(n).colwise() + 0.25 * Vector::Ones(n);
    expect_proof(solve(A, cross_polytope_vertices(n), 1e-9), A);
  }
}

TEST_P(OriginWeights, ProveTheOriginOnAFaceAndAtAVertex) {
  for (const int n : {2, 3, 5}) {
    Eigen::MatrixXd face = cube_vertices(n);
    face.row(0).array() += 1;  // the origin is the centre of a facet
    expect_proof(solve(face, cube_vertices(n), 1e-9), face);
    const Eigen::MatrixXd corner = cube_vertices(n).array() + 1.0;
    expect_proof(solve(corner, cube_vertices(n), 1e-9), corner);
  }
}

TEST_P(OriginWeights, ProveTheOriginOnASegmentThroughIt) {
  Eigen::MatrixXd segment(3, 2);
  segment << 3, -1, 6, -2, -9, 3;
  expect_proof(solve(segment, cube_vertices(3), 1e-9), segment);
}

TEST_P(OriginWeights, AreEmptyWhereTheOriginIsOutside) {
  const Eigen::MatrixXd A = cube_vertices(3).array() + 3.0;
  EXPECT_TRUE(solve(A, cube_vertices(3), 1e-9).origin_weights.empty());
}

}  // namespace
}  // namespace raygauge::test_origin_weights
