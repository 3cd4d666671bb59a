// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/cluster_tree.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <string>

#include "raygauge/queries/solver.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/prepared_set.h"

namespace raygauge::test_cluster_tree {
namespace {

using Random = std::mt19937_64;
using Matrix = Eigen::MatrixXd;

Matrix gaussian(int n, int N, Random& random) {
  std::normal_distribution<double> normal;
  Matrix points(n, N);
  for (double& x : points.reshaped()) x = normal(random);
  return points;
}

Matrix rotation(int n, Random& random) {
  return Eigen::HouseholderQR<Matrix>(gaussian(n, n, random)).householderQ();
}

struct Cloud {
  std::string name;
  Matrix points;
};

Matrix lattice(int n, int side, int N) {
  Matrix points(n, N);
  for (int i = 0; i < N; ++i) {
    for (int k = 0, rest = i; k < n; ++k, rest /= side) points(k, i) = rest % side;
  }
  return points;
}

// Ties, duplicates, flat sets, needles, clusters, sets far away, large and tiny ones; 16384 numbers or more.
std::vector<Cloud> clouds(int n, Random& random) {
  const int N = 16384 / n + 25;
  const Matrix sphere = gaussian(n, N, random).colwise().normalized();
  Vector thin = Vector::Ones(n), flat = Vector::Ones(n);
  thin.tail(n - 1).setConstant(1e-6);
  flat.tail(n / 2).setZero();
  const Matrix turn = rotation(n, random);
  std::vector<Cloud> out{{"sphere", sphere}, {"interior points", gaussian(n, N, random)}};
  out.push_back({"lattice", lattice(n, 4, N)});
  out.push_back({"one point", sphere.col(0).replicate(1, N)});
  Matrix twice(n, 2 * N);
  twice << sphere, sphere;
  out.push_back({"duplicates", twice});
  out.push_back({"needle", turn * thin.asDiagonal() * sphere});
  out.push_back({"disc", turn * thin.cwiseInverse().asDiagonal() * sphere});
  out.push_back({"flat", turn * flat.asDiagonal() * sphere});
  out.push_back({"clusters", sphere.leftCols(20).replicate(1, N / 20) + 1e-3 * sphere.leftCols(N / 20 * 20)});
  out.push_back({"far away", sphere.array() + 1e7});
  out.push_back({"large", 1e50 * sphere});
  out.push_back({"tiny", 1e-50 * sphere});
  return out;
}

// Also those that the axes of a needle or a disc make hard, and those at the ends of the range of doubles.
std::vector<Vector> directions(const Matrix& points, Random& random) {
  const auto n = static_cast<int>(points.rows());
  std::vector<Vector> out{Vector::Zero(n), Vector::Unit(n, 0), -Vector::Unit(n, n - 1), Vector::Ones(n)};
  const Vector u = gaussian(n, 1, random).col(0);
  for (const double scale : {1e-300, 1e-160, 1e160, 1e290}) out.emplace_back(scale * u);
  for (int i = 0; i < 20; ++i) {
    const Vector v = gaussian(n, 1, random).col(0);
    const Vector along = points.col(i) - points.col(points.cols() - 1 - i);
    out.push_back(v);
    out.emplace_back(v - v.dot(along) / std::max(along.squaredNorm(), 1e-300) * along);
  }
  return out;
}

// Where u·p overflows to infinity less infinity there is no maximum.
bool has_heights(const Matrix& points, const Vector& u) {
  return std::isfinite(points.cwiseAbs().rowwise().maxCoeff().dot(u.cwiseAbs()));
}

// A tree and its points in its order.
struct Ordered {
  explicit Ordered(const Matrix& cloud) : tree(cloud, order) {
    points = order.empty() ? cloud : Matrix(cloud(Eigen::all, order));
  }

