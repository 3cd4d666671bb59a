// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/object_pair.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::test_object_pair {
namespace {

constexpr int n = 3;

Ellipsoid ellipsoid(double x) {
  return {Vector{{x, 1, -2}}, Eigen::Matrix3d(Eigen::Vector3d(1, 2, 3).asDiagonal())};
}

Vector random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Vector{{normal(random), normal(random), normal(random)}}.normalized();
}

template <class Real>
struct Pieces {
  std::array<Real, std::size_t{SupportPieces::kCapacity} * n> points{};
  std::array<Real, std::size_t{SupportPieces::kCapacity} * n * n> hessians{};
  BasicSupportPieces<Real> list;
  Pieces() {
    list.dimension = n;
    list.points = points.data();
    list.hessians = hessians.data();
  }
};

TEST(ObjectPair, NotesNothingWhenItIsAsked) {
  const Ellipsoid A2 = ellipsoid(5), A1 = ellipsoid(0);
  const ObjectPair pair(A2, A1, true);
  SupportPairs pairs;
  pairs.begin(pair);
  const Vector difference = pair.support_mapping(Vector{{1, 2, 3}});
  EXPECT_EQ(pairs.partner(difference.data()), nullptr);
}

TEST(SupportPairs, AnswerAsThePairAndNoteThePointOfA1) {
  std::mt19937 random(1);
  const Eigen::MatrixXd points = Eigen::MatrixXd::Random(n, 20);
  const PointSet A2(points.array() + 4), A1(points.reverse());
  const ObjectPair pair(A2, A1, true);
  SupportPairs pairs;
  pairs.begin(pair);
  std::vector<Vector> directions, differences;
  for (int i = 0; i < 30; ++i) {
    directions.push_back(random_direction(random));
    Vector difference(n);
    const double value = pairs.support(directions.back().data(), difference.data());
    EXPECT_EQ(value, pair.support_function(directions.back()));
    EXPECT_EQ(difference, pair.support_mapping(directions.back()));
    differences.push_back(difference);
  }
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Vector a1 = A1.support_mapping(-directions[i]);
    EXPECT_EQ(Vector::Map(pairs.partner(differences[i].data()), n), a1);
  }
}

template <class Real>
void expect_pieces_of_the_pair(double tolerance) {
  const Ellipsoid A2 = ellipsoid(5), A1 = ellipsoid(0);
  const ObjectPair pair(A2, A1, true);
  SupportPairs pairs;
  pairs.begin(pair);
  const std::array<Real, n> u = {Real{0.6}, Real{0}, Real{-0.8}};
  Pieces<Real> of_pair, through;
  pair.smooth()->pieces(u.data(), of_pair.list);
  pairs.pieces(u.data(), through.list);
  ASSERT_EQ(through.list.count, 1);
  ASSERT_EQ(of_pair.list.count, 1);
  EXPECT_TRUE(through.list.value[0] == of_pair.list.value[0]);
  EXPECT_TRUE(through.points == of_pair.points);
  EXPECT_TRUE(through.hessians == of_pair.hessians);
  Vector difference(n);
  for (int k = 0; k < n; ++k)
    difference[k] = static_cast<double>(through.points[static_cast<std::size_t>(k)]);
  const double* a1 = pairs.partner(difference.data());
  ASSERT_NE(a1, nullptr);
  EXPECT_LE((Vector::Map(a1, n) - A1.support_mapping(Vector{{-0.6, 0, 0.8}})).norm(), tolerance);
}

TEST(SupportPairs, HavePiecesInBothPrecisions) {
  expect_pieces_of_the_pair<double>(1e-15);
  expect_pieces_of_the_pair<Quad>(1e-14);
}

TEST(SupportPairs, NoteThePointOfA1OfAFacePoint) {
  const Cylinder A2(Vector{{0, 0, 5}}, Vector{{0, 0, 7}}, 1.0);
  const Ellipsoid A1 = ellipsoid(0);
  const ObjectPair pair(A2, A1, true);
  SupportPairs pairs;
  pairs.begin(pair);
  const std::array<double, n> down = {0, 0, -1};
  const std::array<double, n> target = {0.3, -0.9, 4};
  std::array<double, n> of_pair{}, through{};
  pair.flat_faces()->point(down.data(), target.data(), of_pair.data());
  pairs.facet_point(down.data(), target.data(), through.data());
  EXPECT_EQ(through, of_pair);
  const double* a1 = pairs.partner(through.data());
  ASSERT_NE(a1, nullptr);
  EXPECT_EQ(Vector::Map(a1, n), A1.support_mapping(Vector{{0, 0, 1}}));
  EXPECT_NEAR(through[2] + a1[2], 5, 1e-14);  // on the lower face of A2
}

}  // namespace
}  // namespace raygauge::test_object_pair
