// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A column that a release adds, in the files of earlier releases.
#include "results/schema/table_reader.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "results/hdf5/hdf5_library.h"
#include "results/schema/column_io.h"
#include "tests/results/support.h"

namespace raygauge::test_table_reader {
namespace {

struct Row {
  std::int32_t number = 0;
  std::string name = "unset";
  double weight = -1;
};

std::vector<Column<Row>> first_columns() { return {column("number", "1", "what is counted", &Row::number)}; }

std::vector<Column<Row>> later_columns() {
  std::vector<Column<Row>> columns = first_columns();
  columns.push_back(later(column("name", "", "what it is called", &Row::name), std::string("nameless")));
  columns.push_back(later(column("weight", "1", "how much it counts", &Row::weight), 0.5));
  return columns;
}

class TableReader : public ::testing::Test {
 protected:
  /// The rows of a table that was written with `written` and is read with `read`.
  std::vector<Row> rows_of(const std::vector<Column<Row>>& written, const std::vector<Column<Row>>& read) {
    const std::vector<Row> rows = {{3, "three", 0.25}, {4, "four", 0.75}};
    testing::write_bytes(path_, hdf5::file_image([&](H5::Group& root) {
                           hdf5::write_table(root, "table", written, rows, hdf5::Layout::packed);
                         }));
    std::vector<Row> result;
    hdf5::read_file(path_,
                    [&](H5::Group& root) { result = hdf5::read_table(root, "table", read, path_ + ": "); });
    return result;
  }

  testing::TemporaryFolder folder_;
  std::string path_ = folder_.file("x.h5");
};

TEST_F(TableReader, GivesAColumnThatTheFileLacksItsDocumentedValue) {
  const std::vector<Row> rows = rows_of(first_columns(), later_columns());
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1].number, 4);
  for (const Row& row : rows) {
    EXPECT_EQ(row.name, "nameless");
    EXPECT_EQ(row.weight, 0.5);
  }
}

TEST_F(TableReader, ReadsSuchAColumnWhereTheFileHasIt) {
  const std::vector<Row> rows = rows_of(later_columns(), later_columns());
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].name, "three");
  EXPECT_EQ(rows[1].weight, 0.75);
}

TEST_F(TableReader, RefusesAFileWithoutAColumnThatEveryFileHas) {
  std::vector<Column<Row>> needed = first_columns();
  needed.push_back(column("name", "", "what it is called", &Row::name));
  EXPECT_NE(testing::error_of([&] { rows_of(first_columns(), needed); }).find("/table/name"),
            std::string::npos);
}

}  // namespace
}  // namespace raygauge::test_table_reader
