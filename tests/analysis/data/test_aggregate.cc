// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/aggregate.h"

#include <gtest/gtest.h>

#include "raygauge/exceptions.h"
#include "tests/analysis/records.h"

namespace raygauge::test_aggregate {
namespace {

using testing::message_of;

double aggregate(const std::string& text, const std::vector<double>& values) {
  return aggregate_of(parse_aggregate(text), values);
}

TEST(Aggregate, ComputesEachKind) {
  const std::vector<double> values = {4, 1, 2, 8, 16};
  EXPECT_EQ(aggregate("median gap", values), 4);
  EXPECT_DOUBLE_EQ(aggregate("mean gap", values), 6.2);
  EXPECT_DOUBLE_EQ(aggregate("geomean gap", values), 4);
  EXPECT_NEAR(aggregate("sgm1 gap", {0, 8}), 2, 1e-14);
  EXPECT_EQ(aggregate("min gap", values), 1);
  EXPECT_EQ(aggregate("max gap", values), 16);
  EXPECT_EQ(aggregate("sum gap", values), 31);
  EXPECT_EQ(aggregate("q1 gap", values), 2);
  EXPECT_EQ(aggregate("q3 gap", values), 8);
  EXPECT_DOUBLE_EQ(aggregate("p90 gap", values), 12.8);
  EXPECT_DOUBLE_EQ(aggregate("p12.5 gap", values), 1.5);
}

TEST(Aggregate, ReadsBlanksAndAliases) {
  const Aggregate parsed = parse_aggregate("  median   ms ");
  EXPECT_EQ(parsed.name, "median");
  EXPECT_EQ(parsed.quantity, "milliseconds");
  EXPECT_TRUE(parse_aggregate("geomean ratio").is_ratio());
  EXPECT_TRUE(parse_aggregate("count").counts());
}

TEST(Aggregate, SaysWhatIsWrong) {
  EXPECT_EQ(message_of<InvalidParameterError>([] { parse_aggregate("median"); }),
            "value 'median' lacks a column, as in 'median milliseconds'");
  EXPECT_EQ(message_of<InvalidParameterError>([] { parse_aggregate("count n"); }),
            "value 'count n': count counts records; it takes no column");
  EXPECT_EQ(message_of<InvalidParameterError>([] { parse_aggregate("max method"); }),
            "value 'max method': column 'method' holds texts, not numbers");
  EXPECT_NE(message_of<UnknownNameError>([] { parse_aggregate("medain n"); }).find("did you mean 'median'?"),
            std::string::npos);
  EXPECT_NE(
      message_of<UnknownNameError>([] { parse_aggregate("median rato"); }).find("did you mean 'ratio'?"),
      std::string::npos);
  EXPECT_EQ(message_of<InvalidParameterError>([] { parse_aggregate("share gap"); }),
            "value 'share gap': a share is of a column of true and false, as in 'share solved'");
  EXPECT_THROW(parse_aggregate("p101 n"), UnknownNameError);
  EXPECT_THROW(parse_aggregate("sgm0 n"), UnknownNameError);
  EXPECT_THROW(parse_aggregate(""), UnknownNameError);
}

}  // namespace
}  // namespace raygauge::test_aggregate
