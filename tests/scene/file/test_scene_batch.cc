// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/file/scene_batch.h"

#include <gtest/gtest.h>

#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

namespace raygauge::test_scene_batch {
namespace {

SceneCellResult cell(std::uint64_t number) {
  SceneCellResult result;
  result.cell = number;
  result.records.resize(2);
  return result;
}

/// The numbers of the cells in each file, in order.
struct Files {
  std::mutex mutex;
  std::vector<std::vector<std::uint64_t>> cells;

  SceneBatch::Store store() {
    return [this](const SceneFile& file) {
      const std::scoped_lock lock(mutex);
      cells.emplace_back();
      for (const SceneCellRow& row : file.cells) cells.back().push_back(row.cell);
      EXPECT_EQ(file.records.size(), 2 * file.cells.size());
    };
  }
  std::size_t count() {
    const std::scoped_lock lock(mutex);
    return cells.size();
  }
};

TEST(SceneBatch, StoresTheFirstCellAtOnceAndTheNextOnesTogether) {
  Files files;
  SceneBatch batch(files.store());
  batch.add(cell(7), 0);
  EXPECT_EQ(files.count(), 1);
  for (std::uint64_t number = 8; number < 12; ++number) batch.add(cell(number), 0);
  batch.flush();
  ASSERT_GE(files.count(), 2);
  std::vector<std::uint64_t> all;
  for (const auto& file : files.cells) all.insert(all.end(), file.begin(), file.end());
  EXPECT_EQ(all, (std::vector<std::uint64_t>{7, 8, 9, 10, 11}));
}

TEST(SceneBatch, NoCellWaitsForAnotherOne) {
  Files files;
  SceneBatch batch(files.store());
  batch.add(cell(1), 0);
  batch.add(cell(2), 0);
  for (int k = 0; k < 200 && files.count() < 2; ++k) std::this_thread::sleep_for(SceneBatch::kPause / 10);
  EXPECT_EQ(files.count(), 2);
}

TEST(SceneBatch, StoresWhatIsLeftAtItsEnd) {
  Files files;
  {
    SceneBatch batch(files.store());
    batch.add(cell(1), 0);
    batch.add(cell(2), 0);
  }
  EXPECT_EQ(files.count(), 2);
}

TEST(SceneBatch, AnErrorOfTheStoreIsThrownAndStaysOne) {
  int calls = 0;
  SceneBatch batch([&](const SceneFile&) {
    if (++calls > 1) throw std::runtime_error("disk full");
  });
  batch.add(cell(1), 0);
  batch.add(cell(2), 0);
  EXPECT_THROW(batch.flush(), std::runtime_error);
  EXPECT_THROW(batch.add(cell(3), 0), std::runtime_error);
  EXPECT_EQ(calls, 2);
}

}  // namespace
}  // namespace raygauge::test_scene_batch
