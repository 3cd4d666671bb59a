// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sweep/registry.h"

#include <gtest/gtest.h>

namespace raygauge::test_registry {
namespace {

const std::vector<ParameterInfo> kDeclared = {
    {"separation", 1.5, 1.0, 100.0, "centre distance / sum of radii", {}},
    {"kind", std::string("plain"), {}, {}, "which", {"plain", "sheared"}},
};

TEST(Parameters, MissingOnesTakeTheirDefaults) {
  EXPECT_EQ(to_string(complete("generator 'g'", kDeclared, {})), "kind=plain separation=1.5");
}

TEST(Parameters, AnIntegerIsAcceptedForAReal) {
  EXPECT_EQ(real_parameter(complete("g", kDeclared, {{"separation", std::int64_t{50}}}), "separation"), 50.0);
}

TEST(Parameters, AnUnknownNameSuggestsTheNearest) {
  try {
    complete("generator 'g'", kDeclared, {{"seperation", 2.0}});
    FAIL() << "accepted an unknown parameter";
  } catch (const UnknownNameError& error) {
    EXPECT_STREQ(
        error.what(),
        "generator 'g': unknown parameter 'seperation'; did you mean 'separation'? (known: separation kind)");
  }
}

TEST(Parameters, AnyOtherIsCarriedAlongWhereThatIsDeclared) {
  std::vector<ParameterInfo> declared = kDeclared;
  declared.push_back({kAnyParameter, std::string(), {}, {}, "columns", {}});
  EXPECT_EQ(to_string(complete("g", declared, {{"family", std::string("thin")}})),
            "family=thin kind=plain separation=1.5");
}

TEST(Parameters, WrongTypeAndRangeAreNamed) {
  EXPECT_THROW(complete("g", kDeclared, {{"separation", std::string("far")}}), InvalidParameterError);
  EXPECT_THROW(complete("g", kDeclared, {{"separation", 0.5}}), InvalidParameterError);
  EXPECT_THROW(complete("g", kDeclared, {{"kind", std::string("bent")}}), UnknownNameError);
}

}  // namespace
}  // namespace raygauge::test_registry
