// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What read_results says of files that are not what they should be.
#include <H5Cpp.h>
#include <gtest/gtest.h>

#include "results/exceptions.h"
#include "results/hdf5/hdf5_library.h"
#include "results/run/results_file.h"
#include "results/schema/column_io.h"
#include "results/schema/schema.h"
#include "tests/results/support.h"

namespace raygauge::test_damaged_files {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the helpers of this room's tests

class DamagedFile : public ::testing::Test {
 protected:
  void SetUp() override { write_results(path_, sample_results(small_experiment())); }
  std::string error() const {
    return error_of([this] { read_results(path_); });
  }
  /// Opens the file as HDF5 for a change behind raygauge's back.
  template <class Change>
  void change(const Change& apply) {
    H5::H5File file(path_, H5F_ACC_RDWR);
    apply(file);
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("x.h5");
};

TEST_F(DamagedFile, AMissingFileIsNamed) {
  std::filesystem::remove(path_);
  EXPECT_EQ(error(), path_ + ": no such file");
}

TEST_F(DamagedFile, AFolderIsNoFile) {
  std::filesystem::remove(path_);
  std::filesystem::create_directory(path_);
  EXPECT_EQ(error(), path_ + ": a folder, not a file");
}

TEST_F(DamagedFile, AnEmptyOrForeignFileIsNotHdf5) {
  write_bytes(path_, "");
  EXPECT_EQ(error(), path_ + ": not an HDF5 file");
  write_bytes(path_, "name = \"an experiment\"\n");
  EXPECT_EQ(error(), path_ + ": not an HDF5 file");
}

TEST_F(DamagedFile, AFileTruncatedAnywhereIsRefusedInOneLine) {
  const std::string bytes = read_bytes(path_);
  for (std::size_t length = 8; length < bytes.size(); length += 499) {
    write_bytes(path_, bytes.substr(0, length));
    const std::string message = error();
    ASSERT_EQ(message.rfind(path_ + ": truncated or damaged: ", 0), 0U) << "at " << length << ": " << message;
    ASSERT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST_F(DamagedFile, AnotherSchemaVersionIsRefused) {
  change([](H5::H5File& file) {
    const std::int64_t newer = kSchemaVersion + 1;
    file.openGroup("/").openAttribute("schema_version").write(H5::PredType::NATIVE_INT64, &newer);
  });
  EXPECT_THROW(read_results(path_), SchemaVersionError);
  EXPECT_EQ(error(), path_ + ": schema version 4, this raygauge reads version 3");
}

TEST_F(DamagedFile, ASchemaVersionFromBeforeTheFirstReleaseIsRefused) {
  change([](H5::H5File& file) {
    const std::int64_t older = 2;
    file.openGroup("/").openAttribute("schema_version").write(H5::PredType::NATIVE_INT64, &older);
  });
  EXPECT_THROW(read_results(path_), SchemaVersionError);
  EXPECT_EQ(error(),
            path_ + ": schema version 2, from before the first release (0.2), is not read: measure anew");
}

TEST_F(DamagedFile, AnHdf5FileOfAnotherProgramIsRefused) {
  { H5::H5File file(path_, H5F_ACC_TRUNC); }
  EXPECT_EQ(error(), path_ + ": an HDF5 file, but not one of raygauge's results");
}

TEST_F(DamagedFile, AMissingColumnIsNamed) {
  change([](H5::H5File& file) { file.unlink("/records/seconds"); });
  EXPECT_EQ(error(), path_ + ": /records/seconds: missing");
}

TEST_F(DamagedFile, AColumnOfAnotherTypeRankOrLengthIsNamed) {
  const auto replace_by = [this](const ColumnInfo& info, const std::vector<Value>& values) {
    change([&](H5::H5File& file) {
      H5::Group records = file.openGroup("/records");
      records.unlink("seconds");
      hdf5::write_column(records, info, values, hdf5::Layout::plain);
    });
  };
  replace_by({"seconds", "s", "", ValueType::text}, {"a while"});
  EXPECT_EQ(error(), path_ + ": /records/seconds: is not of type float64");
  replace_by({"seconds", "s", "", ValueType::float64}, {1.0, 2.0});
  EXPECT_EQ(error(), path_ + ": /records/seconds: 2 entries, but cell has 24");
  change([](H5::H5File& file) {
    file.unlink("/records/seconds");
    file.createDataSet("/records/seconds", H5::PredType::NATIVE_DOUBLE, H5::DataSpace(H5S_SCALAR));
  });
  EXPECT_EQ(error(), path_ + ": /records/seconds: rank 0, expected 1");
}

TEST_F(DamagedFile, AnUnknownStatusIsNamed) {
  change([](H5::H5File& file) {
    H5::Group records = file.openGroup("/records");
    records.unlink("status");
    hdf5::write_column(records, {"status", "", "", ValueType::text}, std::vector<Value>(24, "fine"),
                       hdf5::Layout::plain);
  });
  EXPECT_EQ(error().rfind(path_ + ": /records/status: unknown status 'fine'", 0), 0U) << error();
}

TEST_F(DamagedFile, ABitThatFlippedInStoredNumbersIsFoundByTheChecksum) {
  haddr_t offset = 0;
  change([&offset](H5::H5File& file) {
    const H5::DataSet seconds = file.openDataSet("/records/seconds");
    unsigned filters = 0;
    hsize_t size = 0;
    ASSERT_GE(
        H5Dget_chunk_info(seconds.getId(), seconds.getSpace().getId(), 0, nullptr, &filters, &offset, &size),
        0);
  });
  std::string bytes = read_bytes(path_);
  bytes.at(offset + 5) = static_cast<char>(bytes.at(offset + 5) ^ 1);
  write_bytes(path_, bytes);
  EXPECT_EQ(error().rfind(path_ + ": /records/seconds: truncated or damaged: ", 0), 0U) << error();
}

TEST_F(DamagedFile, Hdf5ItselfPrintsNothing) {
  write_bytes(path_, read_bytes(path_).substr(0, 2000));
  ::testing::internal::CaptureStderr();
  EXPECT_NE(error(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace raygauge::test_damaged_files
