// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/column_pool.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "tests/engine/point_clouds.h"

namespace raygauge::test_column_pool {
namespace {

std::vector<double> point_at(const ColumnPool& pool, std::ptrdiff_t i, int n) {
  std::vector<double> point(static_cast<std::size_t>(n));
  pool.copy_point(i, point.data());
  return point;
}

PointSet random_set(int n, int N, unsigned seed) {
  Random random(seed);
  return PointSet(gaussian_points(n, N, random));
}

// Of S as it is.
ColumnPool chosen(const PointSet& S) {
  const Vector ones = Vector::Ones(S.dimension());
  ColumnPool pool;
  pool.choose(S, ones.data(), true, false);
  return pool;
}

TEST(ColumnPool, TakesAllOfASmallSet) {
  const PointSet S = random_set(3, 20, 1);
  const ColumnPool pool = chosen(S);
  EXPECT_TRUE(pool.is_complete());
  EXPECT_EQ(pool.size(), 20);
  for (std::int64_t i = 0; i < 20; ++i) EXPECT_TRUE(pool.holds(i));
}

TEST(ColumnPool, TakesASampleOfALargeSetAlwaysTheSame) {
  const int n = 3;
  for (const int N : {1001, 1008, 5000}) {  // with a last block that is full, and with one that is not
    const PointSet S = random_set(n, N, 2);
    const Vector factor = Vector::Constant(n, 0.25);
    ColumnPool pool, again;
    pool.choose(S, factor.data(), false, false);
    again.choose(S, factor.data(), false, false);
    ASSERT_FALSE(pool.is_complete());
    ASSERT_EQ(pool.size(), again.size());
    std::set<std::int64_t> indices;
    for (std::ptrdiff_t i = 0; i < pool.size(); ++i) {
      EXPECT_EQ(point_at(pool, i, n), point_at(again, i, n));
      const std::int64_t index = pool.index_in(S, factor.data(), i);
      ASSERT_GE(index, 0);
      ASSERT_LT(index, N);
      EXPECT_TRUE(pool.holds(index));
      for (int k = 0; k < n; ++k)
        EXPECT_EQ(point_at(pool, i, n)[static_cast<std::size_t>(k)], 0.25 * S.point(index)[k]);
      indices.insert(index);
    }
    int held = 0;
    for (std::int64_t i = 0; i < N; ++i) held += pool.holds(i) ? 1 : 0;
    EXPECT_EQ(held, static_cast<int>(indices.size())) << "what is marked is what is there, N = " << N;
  }
}

TEST(ColumnPool, AddsAPointOnce) {
  const PointSet S = random_set(4, 3000, 3);
  ColumnPool pool = chosen(S);
  const Vector ones = Vector::Ones(4);
  std::int64_t absent = 0;
  while (pool.holds(absent)) ++absent;
  const std::ptrdiff_t size = pool.size();
  EXPECT_TRUE(pool.add(S, ones.data(), absent));
  EXPECT_FALSE(pool.add(S, ones.data(), absent));
  EXPECT_TRUE(pool.holds(absent));
  ASSERT_EQ(pool.size(), size + 1);
  EXPECT_EQ(pool.index_in(S, ones.data(), size), absent);
}

// A lane that no point fills must not win with a point that its index does not name.
TEST(ColumnPool, RepeatsItsLastPointInTheLanesBeyond) {
  const int n = 4;
  const PointSet S = random_set(n, 4000, 5);
  const Vector factor = Vector::Constant(n, 0.5);
  ColumnPool pool;
  pool.choose(S, factor.data(), false, false);
  ASSERT_FALSE(pool.is_complete());
  for (std::int64_t index = 0; pool.size() % 8 != 3; ++index) pool.add(S, factor.data(), index);
  pool.fill_up();
  for (std::ptrdiff_t lane = pool.size(); lane < pool.view().block_count * 8; ++lane) {
    EXPECT_EQ(point_at(pool, lane, n), point_at(pool, pool.size() - 1, n));
  }
  pool.clear(n);
  for (int i = 0; i < 11; ++i) {
    pool.add(S.point(i).data());
    for (std::ptrdiff_t lane = i; lane < pool.view().block_count * 8; ++lane) {
      EXPECT_EQ(point_at(pool, lane, n), point_at(pool, i, n));
    }
  }
}

TEST(ColumnPool, KeepsPointsOfNoSet) {
  ColumnPool pool;
  pool.clear(2);
  for (const double x : {1.0, -7.0, 3.0}) {
    const double point[2] = {x, 2 * x};
    pool.add(point);
  }
  EXPECT_EQ(pool.size(), 3);
  EXPECT_EQ(point_at(pool, 1, 2), (std::vector<double>{-7, -14}));
  EXPECT_EQ(pool.magnitude(), 14);
  pool.clear(2);
  EXPECT_EQ(pool.size(), 0);
}

}  // namespace
}  // namespace raygauge::test_column_pool
