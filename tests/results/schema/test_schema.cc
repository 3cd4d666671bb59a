// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/schema/schema.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "scene/file/scene_file.h"
#include "tests/results/support.h"

namespace raygauge::test_schema {
namespace {

const std::string kPage = RAYGAUGE_SOURCE_DIR "/docs/columns.md";

/// The line that the page owes to a column, which begins with these names.
std::string documentation_of(const std::string& names, const ColumnInfo& column) {
  const std::string unit = column.unit == "s" || column.unit == "B" ? ", " + column.unit : "";
  return "- " + names + ", " + std::string(to_string(column.type)) + unit + ": " + column.description + "\n";
}

/// The lines of all columns. `point_1` and its successors `point_2`, … share one, and so do `x` and the
/// columns after it that are "the same".
template <class Row>
std::string documentation_of(const std::vector<Column<Row>>& columns) {
  std::string lines;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::size_t first = i;
    const std::string& name = columns[first].name;
    const std::string stem = name.substr(0, name.size() - 1);
    const auto is_next = [&] {
      return i + 1 < columns.size() && columns[i + 1].name == stem + std::to_string(i + 2 - first);
    };
    while (name == stem + "1" && is_next()) ++i;
    std::string names = "`" + name + "`" + (i == first ? "" : " … `" + columns[i].name + "`");
    while (i + 1 < columns.size() && columns[i + 1].description == "the same")
      names += ", `" + columns[++i].name + "`";
    lines += documentation_of(names, columns[first]);
  }
  return lines;
}

/// Compares the list under the heading; writes it where RAYGAUGE_WRITE_DOCS is set.
template <class Row>
void expect_documented(const std::string& heading, const std::vector<Column<Row>>& columns) {
  std::string page = testing::read_bytes(kPage);
  const std::size_t section = page.find("## " + heading + "\n");
  ASSERT_NE(section, std::string::npos) << heading;
  const std::size_t begin = section + heading.size() + 4;
  const std::size_t end = std::min(page.find("\n## ", begin), page.size());
  const std::string list = "\n" + documentation_of(columns);
  if (std::getenv("RAYGAUGE_WRITE_DOCS") != nullptr) {
    testing::write_bytes(kPage, page.replace(begin, end - begin, list));
  } else {
    EXPECT_EQ(page.substr(begin, end - begin), list)
        << "set RAYGAUGE_WRITE_DOCS and run this test to write docs/columns.md";
  }
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
  expect_documented("`/simulations` of a scene", simulation_columns());
  expect_documented("`/states` of a simulation", state_columns());
  expect_documented("`/contacts` of a simulation", contact_columns());
  expect_documented("`/steps` of a simulation", step_columns());
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
