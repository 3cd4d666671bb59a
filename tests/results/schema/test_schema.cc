// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/schema/schema.h"

#include <gtest/gtest.h>

#include <set>

#include "scene/file/scene_file.h"
#include "tests/results/support.h"

namespace raygauge::test_schema {
namespace {

/// The row that docs/file-format.md owes to a column.
std::string documentation_of(const ColumnInfo& column) {
  const std::string unit = column.unit.empty() ? "" : " " + column.unit;
  return "| `" + column.name + "` | " + std::string(to_string(column.type)) + " |" + unit + " | " +
         column.description + " |\n";
}

template <class Row>
void expect_documented(const std::string& heading, const std::vector<Column<Row>>& columns) {
  static const std::string kPage = testing::read_bytes(RAYGAUGE_SOURCE_DIR "/docs/file-format.md");
  const std::size_t section = kPage.find("## " + heading + "\n");
  ASSERT_NE(section, std::string::npos) << heading;
  std::string table = "| dataset | type | unit | description |\n| --- | --- | --- | --- |\n";
  for (const Column<Row>& column : columns) table += documentation_of(column);
  EXPECT_NE(kPage.find("\n" + table + "\n", section), std::string::npos)
      << "docs/file-format.md should hold, under " << heading << ":\n"
      << table;
}

template <class Row>
void expect_well_formed(const std::vector<Column<Row>>& columns) {
  const std::set<std::string> units = {"", "1", "s", "B"};
  std::set<std::string> names;
  for (const Column<Row>& column : columns) {
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
    EXPECT_EQ(units.count(column.unit), 1U) << column.name;
    EXPECT_FALSE(column.description.empty()) << column.name;
    EXPECT_EQ(column.description.find_first_of("|\n"), std::string::npos) << column.name;
    EXPECT_EQ(type_of(column.get(Row())), column.type) << column.name;
  }
}

TEST(Schema, EveryColumnHasAnUnambiguousNameAUnitAndADescription) {
  expect_well_formed(record_columns());
  expect_well_formed(session_columns());
  expect_well_formed(machine_columns());
  expect_well_formed(version_columns());
  expect_well_formed(calibration_columns());
}

TEST(Schema, EveryColumnIsDocumented) {
  expect_documented("`/records`", record_columns());
  expect_documented("`/provenance/sessions`", session_columns());
  expect_documented("`/provenance/machines`", machine_columns());
  expect_documented("`/provenance/versions`", version_columns());
  expect_documented("`/provenance/calibration`", calibration_columns());
}

TEST(Schema, EveryColumnOfASceneIsDocumented) {
  expect_documented("`/records` of a scene", scene_record_columns());
  expect_documented("`/tallies` of a scene", scene_tally_columns());
  expect_documented("`/cells` of a scene", scene_cell_columns());
  expect_documented("`/bodies` of a scene", scene_body_columns());
  expect_documented("`/queries` of a scene", scene_query_columns());
}

TEST(Schema, TheDocumentationIsOfThisVersion) {
  const std::string page = testing::read_bytes(RAYGAUGE_SOURCE_DIR "/docs/file-format.md");
  EXPECT_NE(page.find("schema version " + std::to_string(kSchemaVersion) + "."), std::string::npos);
}

TEST(Schema, SettingWhatWasReadCopiesEveryColumn) {
  const Record record = testing::cell_result(testing::small_experiment(), 2).records.back();
  Record copy;
  for (const Column<Record>& column : record_columns()) column.set(copy, column.get(record));
  EXPECT_EQ(testing::fingerprint(copy), testing::fingerprint(record));
}

}  // namespace
}  // namespace raygauge::test_schema
