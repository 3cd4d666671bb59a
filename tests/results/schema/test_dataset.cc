// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/schema/dataset.h"

#include <H5Cpp.h>
#include <gtest/gtest.h>

#include <limits>

#include "results/exceptions.h"
#include "tests/results/support.h"

namespace raygauge::test_dataset {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the helpers of this room's tests

class Dataset : public ::testing::Test {
 protected:
  void write(const std::vector<hsize_t>& extent, const std::vector<double>& values,
             const H5::DataType& type = H5::PredType::IEEE_F64LE) {
    H5::H5File file(path_, H5F_ACC_TRUNC);
    file.createGroup("/sets");
    const H5::DataSpace space(static_cast<int>(extent.size()), extent.data());
    const H5::DataSet dataset = file.createDataSet("/sets/A", type, space);
    if (!values.empty()) dataset.write(values.data(), H5::PredType::NATIVE_DOUBLE);
  }
  std::string error(const std::string& dataset = "/sets/A") const {
    return error_of([&] { read_points({path_, dataset}); });
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("points.h5");
  std::string place_ = path_ + ":/sets/A";
};

TEST_F(Dataset, RowsArePoints) {
  write({3, 2}, {1, 2, 3, 4, 5, 6});
  Eigen::MatrixXd expected(2, 3);
  expected << 1, 3, 5, 2, 4, 6;
  EXPECT_EQ(read_points({path_, "/sets/A"}), expected);
}

TEST_F(Dataset, IntegersAndSingleOrBigEndianNumbersAreAccepted) {
  const std::vector<H5::DataType> types = {H5::PredType::STD_I16LE, H5::PredType::STD_U8LE,
                                           H5::PredType::IEEE_F32LE, H5::PredType::IEEE_F64BE};
  for (const H5::DataType& type : types) {
    write({2, 1}, {1, 200}, type);
    EXPECT_EQ(read_points({path_, "/sets/A"}), (Eigen::MatrixXd(1, 2) << 1, 200).finished());
  }
}

TEST_F(Dataset, AMissingFileOrDatasetIsNamed) {
  EXPECT_EQ(error(), path_ + ": no such file");
  write({1, 1}, {1});
  EXPECT_EQ(error("/sets/B"), path_ + ":/sets/B: no such dataset");
  EXPECT_EQ(error("/nowhere/A"), path_ + ":/nowhere/A: no such dataset");
  EXPECT_EQ(error("/sets/A/x"), path_ + ":/sets/A/x: no such dataset");
  EXPECT_EQ(error("/sets"), path_ + ":/sets: not a dataset");
}

TEST_F(Dataset, AnotherRankIsNamed) {
  write({4}, {1, 2, 3, 4});
  EXPECT_EQ(error(), place_ + ": has 1 dimension, expected 2 (points × coordinates)");
  write({1, 2, 2}, {1, 2, 3, 4});
  EXPECT_EQ(error(), place_ + ": has 3 dimensions, expected 2 (points × coordinates)");
}

TEST_F(Dataset, WhatIsNotNumericIsNamed) {
  write({2, 2}, {}, H5::StrType(H5::PredType::C_S1, 4));
  EXPECT_EQ(error(), place_ + ": not numeric");
}

TEST_F(Dataset, AnEmptyOneIsAnEmptySet) {
  write({0, 3}, {});
  EXPECT_THROW(read_points({path_, "/sets/A"}), EmptySetError);
  EXPECT_EQ(error(), place_ + ": has no points");
}

TEST_F(Dataset, NanAndInfinityAreLocated) {
  write({2, 3}, {1, 2, 3, 4, 5, std::numeric_limits<double>::quiet_NaN()});
  EXPECT_THROW(read_points({path_, "/sets/A"}), NonFiniteError);
  EXPECT_EQ(error(), place_ + ": NaN at row 1, column 2");
  write({2, 3}, {1, -std::numeric_limits<double>::infinity(), 3, 4, 5, 6});
  EXPECT_EQ(error(), place_ + ": infinity at row 0, column 1");
}

TEST_F(Dataset, OneLargerThanMemoryIsNamed) {
  write({hsize_t{1} << 50, 1 << 12}, {}, H5::PredType::STD_U8LE);
  EXPECT_EQ(error(), path_ + ": does not fit into memory");
}

TEST(DatasetReference, IsAFileAColonAndAPath) {
  const auto reference = parse_dataset_reference("data/points.h5:/sets/A");
  ASSERT_TRUE(reference.has_value());
  EXPECT_EQ(reference->file, "data/points.h5");
  EXPECT_EQ(reference->dataset, "/sets/A");
  EXPECT_FALSE(parse_dataset_reference("points.csv").has_value());
  EXPECT_FALSE(parse_dataset_reference("points.h5:/").has_value());
  EXPECT_FALSE(parse_dataset_reference(":/A").has_value());
}

}  // namespace
}  // namespace raygauge::test_dataset
