// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/journal/csv.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "results/exceptions.h"
#include "results/schema/schema.h"
#include "tests/results/support.h"

namespace raygauge::test_csv {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the helpers of this room's tests

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

std::size_t position_of(const std::string& column) {
  for (std::size_t i = 0; i < record_columns().size(); ++i) {
    if (record_columns()[i].name == column) return i;
  }
  throw std::out_of_range(column);
}

class Csv : public ::testing::Test {
 protected:
  /// The fields of a single record, whose texts need no quotes.
  static std::vector<std::string> fields_of(const Record& record) {
    return split(split(csv_text({record}), '\n').at(1), ',');
  }
};

TEST_F(Csv, TheHeaderNamesTheColumnsOfTheFile) {
  std::string expected;
  for (const auto& column : record_columns()) expected += (expected.empty() ? "" : ",") + column.name;
  EXPECT_EQ(csv_text({}), expected + "\n");
}

TEST_F(Csv, EveryDoubleSurvives) {
  Record record;
  for (const double value : {0.1, 1.0 / 3.0, -0.0, 5e-324, 1.7976931348623157e308, 123456789012345678.0}) {
    record.distance = value;
    const std::string field = fields_of(record).at(position_of("distance"));
    EXPECT_EQ(std::bit_cast<std::uint64_t>(std::strtod(field.c_str(), nullptr)),
              std::bit_cast<std::uint64_t>(value))
        << field;
  }
}

TEST_F(Csv, NumbersHaveNoMoreDigitsThanTheyNeed) {
  Record record;
  record.distance = 0.1;
  EXPECT_EQ(fields_of(record).at(position_of("distance")), "0.1");
  record.distance = 1e-8;
  EXPECT_EQ(fields_of(record).at(position_of("distance")), "1e-8");
}

TEST_F(Csv, WhatIsNotFiniteIsSpelledOut) {
  Record record;
  record.distance = std::numeric_limits<double>::infinity();
  record.lower = -record.distance;
  record.upper = -std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::string> fields = fields_of(record);
  EXPECT_EQ(fields.at(position_of("distance")), "inf");
  EXPECT_EQ(fields.at(position_of("lower")), "-inf");
  EXPECT_EQ(fields.at(position_of("upper")), "nan");
}

TEST_F(Csv, BooleansStatusAndCountersAreWords) {
  Record record;
  record.status = DistanceStatus::precision_limit;
  record.seed = std::numeric_limits<std::uint64_t>::max();
  const std::vector<std::string> fields = fields_of(record);
  EXPECT_EQ(fields.at(position_of("agrees")), "true");
  EXPECT_EQ(fields.at(position_of("status")), "precision_limit");
  EXPECT_EQ(fields.at(position_of("seed")), "18446744073709551615");
}

TEST_F(Csv, TextsAreQuotedWhereTheyNeedIt) {
  Record record;
  record.generator = "plain";
  record.method = "a \"quoted\", divided\nlabel";
  EXPECT_NE(csv_text({record}).find(",plain,,\"a \"\"quoted\"\", divided\nlabel\","), std::string::npos);
  record.method = "newton #2";
  EXPECT_NE(csv_text({record}).find(",plain,,\"newton #2\","), std::string::npos);
}

TEST_F(Csv, RowsAreReadBackBitForBit) {
  std::vector<Record> records = sample_results(small_experiment()).records;
  records[1].method = "a \"quoted\", divided\nlabel\r";
  records[2].generator_parameters = "\"\"";
  records[3].distance = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(fingerprints(read_csv_rows(csv_rows(records))), fingerprints(records));
  EXPECT_TRUE(read_csv_rows("").empty());
}

TEST_F(Csv, AColumnThatAFileOfAnEarlierReleaseLacksHasItsDocumentedValue) {
  std::vector<Column<Record>> columns = record_columns();
  const std::size_t host = position_of("host");
  columns[host] = later(columns[host], std::string("unknown"));
  const std::vector<std::string> names = split(split(csv_header(), '\n').at(0), ',');
  const auto without_host = [host](const std::vector<std::string>& fields) {
    std::string line;
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (i != host) line += (line.empty() ? "" : ",") + fields[i];
    return line + "\n";
  };
  Record record;
  record.generator = "sphere";
  record.host = "known";
  record.thread = 7;
  const std::vector<Record> read =
      read_csv_rows(without_host(fields_of(record)), csv_columns(without_host(names), columns));
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].generator, "sphere");
  EXPECT_EQ(read[0].host, "unknown");
  EXPECT_EQ(read[0].thread, 7);
  EXPECT_EQ(error_of([&] { csv_columns(without_host(names), record_columns()); }), "column host is missing");
}

TEST_F(Csv, ARowThatIsNoneIsNamed) {
  const std::string rows = csv_rows({Record(), Record()});
  const auto error_with = [&rows](const std::string& column, const std::string& field) {
    std::vector<std::string> fields = split(split(rows, '\n').at(1), ',');
    fields.at(position_of(column)) = field;
    std::string row;
    for (const std::string& one : fields) row += (row.empty() ? "" : ",") + one;
    return error_of([&] { read_csv_rows(split(rows, '\n').at(0) + "\n" + row + "\n"); });
  };
  EXPECT_EQ(error_with("seconds", "soon"), "row 2, column seconds: 'soon' is not of type float64");
  EXPECT_EQ(error_with("n", "3.5"), "row 2, column n: '3.5' is not of type int32");
  EXPECT_EQ(error_with("n", "3000000000"), "row 2, column n: '3000000000' is not of type int32");
  EXPECT_EQ(error_with("N", ""), "row 2, column N: '' is not of type int32");
  EXPECT_EQ(error_with("agrees", "yes"), "row 2, column agrees: 'yes' is not of type boolean");
  EXPECT_EQ(error_with("generator", "\"sphere"), "row 2, column generator: its quotes are not closed");
  EXPECT_EQ(error_with("generator", "\"sphere\"s"), "row 2, column generator: no comma follows it");
  EXPECT_EQ(error_with("started_at", "1,2"), "row 2, column started_at: the row does not end with it");
  EXPECT_TRUE(error_with("status", "fine").starts_with("row 2, column status: unknown status 'fine'"));
}

}  // namespace
}  // namespace raygauge::test_csv
