// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/point_file.h"

#include <gtest/gtest.h>

#include <string>

#include "raygauge/exceptions.h"
#include "tests/results/support.h"

namespace raygauge::cli::test_point_file {
namespace {

Eigen::MatrixXd matrix(std::initializer_list<std::initializer_list<double>> rows) {
  return Eigen::MatrixXd(rows);
}

/// The two points (1, 2) and (3, 4), one a column.
Eigen::MatrixXd two_points() { return matrix({{1, 3}, {2, 4}}); }

template <class Exception>
std::string message_of(const std::string& text) {
  try {
    parse_points(text, "A.csv");
  } catch (const Exception& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(PointFile, EverySeparatorWorks) {
  for (const char* text : {"1,2\n3,4\n", "1 2\n3 4\n", "1\t2\n3\t4\n", "1;2\n3;4\n", "1 , 2\n3 ;\t4\n"}) {
    EXPECT_EQ(parse_points(text, "x"), two_points()) << text;
  }
}

TEST(PointFile, LineEndsOfEverySystemWork) {
  for (const char* text : {"1,2\n3,4", "1,2\r\n3,4\r\n", "1,2\r3,4\r"}) {
    EXPECT_EQ(parse_points(text, "x"), two_points()) << text;
  }
}

TEST(PointFile, CommentsBlankLinesAndAByteOrderMarkAreIgnored) {
  EXPECT_EQ(parse_points("\xEF\xBB\xBF# x, y\n\n  1 2 # first\n \t\n3 4#second\n", "x"), two_points());
}

TEST(PointFile, NumbersAreReadToTheLastBit) {
  EXPECT_EQ(parse_points("0.1 -2.5e-3 +7 .5 1E2", "x"), matrix({{0.1}, {-2.5e-3}, {7}, {0.5}, {100}}));
  EXPECT_EQ(parse_points("1.7976931348623157e308 4.9406564584124654e-324", "x"),
            matrix({{1.7976931348623157e308}, {4.9406564584124654e-324}}));
}

TEST(PointFile, UnderflowIsZero) { EXPECT_EQ(parse_points("1e-999 -1e-400", "x"), matrix({{0}, {0}})); }

TEST(PointFile, RaggedLinesAreNamedWithTheFirstLine) {
  EXPECT_EQ(message_of<InvalidParameterError>("# head\n1 2 3\n\n4 5\n"),
            "A.csv: line 4 has 2 coordinates, line 2 has 3");
}

TEST(PointFile, WhatIsNoNumberIsNamedWithLineAndColumn) {
  EXPECT_EQ(message_of<InvalidParameterError>("1 2\n3 four\n"), "A.csv:2:3: 'four' is not a number");
  EXPECT_EQ(message_of<InvalidParameterError>("1 2\n3 4m\n"), "A.csv:2:3: '4m' is not a number");
  EXPECT_EQ(message_of<InvalidParameterError>("x,y\n1,2\n"),
            "A.csv:1:1: 'x' is not a number (a heading must start with '#')");
  EXPECT_EQ(message_of<InvalidParameterError>("1 +-2\n"), "A.csv:1:3: '+-2' is not a number");
}

TEST(PointFile, TheHintNamesWhatSkipsAHeadingWhereTheTextComesFrom) {
  try {
    parse_points("x,y\n1,2\n", "A.csv", {.header_option = "--skip-header"});
    FAIL() << "took a heading for a point";
  } catch (const InvalidParameterError& error) {
    EXPECT_STREQ(error.what(),
                 "A.csv:1:1: 'x' is not a number (a heading must start with '#'; --skip-header skips one)");
  }
}

TEST(PointFile, DecimalCommasAreRefusedWithAHint) {
  EXPECT_EQ(
      message_of<InvalidParameterError>("2,5;0,5\n"),
      "A.csv: line 1 has commas beside semicolons: are they decimal commas? Write 2.5, not 2,5, or separate "
      "by commas alone");
  EXPECT_EQ(
      message_of<InvalidParameterError>("1 2\n2,5\t0,5\n"),
      "A.csv: line 2 has commas beside blanks: are they decimal commas? Write 2.5, not 2,5, or separate by "
      "commas alone");
}

TEST(PointFile, AHeadingIsSkippedOnRequest) {
  EXPECT_EQ(parse_points("# data\n\nx, y\n1 2\n3 4\n", "x", {.skip_header = true}), two_points());
  EXPECT_EQ(parse_points("1 2\n3 4\n", "x", {.skip_header = true}), two_points()) << "no point is dropped";
  EXPECT_THROW(parse_points("x y\n", "x", {.skip_header = true}), EmptySetError);
}

TEST(PointFile, BlocksMayCutLinesAnywhere) {
  const testing::TemporaryFolder folder;
  std::string text;
  for (int i = 0; i < 200000; ++i) text += std::to_string(i) + ",0.125\r\n";
  testing::write_bytes(folder.file("long.csv"), text);
  const Eigen::MatrixXd points = read_point_file(folder.file("long.csv"));
  ASSERT_EQ(points.cols(), 200000);
  for (int i = 0; i < 200000; ++i) ASSERT_EQ(points(0, i), i);
}

TEST(PointFile, AMissingCoordinateIsNotReadAsZero) {
  EXPECT_EQ(message_of<InvalidParameterError>("1,,2\n"),
            "A.csv:1:3: a coordinate is missing before this separator");
  EXPECT_EQ(message_of<InvalidParameterError>(",1\n"),
            "A.csv:1:1: a coordinate is missing before this separator");
  EXPECT_EQ(message_of<InvalidParameterError>("1,\n"),
            "A.csv:1:3: a coordinate is missing after the last separator");
}

TEST(PointFile, NumbersThatAreNotFiniteAreNamed) {
  EXPECT_EQ(message_of<NonFiniteError>("1 2\n3 nan\n"), "A.csv:2:3: 'nan' is not a finite number");
  EXPECT_EQ(message_of<NonFiniteError>("1,-inf\n"), "A.csv:1:3: '-inf' is not a finite number");
  EXPECT_EQ(message_of<NonFiniteError>("1e999 0\n"), "A.csv:1:1: '1e999' is too large for double precision");
}

TEST(PointFile, NoPointsAtAllIsAnError) {
  for (const char* text : {"", "\n\n", "# only a comment\n", "\xEF\xBB\xBF"}) {
    EXPECT_EQ(message_of<EmptySetError>(text),
              "A.csv: no points (the file is empty, or holds comments only)");
  }
}

TEST(PointFile, BinaryDataIsCalledByItsName) {
  EXPECT_EQ(message_of<InvalidParameterError>(std::string("1 2\0\n", 5)),
            "A.csv: not a text file in UTF-8 or ASCII (it holds zero bytes)");
}

TEST(PointFile, ControlCharactersDoNotReachTheMessage) {
  EXPECT_EQ(message_of<InvalidParameterError>("1 \033[31m\n"), "A.csv:1:3: '?[31m' is not a number");
}

TEST(PointFile, AFileThatCannotBeReadIsNamedWithTheReason) {
  EXPECT_THROW(read_point_file("/nowhere/A.csv"), InvalidParameterError);
  try {
    read_point_file(::testing::TempDir());
    FAIL() << "read a folder";
  } catch (const InvalidParameterError& error) {
    EXPECT_EQ(std::string(error.what()), ::testing::TempDir() + ": Is a directory");
  }
}

}  // namespace
}  // namespace raygauge::cli::test_point_file
