// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "raygauge/exceptions.h"
#include "tests/analysis/records.h"

namespace raygauge::test_filter {
namespace {

using testing::message_of;
using testing::record;

bool passes(const std::string& expression, const Record& record) { return Filter(expression)(record); }

Record sample() {
  Record r = record("column_generation", 5, 200, 3, 2);
  r.seed = std::numeric_limits<std::uint64_t>::max();
  return r;
}

TEST(Filter, ComparesNumbers) {
  const Record r = sample();
  EXPECT_TRUE(passes("n==5", r));
  EXPECT_TRUE(passes("n!=4", r));
  EXPECT_TRUE(passes("n<6", r));
  EXPECT_FALSE(passes("n<5", r));
  EXPECT_TRUE(passes("n<=5", r));
  EXPECT_FALSE(passes("n>5", r));
  EXPECT_TRUE(passes("n >= 5", r));
  EXPECT_TRUE(passes("tolerance==1e-6", r));
  EXPECT_TRUE(passes("ms > 1.5", r));
  EXPECT_TRUE(passes("distance<inf", r));
  EXPECT_TRUE(passes("distance > -1", r));
}

TEST(Filter, ComparesIntegersOf64BitsExactly) {
  EXPECT_TRUE(passes("seed==18446744073709551615", sample()));
  EXPECT_FALSE(passes("seed==18446744073709551614", sample()));
}

TEST(Filter, ComparesTextsBareAndQuoted) {
  const Record r = sample();
  EXPECT_TRUE(passes("method==column_generation", r));
  EXPECT_TRUE(passes("method=='column_generation'", r));
  EXPECT_TRUE(passes("method==\"column_generation\"", r));
  EXPECT_FALSE(passes("method!=column_generation", r));
  EXPECT_TRUE(passes("generator_parameters=='separation=1.5'", r));
  EXPECT_TRUE(passes("status==optimal", r));
  EXPECT_FALSE(passes("method==n", r))
      << "after a text, a bare word is a text even if a column has that name";
}

TEST(Filter, BindsAndBeforeOrAndNotFirst) {
  const Record r = sample();
  EXPECT_TRUE(passes("n==5 || n==4 && N==1", r));
  EXPECT_FALSE(passes("(n==5 || n==4) && N==1", r));
  EXPECT_TRUE(passes("!n==4 && N==200", r));
  EXPECT_FALSE(passes("!(n==4 || N==200)", r));
  EXPECT_TRUE(passes("!!(n==5)", r));
}

TEST(Filter, TakesTruthsAloneAndCompared) {
  Record r = sample();
  EXPECT_TRUE(passes("agrees", r));
  EXPECT_TRUE(passes("agrees==true && solved!=false", r));
  r.agrees = false;
  EXPECT_TRUE(passes("!agrees", r));
}

TEST(Filter, ComparesColumnsWithEachOther) {
  Record r = sample();
  EXPECT_TRUE(passes("error <= gap", r));
  r.distance = 3;
  EXPECT_TRUE(passes("error > gap", r));
}

TEST(Filter, HasNaNComparingAsIEEE754Does) {
  Record r = sample();
  r.lower = std::nan("");
  EXPECT_FALSE(passes("gap<=1", r));
  EXPECT_FALSE(passes("gap>1", r));
  EXPECT_TRUE(passes("gap!=1", r));
}

TEST(Filter, PassesEverythingByDefaultAndKeepsTheOrder) {
  const std::vector<Record> records = {record("a", 3, 1, 0, 1), record("b", 4, 1, 0, 1),
                                       record("c", 5, 1, 0, 1)};
  EXPECT_EQ(filtered(records, Filter()).size(), 3U);
  const std::vector<Record> kept = filtered(records, Filter("n!=4"));
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(kept[0].method, "a");
  EXPECT_EQ(kept[1].method, "c");
}

TEST(Filter, RefusesEndlessNestingAndTakesEndlessChains) {
  constexpr int kMany = 100'000;
  EXPECT_THROW(Filter(std::string(kMany, '!') + "agrees"), InvalidParameterError);
  EXPECT_THROW(Filter(std::string(kMany, '(')), InvalidParameterError);
  std::string disjunction = "agrees", conjunction = "agrees";
  for (int i = 0; i < kMany; ++i) {
    disjunction += "||agrees";
    conjunction += "&&agrees";
  }
  EXPECT_TRUE(Filter(disjunction)(Record()));
  EXPECT_TRUE(Filter(conjunction)(Record()));
}

TEST(Filter, ListsTheKnownColumnsForAnUnknownOne) {
  const std::string message =
      message_of<UnknownNameError>([] { filtered({Record()}, Filter("n==3 && metod==column_generation")); });
  EXPECT_EQ(message.rfind("filter 'n==3 && metod==column_generation', character 9: unknown column 'metod'; "
                          "did you mean 'method'?",
                          0),
            0U)
      << message;
  EXPECT_NE(message.find("(known: cell session generator"), std::string::npos) << message;
}

struct Mistake {
  const char* expression;
  const char* complaint;
};

class FilterMistakes : public ::testing::TestWithParam<Mistake> {};

TEST_P(FilterMistakes, AreNamedWithTheirPlace) {
  const Mistake mistake = GetParam();
  EXPECT_EQ(message_of<InvalidParameterError>([&] { Filter{mistake.expression}; }),
            "filter '" + std::string(mistake.expression) + "', " + mistake.complaint);
}

INSTANTIATE_TEST_SUITE_P(
    Syntax, FilterMistakes,
    ::testing::Values(Mistake{"n=3", "character 2: unexpected '='; did you mean '=='?"},
                      Mistake{"n==3 & N==4", "character 6: unexpected '&'; did you mean '&&'?"},
                      Mistake{"n==3 ; N==4", "character 6: unexpected ';'"},
                      Mistake{"n==", "character 4: expected a value after =="},
                      Mistake{"n==3 &&", "character 8: expected a column, found the end"},
                      Mistake{"", "character 1: expected a column, found the end"},
                      Mistake{"(n==3", "character 1: the parenthesis that opens here is never closed"},
                      Mistake{"n==3)", "character 5: expected && or ||, found ')'"},
                      Mistake{"method=='column_generation",
                              "character 9: the quote that opens here is never closed"},
                      Mistake{"n", "character 1: 'n' is not a truth; compare it, as in n == VALUE"},
                      Mistake{"n==three", "character 4: 'n' is a number, 'three' is not"},
                      Mistake{"n=='3'", "character 4: 'n' is a number, '3' is not"},
                      Mistake{"agrees==maybe", "character 9: 'agrees' is a truth, 'maybe' is not"},
                      Mistake{"n==method", "character 4: 'n' is a number, 'method' is not"}));

}  // namespace
}  // namespace raygauge::test_filter
