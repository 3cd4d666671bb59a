// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/numerics/number_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "raygauge/sweep/registry.h"

namespace raygauge::test_number_text {
namespace {

TEST(NumberText, IsAsShortAsItsDigitsAllow) {
  EXPECT_EQ(rounded_text(0.25, 6), "0.25");
  EXPECT_EQ(rounded_text(1e-6, 6), "1e-6");
  EXPECT_EQ(rounded_text(1.5e-10, 6), "1.5e-10");
  EXPECT_EQ(rounded_text(1e20, 6), "1e20");
  EXPECT_EQ(rounded_text(2.0 / 3, 3), "0.667");
}

TEST(NumberText, HasAnExponentBelowAHundredth) {
  EXPECT_EQ(rounded_text(0.01, 6), "0.01");
  EXPECT_EQ(rounded_text(0.001, 6), "1e-3");
  EXPECT_EQ(rounded_text(-0.0012, 6), "-1.2e-3");
  EXPECT_EQ(rounded_text(0.009996, 3), "0.01");
  EXPECT_EQ(rounded_text(0.00995, 1), "0.01");
  EXPECT_EQ(rounded_text(0, 6), "0");
}

TEST(NumberText, IsTheSameWithAllDigitsAsWithSix) {
  for (const double value : {1e-300, 1e-8, 2.5e-5, 1e-4, 1e-3, 5e-3, 0.01, 0.1, 1.5, 100.0, 1e5, 1e6, 1e20})
    EXPECT_EQ(shortest_text(value), rounded_text(value, 6));
  EXPECT_EQ(shortest_text(-std::numeric_limits<double>::infinity()), "-inf");
  EXPECT_EQ(shortest_text(std::nan("")), "nan");
}

TEST(NumberText, SurvivesARoundTrip) {
  for (const double value : {0.1, 1.0 / 3, 1e-3 / 3, 1e-300, 5e-324, 123456789.123456789, 1.2e5, 1.7e308})
    EXPECT_EQ(std::strtod(shortest_text(value).c_str(), nullptr), value);
}

TEST(CurrentNumbers, AreThoseOfEarlierVersionsWrittenAsToday) {
  EXPECT_EQ(with_current_numbers("delta=1e-08 k=3 lambda=0.001 size=1e+05 x=1.5"),
            "delta=1e-8 k=3 lambda=1e-3 size=100000 x=1.5");
  EXPECT_EQ(with_current_numbers("seed = 1\ntolerance = [1e-06, 0.001]\nmin_seconds = 2e-05\n"
                                 "generators = [hard {delta=1e-08}, hard {pose={rpy=[0,0,0.001]}}]\n"),
            "seed = 1\ntolerance = [1e-6, 1e-3]\nmin_seconds = 2e-5\n"
            "generators = [hard {delta=1e-8}, hard {pose={rpy=[0,0,1e-3]}}]\n");
}

TEST(CurrentNumbers, LeaveTextsAndIntegersAlone) {
  for (const char* text : {"", "=", "a=", "kind=plain", "name=\"1e-08\" k=1", "file=finger-1e-05.off",
                           "program=./solve 1e-08", "seed = 1152921504606846976", "n = [100000]", "on=true",
                           "label as 1e-08", "a=1e-8 b=5e-3", "a=\"x\\"})
    EXPECT_EQ(with_current_numbers(text), text);
}

TEST(CurrentNumbers, AreWhatParametersAreWrittenWith) {
  const Parameters parameters = {{"delta", 1e-8}, {"name", std::string("1e-08")}, {"size", 1e5}};
  const std::string text = to_string(parameters);
  EXPECT_EQ(text, "delta=1e-8 name=\"1e-08\" size=100000");
  EXPECT_EQ(with_current_numbers(text), text);
}

}  // namespace
}  // namespace raygauge::test_number_text
