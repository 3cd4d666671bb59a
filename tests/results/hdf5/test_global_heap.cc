// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/hdf5/global_heap.h"

#include <gtest/gtest.h>

#include "results/hdf5/checksum.h"
#include "results/run/results_file.h"
#include "tests/results/support.h"

namespace raygauge::test_global_heap {
namespace {

using testing::TemporaryFolder;

class GlobalHeap : public ::testing::Test {
 protected:
  void SetUp() override {
    write_results(path_, testing::sample_results(testing::small_experiment()));
    bytes_ = testing::read_bytes(path_);
    heap_ = bytes_.find("GCOL");
    ASSERT_NE(heap_, std::string::npos);
  }

  /// The size of the heap's first object, eight bytes.
  void set_first_size(const std::string& eight_bytes) { bytes_.replace(heap_ + 24, 8, eight_bytes); }

  /// Makes the first object the free space, which has number 0.
  void free_first_object() { bytes_.replace(heap_ + 16, 2, 2, '\0'); }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("x.h5");
  std::string bytes_;
  std::size_t heap_ = 0;
};

TEST_F(GlobalHeap, AsWrittenIsSound) { EXPECT_FALSE(hdf5::has_damaged_global_heap(bytes_)); }

TEST_F(GlobalHeap, WithAnObjectBeyondItsEndIsDamaged) {
  set_first_size(std::string(6, '\0') + "\x7f" + std::string(1, '\0'));
  EXPECT_TRUE(hdf5::has_damaged_global_heap(bytes_));
}

TEST_F(GlobalHeap, WithAnObjectWhoseSizeOverflowsIsDamaged) {
  set_first_size(std::string(8, '\xff'));
  EXPECT_TRUE(hdf5::has_damaged_global_heap(bytes_));
}

// HDF5 1.10 reads such a file for ever.
TEST_F(GlobalHeap, WithFreeSpaceOfNoExtentIsRefused) {
  free_first_object();
  set_first_size(std::string(8, '\0'));
  bytes_.resize(bytes_.size() - hdf5::checksum_line("").size());  // as where another program changed it
  testing::write_bytes(path_, bytes_);
  EXPECT_EQ(testing::error_of([this] { read_results(path_); }),
            path_ + ": truncated or damaged: a text does not lie within its heap");
}

TEST(GlobalHeaps, CutOffAreNoConcernHere) {
  EXPECT_FALSE(hdf5::has_damaged_global_heap(std::string("GCOL\1\0\0\0", 8)));
  EXPECT_FALSE(hdf5::has_damaged_global_heap(std::string("GCOL\1\0\0\0\x40\0\0\0\0\0\0\0", 16)));
}

}  // namespace
}  // namespace raygauge::test_global_heap
