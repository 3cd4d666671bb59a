// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/hdf5/packed_chunk.h"

#include <H5Cpp.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "results/schema/column_io.h"
#include "tests/results/support.h"

namespace raygauge::hdf5 {
namespace {

using Bytes = std::vector<char>;

constexpr hsize_t kRows = 3001;

/// Doubles of which some repeat, so that both runs and noise are packed.
std::vector<double> sample_numbers() {
  std::mt19937_64 bits(1);
  std::vector<double> numbers(kRows);
  for (double& number : numbers) number = bits() % 3 == 0 ? 1.0 : 1e-6 * static_cast<double>(bits());
  return numbers;
}

Bytes bytes_of(const std::vector<double>& numbers) {
  Bytes bytes(numbers.size() * sizeof(double));
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

ColumnInfo number_column() { return {"x", "1", "numbers", ValueType::float64}; }

TEST(PackedChunk, HDF5ReadsWhatIsPackedHere) {
  const testing::TemporaryFolder folder;
  H5::H5File file(folder.file("x.h5"), H5F_ACC_TRUNC);
  H5::Group root = file.openGroup("/");
  H5::DataSet dataset = create_column(root, number_column(), kRows, 0, Layout::packed);
  const std::vector<double> numbers = sample_numbers();
  for (const Packing packing : {Packing::texts, Packing::numbers}) {
    Bytes packed;
    pack_chunk(bytes_of(numbers), sizeof(double), packing, packed);
    const hsize_t first = 0;
    ASSERT_GE(H5Dwrite_chunk(dataset.getId(), H5P_DEFAULT, 0, &first, packed.size(), packed.data()), 0);
    std::vector<double> read(kRows);
    dataset.read(read.data(), H5::PredType::NATIVE_DOUBLE);
    EXPECT_EQ(read, numbers);
  }
}

TEST(PackedChunk, WhatHDF5PackedIsUnpackedHereAndDamageIsFound) {
  const testing::TemporaryFolder folder;
  H5::H5File file(folder.file("x.h5"), H5F_ACC_TRUNC);
  H5::Group root = file.openGroup("/");
  const std::vector<double> numbers = sample_numbers();
  write_column(root, number_column(), {numbers.begin(), numbers.end()}, Layout::packed);
  const H5::DataSet dataset = root.openDataSet("x");
  file.flush(H5F_SCOPE_LOCAL);
  const hsize_t first = 0;
  hsize_t size = 0;
  ASSERT_GE(H5Dget_chunk_storage_size(dataset.getId(), &first, &size), 0);
  Bytes packed(size);
  std::uint32_t mask = 0;
  ASSERT_GE(H5Dread_chunk(dataset.getId(), H5P_DEFAULT, &first, &mask, packed.data()), 0);
  Bytes unpacked(kRows * sizeof(double));
  ASSERT_TRUE(unpack_chunk(packed, sizeof(double), unpacked));
  EXPECT_EQ(unpacked, bytes_of(numbers));
  for (const std::size_t place : {std::size_t{0}, packed.size() / 2, packed.size() - 1}) {
    Bytes damaged = packed;
    damaged[place] ^= 0x10;
    EXPECT_FALSE(unpack_chunk(damaged, sizeof(double), unpacked)) << place;
  }
}

}  // namespace
}  // namespace raygauge::hdf5
