// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/parameter_text.h"

#include <gtest/gtest.h>

#include "raygauge/sweep/registry.h"

namespace raygauge::test_parameter_text {
namespace {

using Split = std::vector<std::pair<std::string, std::string>>;

TEST(ParameterText, ComesBackWhateverTheTextsHold) {
  const Parameters parameters = {{"a", std::string("two words")},
                                 {"b", std::string("\"quoted\"\\ and\n\ttwo lines\r")},
                                 {"c", std::string()},
                                 {"d", std::string("x=1")},
                                 {"e", 0.5},
                                 {"f", true}};
  EXPECT_EQ(split_parameters(to_string(parameters)), (Split{{"a", "two words"},
                                                            {"b", "\"quoted\"\\ and\n\ttwo lines\r"},
                                                            {"c", ""},
                                                            {"d", "x=1"},
                                                            {"e", "0.5"},
                                                            {"f", "true"}}));
}

TEST(ParameterText, IsPlainWhereNothingNeedsQuotes) {
  EXPECT_EQ(to_string(Parameters{{"kind", std::string("plain")}, {"separation", 1.5}}),
            "kind=plain separation=1.5");
  EXPECT_EQ(to_string(Parameters{{"delta", 1e-8}, {"size", 1e5}}), "delta=1e-8 size=100000");
}

TEST(ParameterText, TakesWordsWithoutANameForPartsOfTheValueBefore) {
  EXPECT_EQ(split_parameters("program=./solve --fast now k=1"),
            (Split{{"program", "./solve --fast now"}, {"k", "1"}}));
}

TEST(ParameterText, TakesAnythingForSomething) {
  EXPECT_EQ(split_parameters(""), Split{});
  EXPECT_EQ(split_parameters("a=\"open"), (Split{{"a", "open"}}));
  EXPECT_EQ(split_parameters("a=\"x\\"), (Split{{"a", "x\\"}}));
  EXPECT_EQ(split_parameters("lonely"), Split{});
}

TEST(ParameterText, ComesBackAsTheTypesThatAreDeclared) {
  const std::vector<ParameterInfo> declared = {{"k", std::int64_t{1}, {}, {}, "", {}},
                                               {"on", false, {}, {}, "", {}},
                                               {"x", 0.0, {}, {}, "", {}},
                                               {"word", std::string(), {}, {}, "", {}}};
  const Parameters parameters = {
      {"k", std::int64_t{7}}, {"on", true}, {"x", 1e-100}, {"word", std::string("two \"words\"")}};
  EXPECT_EQ(parameters_from(to_string(parameters), declared), parameters);
  EXPECT_THROW(parameters_from("y=1", declared), UnknownNameError);
  EXPECT_THROW(parameters_from("k=1.5", declared), InvalidParameterError);
}

}  // namespace
}  // namespace raygauge::test_parameter_text
