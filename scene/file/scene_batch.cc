// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/file/scene_batch.h"

#include <algorithm>
#include <utility>

namespace raygauge {

void append_cell(SceneFile& file, const SceneCellResult& cell, std::int32_t session) {
  for (const SceneRecord& record : cell.records) file.records.push_back({cell.cell, session, record});
  for (std::size_t q = 0; q < cell.tallies.size(); ++q) {
    if (cell.tallies[q].asked > 0)
      file.tallies.push_back({cell.cell, static_cast<std::int32_t>(q), cell.tallies[q]});
  }
  file.cells.push_back({cell.cell, cell.counters, cell.seconds});
}

SceneBatch::SceneBatch(Store store)
    : store_(std::move(store)), thread_([this](const std::stop_token& stop) { wait_and_store(stop); }) {}

// What is left is stored as well as can be: errors were for flush() to report.
SceneBatch::~SceneBatch() {
  thread_.request_stop();
  thread_.join();
  const std::scoped_lock lock(mutex_);
  if (error_ == nullptr) store_waiting();
}

void SceneBatch::add(const SceneCellResult& cell, std::int32_t session) {
  const std::scoped_lock lock(mutex_);
  rethrow();
  append_cell(waiting_, cell, session);
  if (Clock::now() < due_) {
    added_.notify_one();
    return;
  }
  store_waiting();
  rethrow();
}

void SceneBatch::flush() {
  const std::scoped_lock lock(mutex_);
  rethrow();
  store_waiting();
  rethrow();
}

void SceneBatch::rethrow() {
  if (error_ != nullptr) std::rethrow_exception(error_);
}

void SceneBatch::store_waiting() {
  if (waiting_.cells.empty()) return;
  const Clock::time_point begin = Clock::now();
  try {
    store_(std::exchange(waiting_, {}));
  } catch (...) {
    error_ = std::current_exception();
  }
  const Clock::time_point end = Clock::now();
  due_ = end + std::max<Clock::duration>(kPause, kShare * (end - begin));
}

void SceneBatch::wait_and_store(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (added_.wait(lock, stop, [this] { return !waiting_.cells.empty() && error_ == nullptr; })) {
    added_.wait_until(lock, stop, due_, [] { return false; });
    if (stop.stop_requested()) return;
    if (Clock::now() >= due_) store_waiting();
  }
}

}  // namespace raygauge
