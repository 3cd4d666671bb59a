// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A flipped bit is found by the checksum, wherever it is. In a file without one it may change what is read,
// but HDF5 must not take this process with it. RAYGAUGE_FLIPPED_BITS=10000 flips so many in each file.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <string>

#include "results/hdf5/checksum.h"
#include "results/run/encoding.h"
#include "results/run/results_file.h"
#include "scene/file/scene_file.h"
#include "tests/results/support.h"

namespace raygauge::test_flipped_bits {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the helpers of this room's tests

std::size_t flips(std::size_t in_the_suite) {
  const char* asked = std::getenv("RAYGAUGE_FLIPPED_BITS");  // NOLINT(concurrency-mt-unsafe)
  return asked == nullptr ? in_the_suite : std::stoul(asked);
}

/// Hands on copies of `bytes` with one bit flipped, the last 25 bytes' too, at places drawn by a fixed seed.
template <class Try>
void flip(const std::string& bytes, std::size_t count, const Try& attempt) {
  std::mt19937_64 random(34);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t bit = i < 200 ? 8 * bytes.size() - 1 - i : random() % (8 * bytes.size());
    std::string damaged = bytes;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
    attempt(damaged, bit);
  }
}

std::string file_bytes_of_a_run() { return encode_results(sample_results(small_experiment())); }

SceneFile small_scene() {
  SceneFile scene;
  scene.name = "two bodies";
  scene.identity = "bodies = 2\n";
  scene.drawing = "{}";
  scene.bodies = {{"a", 1}, {"b", 1}};
  scene.queries = {{"q", "distance", "euclidean", 0, 0, 1e-6, 0}};
  scene.sessions = {sample_session()};
  return scene;
}

/// HDF5 takes the line away where another program changes the file.
std::string without_checksum(const std::string& bytes) {
  return bytes.substr(0, bytes.size() - hdf5::checksum_line("").size());
}

class FlippedBits : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  std::string path_ = folder_.file("x.h5");
};

TEST_F(FlippedBits, AreFoundWhereverTheyAre) {
  write_bytes(path_, file_bytes_of_a_run());
  flip(read_bytes(path_), flips(400), [this](const std::string& damaged, std::size_t bit) {
    write_bytes(path_, damaged);
    ASSERT_NE(error_of([this] { read_results(path_); }), "") << "bit " << bit;
    ASSERT_NE(error_of([this] { require_results(path_); }), "") << "bit " << bit;
  });
}

TEST_F(FlippedBits, OfASceneAreFoundWhereverTheyAre) {
  write_bytes(path_, encode_scene(small_scene()));
  EXPECT_TRUE(read_scene_file(path_).has_checksum);
  flip(read_bytes(path_), flips(400), [this](const std::string& damaged, std::size_t bit) {
    write_bytes(path_, damaged);
    ASSERT_NE(error_of([this] { read_scene_file(path_); }), "") << "bit " << bit;
    is_scene_file(path_);
  });
}

TEST_F(FlippedBits, OfAFileWithoutAChecksumLeaveTheReaderAlive) {
  for (const std::string& bytes :
       {without_checksum(file_bytes_of_a_run()), without_checksum(encode_scene(small_scene()))}) {
    flip(bytes, flips(150), [this](const std::string& damaged, std::size_t /*bit*/) {
      write_bytes(path_, damaged);
      for (const std::string& message :
           {error_of([this] { read_results(path_); }), error_of([this] { read_scene_file(path_); })})
        ASSERT_EQ(message.find('\n'), std::string::npos);
    });
  }
}

TEST_F(FlippedBits, AFileThatAnotherProgramChangedIsReadAndSaysThatItHasNoChecksum) {
  write_bytes(path_, without_checksum(file_bytes_of_a_run()));
  EXPECT_FALSE(read_results(path_).provenance.has_checksum);
  write_bytes(path_, without_checksum(encode_scene(small_scene())));
  EXPECT_FALSE(read_scene_file(path_).has_checksum);
}

TEST_F(FlippedBits, AChecksumIsOfAllBytesBeforeIt) {
  write_bytes(path_, "123456789");
  EXPECT_EQ(hdf5::checksum_line("123456789"), "raygauge CRC-32 cbf43926\n");
  EXPECT_EQ(hdf5::checksum_of(path_), hdf5::Checksum::none);
  hdf5::append_checksum(path_);
  EXPECT_EQ(read_bytes(path_), "123456789raygauge CRC-32 cbf43926\n");
  EXPECT_EQ(hdf5::checksum_of(path_), hdf5::Checksum::right);
  std::string bytes = read_bytes(path_);
  bytes.front() = '0';
  write_bytes(path_, bytes);
  EXPECT_EQ(hdf5::checksum_of(path_), hdf5::Checksum::wrong);
}

}  // namespace
}  // namespace raygauge::test_flipped_bits
