// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What every convex set must satisfy, held to points and to membership tests that know nothing of its support
// function.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "tests/engine/sets/set_cases.h"

namespace raygauge::test_set_properties {
namespace {

// Values are sums of a few dozen rounded terms of size |u|₁ · 10 at most.
constexpr double kTolerance = 1e-13;
constexpr double kSize = 10;

double tolerance(const Vector& u) { return kTolerance * kSize * u.lpNorm<1>(); }

// Directions with zeros, ties and components of very different size.
Vector any_direction(int n) {
  const auto component =
      rc::gen::pair(rc::gen::inRange(-8, 9), rc::gen::element(1.0, 1.0, 0.3, 1e-8, 1e-200));
  const auto components =
      *rc::gen::container<std::vector<std::pair<int, double>>>(static_cast<std::size_t>(n), component);
  Vector u(n);
  for (int k = 0; k < n; ++k) {
    const auto& [factor, size] = components[static_cast<std::size_t>(k)];
    u[k] = factor * size;
  }
  return u;
}

class EverySet : public testing::TestWithParam<SetCase> {
 protected:
  const ConvexSet& set() const { return *GetParam().set; }
  int n() const { return set().dimension(); }
};

TEST_P(EverySet, LiesBehindItsSupportPlanes) {
  Random random(11);
  for (int i = 0; i < 200; ++i) {
    const Vector x = GetParam().sample(random);
    ASSERT_LE(GetParam().excess(x), 1e-9) << "the sample is not in the set";
    for (int j = 0; j < 20; ++j) {
      const Vector u = gaussian_points(n(), 1, random);
      EXPECT_LE(u.dot(x), set().support_function(u) + tolerance(u));
    }
  }
}

TEST_P(EverySet, AttainsItsSupportFunctionAtAPointOfItsOwn) {
  EXPECT_TRUE(rc::check([this] {
    const Vector u = any_direction(n());
    const Vector x = set().support_mapping(u);
    RC_ASSERT(std::fabs(u.dot(x) - set().support_function(u)) <= tolerance(u));
    RC_ASSERT(GetParam().excess(x) <= 1e-12);
  }));
}

TEST_P(EverySet, HasAHomogeneousSupportFunction) {
  EXPECT_TRUE(rc::check([this] {
    const Vector u = any_direction(n());
    const int exponent = *rc::gen::inRange(-300, 1000);
    const double once = set().support_function(u);
    const double scaled = set().support_function(std::ldexp(1.0, exponent) * u);
    RC_ASSERT(std::fabs(std::ldexp(scaled, -exponent) - once) <= tolerance(u));
  }));
}

TEST_P(EverySet, AttainsTheSupportFunctionOfTinyDirections) {
  Random random(12);
  for (int i = 0; i < 20; ++i) {
    const Vector u = gaussian_points(n(), 1, random);
    const Vector x = set().support_mapping(0x1p-1000 * u);
    EXPECT_NEAR(u.dot(x), set().support_function(u), tolerance(u));
    EXPECT_LE(GetParam().excess(x), 1e-12);
  }
}

TEST_P(EverySet, HasASubadditiveSupportFunction) {
  EXPECT_TRUE(rc::check([this] {
    const Vector u = any_direction(n()), v = any_direction(n());
    const double sum = set().support_function(u) + set().support_function(v);
    RC_ASSERT(set().support_function(u + v) <= sum + tolerance(u) + tolerance(v));
  }));
}

TEST_P(EverySet, HoldsItsCenter) { EXPECT_LE(GetParam().excess(set().center()), 1e-13); }

TEST_P(EverySet, AnswersTheZeroDirectionWithAPointOfItsOwn) {
  EXPECT_EQ(set().support_function(Vector::Zero(n())), 0);
  EXPECT_LE(GetParam().excess(set().support_mapping(Vector::Zero(n()))), 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Sets, EverySet, testing::ValuesIn(set_cases()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace raygauge::test_set_properties
