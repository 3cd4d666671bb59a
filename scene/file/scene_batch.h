// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

#include "scene/file/scene_file.h"

namespace raygauge {

/// Appends what a cell gave.
void append_cell(SceneFile& file, const SceneCellResult& cell, std::int32_t session);

/// Cells on their way to the disk. Those that end within a pause share a file: one of its own takes some
/// milliseconds, more than the work on most cells. The pause is kPause, or kShare times what storing took
/// before if that is longer, and no cell waits for longer.
class SceneBatch {
 public:
  static constexpr std::chrono::milliseconds kPause{250};
  static constexpr int kShare = 4;  ///< storing takes a fifth of the time at most

  /// `store` writes cells (what a SceneFile has of them, nothing else); called by any thread, one at a time.
  using Store = std::function<void(SceneFile cells)>;
  explicit SceneBatch(Store store);
  ~SceneBatch();
  SceneBatch(const SceneBatch&) = delete;
  SceneBatch& operator=(const SceneBatch&) = delete;

  /// Thread safe. Throws what storing this or earlier cells threw.
  void add(const SceneCellResult& cell, std::int32_t session);

  /// All cells are stored when it returns. Throws as add().
  void flush();

 private:
  using Clock = std::chrono::steady_clock;

  void wait_and_store(const std::stop_token& stop);
  void store_waiting();
  void rethrow();

  Store store_;
  std::mutex mutex_;
  std::condition_variable_any added_;
  SceneFile waiting_;
  Clock::time_point due_ = Clock::now();  ///< when cells are stored next
  std::exception_ptr error_;
  std::jthread thread_;
};

}  // namespace raygauge
