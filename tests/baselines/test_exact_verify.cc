// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/exact_verify.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "raygauge/exceptions.h"
#include "tests/baselines/closed_forms.h"

namespace raygauge::testing::test_exact_verify {
namespace {

struct Proof {
  Instance sets;
  const PointSet& A = dynamic_cast<const PointSet&>(*sets.A);
  const PointSet& Q = dynamic_cast<const PointSet&>(*sets.Q);
  ExactLpResult result = solve_exact_lp(A, Q);
};

/// Whether the proof still stands after `tamper`.
bool stands_after(const Proof& proof, const std::function<void(ExactLpResult&)>& tamper) {
  ExactLpResult changed = proof.result;
  tamper(changed);
  return verify(proof.A, proof.Q, changed);
}

const Rational kTiny = Rational(1) / (Integer(1) << 200U);

TEST(ExactVerify, AcceptsAnUntouchedProof) {
  const Proof proof{two_spheres(1, 4, 50)};
  EXPECT_TRUE(stands_after(proof, [](ExactLpResult&) {}));
}

TEST(ExactVerify, RejectsAnotherValueByTheLeastBit) {
  const Proof proof{two_spheres(1, 4, 50)};
  EXPECT_FALSE(stands_after(proof, [](ExactLpResult& r) { r.value += kTiny; }));
  EXPECT_FALSE(stands_after(proof, [](ExactLpResult& r) { r.t -= kTiny; }));
  EXPECT_FALSE(stands_after(proof, [](ExactLpResult& r) {
    r.value -= kTiny;
    r.t -= kTiny;
  }));
}

TEST(ExactVerify, RejectsAnInfeasiblePrimal) {
  const Proof proof{two_spheres(1, 4, 50)};
  EXPECT_FALSE(stands_after(proof, [](ExactLpResult& r) { r.alpha[0].weight += kTiny; }));
  EXPECT_FALSE(stands_after(proof, [](ExactLpResult& r) { r.beta[0].weight += kTiny; }));
  EXPECT_FALSE(stands_after(proof, [](ExactLpResult& r) { r.alpha[0].index ^= 1; }));
  EXPECT_FALSE(stands_after(proof, [](ExactLpResult& r) { r.alpha[0].index = 50; }));
  EXPECT_FALSE(stands_after(proof, [](ExactLpResult& r) { r.beta[0].index = -1; }));
  EXPECT_FALSE(stands_after(proof, [](ExactLpResult& r) { r.beta.pop_back(); }));
}

TEST(ExactVerify, RejectsNegativeWeightsThatSumUp) {
  const Proof proof{two_spheres(1, 4, 50)};
  EXPECT_FALSE(stands_after(proof, [](ExactLpResult& r) {
    const std::ptrdiff_t index = r.alpha[0].index;
    r.alpha[0].weight += 1;
    r.alpha.push_back({index, Rational(-1)});
  }));
}

TEST(ExactVerify, RejectsAnInfeasibleDual) {
  const Proof proof{two_spheres(1, 4, 50)};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_FALSE(stands_after(proof, [k](ExactLpResult& r) { r.u[k] += kTiny; })) << k;
    EXPECT_FALSE(stands_after(proof, [k](ExactLpResult& r) { r.u[k] = -r.u[k]; })) << k;
  }
  EXPECT_FALSE(stands_after(proof, [](ExactLpResult& r) { r.u.pop_back(); }));
}

TEST(ExactVerify, RejectsWrongRounding) {
  const Proof proof{two_spheres(1, 4, 50)};
  const auto up = [](double x) { return std::nextafter(x, kInf); };
  EXPECT_FALSE(stands_after(proof, [&](ExactLpResult& r) { r.rounded.lower = up(r.rounded.lower); }));
  EXPECT_FALSE(stands_after(proof, [&](ExactLpResult& r) { r.rounded.upper = up(r.rounded.upper); }));
  EXPECT_FALSE(stands_after(proof, [&](ExactLpResult& r) { r.rounded.nearest = up(r.rounded.upper); }));
}

TEST(ExactVerify, RejectsAnotherStatus) {
  const Proof finite{two_spheres(1, 4, 50)};
  const Proof zero{instance(cube(Vector::Zero(3)), cube(Vector::Zero(3)))};
  EXPECT_TRUE(stands_after(zero, [](ExactLpResult&) {}));
  for (const auto status : {DistanceStatus::unreachable, DistanceStatus::time_limit,
                            DistanceStatus::precision_limit, DistanceStatus::contains_origin}) {
    EXPECT_FALSE(stands_after(finite, [status](ExactLpResult& r) { r.status = status; }));
  }
  EXPECT_FALSE(stands_after(zero, [](ExactLpResult& r) { r.status = DistanceStatus::optimal; }));
}

TEST(ExactVerify, RejectsAFalseFarkasDirection) {
  const Proof proof{instance(points({{-1, 0.5}}), points({{0, 1}, {0, -1}, {2, 0}}))};
  EXPECT_TRUE(stands_after(proof, [](ExactLpResult&) {}));
  EXPECT_FALSE(stands_after(proof, [](ExactLpResult& r) { r.t = 0; }));
  EXPECT_FALSE(stands_after(proof, [](ExactLpResult& r) { r.u[0] = -r.u[0]; }));
  EXPECT_FALSE(stands_after(proof, [](ExactLpResult& r) { r.u[1] += kTiny; }));
  EXPECT_FALSE(stands_after(proof, [](ExactLpResult& r) { r.rounded.lower = 0; }));
}

TEST(ExactVerify, RefusesSetsOfDifferentDimension) {
  EXPECT_THROW(verify(PointSet(points({{1, 2}})), PointSet(points({{1}})), {}), DimensionMismatchError);
}

}  // namespace
}  // namespace raygauge::testing::test_exact_verify
