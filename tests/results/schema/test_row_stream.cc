// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/schema/row_stream.h"

#include <H5Cpp.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "results/exceptions.h"
#include "tests/results/support.h"

namespace raygauge::test_row_stream {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the helpers of this room's tests

class Rows : public ::testing::Test {
 protected:
  using Setting = void (*)(H5::DSetCreatPropList&);
  void write(hsize_t rows, hsize_t columns, const H5::DataType& type, Setting set = nullptr) {
    H5::H5File file(path_, H5F_ACC_TRUNC);
    const std::array<hsize_t, 2> extent = {rows, columns};
    H5::DSetCreatPropList list;
    if (set != nullptr) set(list);
    numbers_.resize(rows * columns);
    for (std::size_t i = 0; i < numbers_.size(); ++i) numbers_[i] = static_cast<double>(i) + 0.5;
    file.createDataSet("A", type, H5::DataSpace(2, extent.data()), list)
        .write(numbers_.data(), H5::PredType::NATIVE_DOUBLE);
  }
  std::vector<double> read(RowStream& stream, std::ptrdiff_t most_parts = 1000) const {
    std::vector<double> found;
    stream.pass([&](const StreamedPoints& part) {
      EXPECT_EQ(part.first * stream.dimension(), std::ssize(found));
      for (std::ptrdiff_t i = 0; i < part.count * stream.dimension(); ++i)
        found.push_back(part.doubles != nullptr ? part.doubles[i] : static_cast<double>(part.floats[i]));
      return --most_parts > 0;
    });
    return found;
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("points.h5");
  std::vector<double> numbers_;
};

TEST_F(Rows, AreThoseOfTheDatasetInBothPrecisionsAsOftenAsWanted) {
  for (const auto& type : {H5::PredType::IEEE_F64LE, H5::PredType::IEEE_F32LE}) {
    write(700000, 7, type);  // more than a part, and no whole number of them
    const auto stored = find_stored_rows({path_, "/A"});
    ASSERT_TRUE(stored);
    EXPECT_EQ(stored->single, type == H5::PredType::IEEE_F32LE);
    RowStream stream(*stored);
    EXPECT_EQ(stream.size(), 700000);
    EXPECT_EQ(stream.dimension(), 7);
    for (int pass = 0; pass < 2; ++pass) EXPECT_TRUE(read(stream) == numbers_);
    EXPECT_LT(read(stream, 1).size(), numbers_.size());
  }
}

TEST_F(Rows, AreNotTakenForWhatIsStoredOtherwise) {
  const auto in_chunks = [](H5::DSetCreatPropList& list) {
    const std::array<hsize_t, 2> chunk = {10, 2};
    list.setChunk(2, chunk.data());
  };
  write(100, 2, H5::PredType::IEEE_F64LE);
  EXPECT_TRUE(find_stored_rows({path_, "/A"}));
  write(100, 2, H5::PredType::IEEE_F64LE, in_chunks);
  EXPECT_FALSE(find_stored_rows({path_, "/A"}));
  write(100, 2, H5::PredType::IEEE_F64BE);
  EXPECT_FALSE(find_stored_rows({path_, "/A"}));
  write(100, 2, H5::PredType::STD_I32LE);
  EXPECT_FALSE(find_stored_rows({path_, "/A"}));
}

TEST_F(Rows, OfAFileThatHasBecomeShorterAreAnError) {
  write(10000, 3, H5::PredType::IEEE_F64LE);
  RowStream stream(*find_stored_rows({path_, "/A"}));
  std::filesystem::resize_file(path_, 5000);
  EXPECT_EQ(error_of([&] { read(stream); }), path_ + ":/A: the file is truncated");
  std::filesystem::remove(path_);
  EXPECT_EQ(error_of([&] { read(stream); }), path_ + ":/A: No such file or directory");
}

}  // namespace
}  // namespace raygauge::test_row_stream
