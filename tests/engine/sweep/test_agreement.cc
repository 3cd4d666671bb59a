// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/agreement.h"

#include <gtest/gtest.h>

#include <limits>

namespace raygauge::test_agreement {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Record record(double lower, double distance, double upper, DistanceStatus status = DistanceStatus::optimal) {
  Record result;
  result.tolerance = 1e-6;
  result.lower = lower;
  result.distance = distance;
  result.upper = upper;
  result.status = status;
  result.exact_distance = kNaN;
  return result;
}

std::vector<bool> agreement(std::vector<Record> records) {
  mark_agreement(records);
  std::vector<bool> agrees;
  for (const Record& r : records) agrees.push_back(r.agrees);
  return agrees;
}

using Flags = std::vector<bool>;

TEST(Agreement, OverlappingProofsAgree) {
  EXPECT_EQ(agreement({record(2, 2.000001, 2.000001), record(2.0000005, 2.000001, 2.000002)}), Flags({1, 1}));
}

TEST(Agreement, ContradictingProofsDisagreeOnBothSides) {
  EXPECT_EQ(agreement({record(2, 2, 2.000001), record(2.1, 2.1, 2.1000001)}), Flags({0, 0}));
}

TEST(Agreement, OneContradictionSpoilsOnlyThoseWhoTakePart) {
  // The wide bounds of the third method meet both; its claim alone is judged.
  EXPECT_EQ(agreement({record(2, 2, 2.000001), record(2.1, 2.1, 2.1000001),
                       record(1, 2, 3, DistanceStatus::iteration_limit)}),
            Flags({0, 0, 1}));
}

TEST(Agreement, RoundingOfTheBoundsIsForgiven) {
  EXPECT_EQ(agreement({record(1, 1, 1), record(1 + 1e-15, 1 + 1e-15, 1 + 1e-15)}), Flags({1, 1}));
  EXPECT_EQ(agreement({record(1, 1, 1), record(1 + 1e-11, 1 + 1e-11, 1 + 1e-11)}), Flags({0, 0}));
}

TEST(Agreement, AKnownDistanceCountsWithItsRounding) {
  Record rounded = record(2.2360679, 2.2360680, 2.2360681);
  rounded.exact_distance = 2.236;
  EXPECT_EQ(agreement({rounded}), Flags({0}));
  rounded.exact_distance_rounding = 1e-4;
  EXPECT_EQ(agreement({rounded}), Flags({1}));
}

TEST(Agreement, ADistanceWithoutProofIsHeldAgainstTheBestProof) {
  EXPECT_EQ(agreement({record(2, 2, 2.000001), record(kNaN, 2.0000025, kNaN)}), Flags({1, 1}));
  EXPECT_EQ(agreement({record(2, 2, 2.000001), record(kNaN, 2.00001, kNaN)}), Flags({1, 0}));
  EXPECT_EQ(agreement({record(2, 2, 2.000001), record(kNaN, 1.99999, kNaN)}), Flags({1, 0}));
}

TEST(Agreement, AClaimedDistanceThatIsNotANumberDisagrees) {
  EXPECT_EQ(agreement({record(2, 2, 2.000001), record(kNaN, kNaN, kNaN)}), Flags({1, 0}));
}

TEST(Agreement, CrossedBoundsDisagreeEvenAlone) { EXPECT_EQ(agreement({record(2.1, 2.05, 2)}), Flags({0})); }

TEST(Agreement, ALimitWithValidBoundsIsNotADisagreement) {
  for (const DistanceStatus status :
       {DistanceStatus::iteration_limit, DistanceStatus::time_limit, DistanceStatus::precision_limit}) {
    EXPECT_EQ(agreement({record(2, 2, 2.000001), record(1, 5, 5, status)}), Flags({1, 1}));
    EXPECT_EQ(agreement({record(2, 2, 2.000001), record(kNaN, kNaN, kNaN, status)}), Flags({1, 1}));
    EXPECT_EQ(agreement({record(2, 2, 2.000001), record(3, 5, 5, status)}), Flags({0, 0}));
  }
}

TEST(Agreement, ZeroInfiniteAndFiniteDistancesExcludeEachOther) {
  const Record zero = record(0, 0, 0, DistanceStatus::contains_origin);
  const Record infinite = record(kInfinity, kInfinity, kInfinity, DistanceStatus::unreachable);
  EXPECT_EQ(agreement({zero, zero}), Flags({1, 1}));
  EXPECT_EQ(agreement({infinite, infinite}), Flags({1, 1}));
  EXPECT_EQ(agreement({infinite, record(2, 2, 2.000001)}), Flags({0, 0}));
  EXPECT_EQ(agreement({zero, record(1e-300, 1e-300, 1e-300)}), Flags({0, 0}));
  EXPECT_EQ(agreement({zero, infinite}), Flags({0, 0}));
  EXPECT_EQ(agreement({infinite, record(5, 5, kInfinity, DistanceStatus::time_limit)}), Flags({1, 1}));
}

TEST(Agreement, ADistanceOfZeroIsTheSameUnderEitherName) {
  EXPECT_EQ(agreement({record(0, 0, 0, DistanceStatus::contains_origin), record(0, 0, 0)}), Flags({1, 1}));
}

TEST(Agreement, AFalseClaimIsHeldAgainstItsMakerAloneWhereAnotherHasAProof) {
  const Record proven = record(2, 2, 2.000001);
  EXPECT_EQ(agreement({proven, record(kNaN, kInfinity, kNaN, DistanceStatus::unreachable)}), Flags({1, 0}));
  EXPECT_EQ(agreement({proven, record(kNaN, 0, kNaN, DistanceStatus::contains_origin)}), Flags({1, 0}));
  EXPECT_EQ(agreement({proven, record(1, 3, 4), record(1, 2, 4)}), Flags({1, 0, 1}));
}

TEST(Agreement, UnprovenClaimsThatContradictEachOtherBothDisagree) {
  const Record unreachable = record(kNaN, kInfinity, kNaN, DistanceStatus::unreachable);
  EXPECT_EQ(agreement({unreachable, record(1, 2, kInfinity)}), Flags({0, 0}));
  EXPECT_EQ(agreement({record(1, 2, 4), record(1, 2.5, 4)}), Flags({0, 0}));
  EXPECT_EQ(agreement({record(1, 2, 4), record(1, 2.000001, 4)}), Flags({1, 1}));
  EXPECT_EQ(agreement({record(1, 2, 4), record(kNaN, kNaN, kNaN)}), Flags({1, 0}));
}

TEST(Agreement, TheExactDistanceMustLieInsideEveryProof) {
  std::vector<Record> records = {record(2, 2, 2.000001), record(1.9, 2, 2.1, DistanceStatus::time_limit)};
  for (Record& r : records) r.exact_distance = 2.0000005;
  EXPECT_EQ(agreement(records), Flags({1, 1}));
  for (Record& r : records) r.exact_distance = 2.05;
  EXPECT_EQ(agreement(records), Flags({0, 1}));
  for (Record& r : records) r.exact_distance = kInfinity;
  EXPECT_EQ(agreement(records), Flags({0, 0}));
}

}  // namespace
}  // namespace raygauge::test_agreement
