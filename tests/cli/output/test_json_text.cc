// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/output/json_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace raygauge::cli::test_json_text {
namespace {

TEST(JsonText, RealNumbersHaveSeventeenSignificantDigits) {
  EXPECT_EQ(json_text(Json(0.1)), "0.10000000000000001");
  EXPECT_EQ(json_text(Json(2.0 / 3.0)), "0.66666666666666663");
  EXPECT_EQ(json_text(Json(1e-140)), "9.9999999999999998e-141");
}

TEST(JsonText, InfinityIsAStringAndNanIsNull) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(json_text(Json(infinity)), "\"inf\"");
  EXPECT_EQ(json_text(Json(-infinity)), "\"-inf\"");
  EXPECT_EQ(json_text(Json(std::nan(""))), "null");
}

TEST(JsonText, MembersKeepTheirOrder) {
  EXPECT_EQ(json_text({{"z", 1}, {"a", {1.5, 2.5}}, {"m", "text"}, {"b", true}}),
            R"({"z": 1, "a": [1.5, 2.5], "m": "text", "b": true})");
}

TEST(JsonText, EmptyObjectsAndArraysKeepTheirKind) {
  EXPECT_EQ(json_text({{"object", Json::object()}, {"array", Json::array()}}),
            R"({"object": {}, "array": []})");
}

TEST(JsonText, StringsAreEscapedAndBrokenUtf8IsReplaced) {
  EXPECT_EQ(json_text(Json("a\"b\n")), R"("a\"b\n")");
  EXPECT_EQ(json_text(Json("\xFF")), "\"\xEF\xBF\xBD\"");
}

}  // namespace
}  // namespace raygauge::cli::test_json_text
