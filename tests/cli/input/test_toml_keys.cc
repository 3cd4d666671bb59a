// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/toml_keys.h"

#include <gtest/gtest.h>

#include "cli/input/toml_source.h"
#include "raygauge/exceptions.h"
#include "tests/results/support.h"

namespace raygauge::cli::test_toml_keys {
namespace {

/// a.a.a…, of so many parts.
std::string key_of(std::size_t parts) {
  std::string key = "a";
  for (std::size_t i = 1; i < parts; ++i) key += ".a";
  return key;
}

const std::string kLongest = key_of(kMostKeyParts), kTooLong = key_of(kMostKeyParts + 1);

TEST(TomlKeys, MayHaveSoManyParts) {
  for (const std::string& text :
       {"x = 1\n" + kLongest + " = 1", "[" + kLongest + "]", "x = {" + kLongest + " = 1}"})
    EXPECT_EQ(line_of_endless_key(text), 0U) << text;
}

TEST(TomlKeys, OfMorePartsAreFoundWithTheirLine) {
  EXPECT_EQ(line_of_endless_key(kTooLong), 1U);
  EXPECT_EQ(line_of_endless_key("x = 1\n\n[" + kTooLong + "]\n"), 3U);
  EXPECT_EQ(line_of_endless_key("x = [1,\n {" + kTooLong + " = 1}]"), 2U);
  EXPECT_EQ(line_of_endless_key("x = '''\n\n'''\n\"a\" . 'b'." + kLongest), 4U);
  EXPECT_EQ(line_of_endless_key("x = 'never ends\n" + kTooLong), 2U);
}

TEST(TomlKeys, DotsInStringsAndCommentsDoNotCount) {
  for (const std::string& text :
       {"# " + kTooLong + "\n", "x = \"" + kTooLong + "\"", "x = '" + kTooLong + "'",
        "x = \"\"\"\n\"" + kTooLong + "\n\"\"\"", R"(x = "\")" + kTooLong + "\"",
        "x = '\\'\ny = '" + kTooLong + "'", std::string(100, '#') + kTooLong})
    EXPECT_EQ(line_of_endless_key(text), 0U) << text;
}

TEST(TomlKeys, NumbersAreNoKeys) {
  std::string list = "x = [0.5";
  for (std::size_t i = 0; i < 2 * kMostKeyParts; ++i) list += ", 0.5";
  EXPECT_EQ(line_of_endless_key(list + "]"), 0U);
}

// It ended in a stack overflow.
TEST(TomlKeys, OfAHundredThousandPartsAreRefused) {
  const testing::TemporaryFolder folder;
  testing::write_bytes(folder.file("x.toml"), "y = 1\n" + key_of(100'000) + " = 1\n");
  const std::string complaint = testing::error_of([&] { read_toml(folder.file("x.toml"), {}); });
  EXPECT_EQ(complaint, folder.file("x.toml") + ":2: a key of more than 32 parts");
  testing::write_bytes(folder.file("x.toml"), "y = 1\n");
  for (const std::string& text : {key_of(100'000) + "=1", "y={" + key_of(1000) + "=1}"}) {
    const std::string refusal = testing::error_of([&] { read_toml(folder.file("x.toml"), {text}); });
    EXPECT_TRUE(refusal.ends_with(": a key of more than 32 parts")) << refusal.substr(0, 100);
  }
}

// The deepest document that passes: values may be nested 256 times by toml++'s own limit.
TEST(TomlKeys, WithinBothLimitsAreRead) {
  const testing::TemporaryFolder folder;
  std::string text = "x = ", end;
  for (int i = 0; i < 200; ++i) {
    text += "{" + kLongest + " = ";
    end += "}";
  }
  testing::write_bytes(folder.file("x.toml"), text + "1" + end);
  EXPECT_EQ(testing::error_of([&] { read_toml(folder.file("x.toml"), {}); }), "");
}

}  // namespace
}  // namespace raygauge::cli::test_toml_keys