  ClusterTree::Order order;
  ClusterTree tree;
  Matrix points;
};

TEST(ClusterTree, HasTheHighestPointOfAPassBitByBit) {
  Random random(21);
  for (const int n : {2, 3, 5, 9, 32}) {
    for (const Cloud& cloud : clouds(n, random)) {
      const Ordered ordered(cloud.points);
      const ClusterTree& tree = ordered.tree;
      ASSERT_FALSE(tree.empty()) << cloud.name;
      const PointSet S(ordered.points);
      for (const Vector& u : directions(cloud.points, random)) {
        if (!has_heights(cloud.points, u)) continue;
        std::ptrdiff_t index = 0;
        const double value = best_kernels().price(S.data(), S.block_count(), n, u.data(), &index);
        const Highest found = tree.highest(best_kernels(), S.data(), u.data());
        EXPECT_EQ(found.value, value) << cloud.name << ", n = " << n << ", u = " << u.transpose();
        EXPECT_EQ(found.index, index) << cloud.name << ", n = " << n << ", u = " << u.transpose();
      }
    }
  }
}

TEST(ClusterTree, CollectsThePointsThatAPassCollects) {
  Random random(22);
  for (const int n : {2, 4, 9}) {
    for (const Cloud& cloud : clouds(n, random)) {
      const Ordered ordered(cloud.points);
      const ClusterTree& tree = ordered.tree;
      const PointSet S(ordered.points);
      for (const Vector& u : directions(cloud.points, random)) {
        if (!has_heights(cloud.points, u)) continue;
        Vector heights = ordered.points.transpose() * u;
        std::nth_element(heights.begin(), heights.end() - 40, heights.end());
        const auto room = static_cast<std::size_t>(S.block_count() * PointSet::kLanes);
        std::vector<std::int64_t> index(2 * room);
        std::vector<double> value(2 * room);
        const auto capacity = static_cast<std::ptrdiff_t>(room);
        const double threshold = heights[heights.size() - 40];
        Collection passed{index.data(), value.data(), capacity, 0, threshold};
        Collection found{index.data() + room, value.data() + room, capacity, 0, threshold};
        const double highest = best_kernels().collect(S.data(), 0, S.block_count(), n, u.data(), &passed);
        EXPECT_EQ(tree.collect(best_kernels(), S.data(), u.data(), found), highest) << cloud.name;
        const std::set<std::int64_t> of_pass(passed.index, passed.index + passed.count);
        const std::set<std::int64_t> of_tree(found.index, found.index + found.count);
        EXPECT_EQ(of_tree, of_pass) << cloud.name << ", n = " << n << ", u = " << u.transpose();
      }
    }
  }
}

TEST(ClusterTree, KeepsEveryPointOnce) {
  Random random(23);
  ClusterTree::Order order = Ordered(gaussian(4, 5003, random)).order;
  std::sort(order.begin(), order.end());
  ASSERT_EQ(order.size(), 5003U);
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], static_cast<std::ptrdiff_t>(i));
}

TEST(ClusterTree, ComparesFewPointsOfManyInFewDimensions) {
  Random random(24);
  for (const int n : {2, 4}) {
    const Matrix points = gaussian(n, 40000, random).colwise().normalized();
    const Ordered ordered(points);
    const ClusterTree& tree = ordered.tree;
    const PointSet S(ordered.points);
    EXPECT_TRUE(tree.pays(S.data()));
    for (const Vector& u : directions(points, random)) {
      if (!(u.norm() > 1e-100 && u.norm() < 1e100)) continue;
      EXPECT_LT(tree.highest(best_kernels(), S.data(), u.data()).compared, 4000) << n;
    }
  }
  const Ordered round(gaussian(20, 2000, random));
  EXPECT_FALSE(round.tree.pays(PointSet(round.points).data()));
}

TEST(ClusterTree, IsEmptyWhereAPassIsAsFast) {
  Random random(25);
  EXPECT_TRUE(Ordered(gaussian(2, 100, random)).tree.empty());
  EXPECT_TRUE(Ordered(gaussian(33, 1000, random)).tree.empty());
  EXPECT_TRUE(Ordered(Matrix::Zero(2, 20000)).tree.empty());
  EXPECT_TRUE(Ordered(1e200 * gaussian(2, 20000, random)).tree.empty());
}

// Certified bounds of one and the same distance meet.
TEST(PreparedSet, OfManyPointsHasTheDistancesOfPlainOnes) {
  Random random(26);
  for (const int n : {2, 3, 4, 6}) {
    Matrix A = gaussian(n, 20000, random);
    const Matrix Q = gaussian(n, 30000, random).colwise().normalized();
    A.row(0).array() += 12;
    const PointSet plain_A(A), plain_Q(Q);
    const PreparedSet prepared_A(A), prepared_Q(Q);
    if (n != 3) {
      EXPECT_NE(prepared_A.points().tree(), nullptr) << n;
    }
    for (const auto method :
         {DistanceMethod::column_generation, DistanceMethod::zheng_yamane, DistanceMethod::newton}) {
      DistanceOptions options;
      options.method = method;
      DistanceSolver one(options), two(options);
      const DistanceResult& plain = one.solve(plain_A, plain_Q);
      const DistanceResult& prepared = two.solve(prepared_A, prepared_Q);
      EXPECT_EQ(plain.status, DistanceStatus::optimal);
      EXPECT_EQ(prepared.status, DistanceStatus::optimal);
      EXPECT_LE(plain.lower, prepared.upper);
      EXPECT_LE(prepared.lower, plain.upper);
    }
  }
}

}  // namespace
}  // namespace raygauge::test_cluster_tree
