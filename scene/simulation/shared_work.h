// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "engine/threads/chunk_team.h"
#include "engine/threads/team.h"

namespace raygauge {

/// Workspaces, one a thread: each lends itself to whoever asks, and what is found does not depend on which.
template <class Tool>
class SharedTools {
 public:
  void add(std::unique_ptr<Tool> tool) {
    free_.push_back(tool.get());
    all_.push_back(std::move(tool));
  }

  const std::vector<std::unique_ptr<Tool>>& all() const noexcept { return all_; }

  /// use(tool) with one that nobody has; there must be one for each thread that asks.
  template <class Use>
  void lend(const Use& use) {
    Tool* const tool = take();
    try {
      use(*tool);
    } catch (...) {
      give_back(tool);
      throw;
    }
    give_back(tool);
  }

 private:
  Tool* take() {
    const std::lock_guard lock(mutex_);
    Tool* const tool = free_.back();
    free_.pop_back();
    return tool;
  }

  void give_back(Tool* tool) {
    const std::lock_guard lock(mutex_);
    free_.push_back(tool);
  }

  std::mutex mutex_;
  std::vector<std::unique_ptr<Tool>> all_;
  std::vector<Tool*> free_;
};

/// work(first, last) for the numbers 0 … count - 1 in chunks of `size`, each once, by the threads of a team,
/// or for all at once by the caller alone (no team, one chunk). Rethrows what was thrown first. Threads that
/// sleep are woken where asked.
template <class Work>
void share_work(ChunkTeam* team, std::size_t count, std::size_t size, bool wake, const Work& work) {
  if (team == nullptr || count <= size) {
    if (count > 0) work(std::size_t{0}, count);
    return;
  }
  FirstError error;
  team->run(static_cast<int>((count + size - 1) / size), wake, [&](int chunk) {
    const std::size_t first = static_cast<std::size_t>(chunk) * size;
    error.guard([&] { work(first, std::min(count, first + size)); });
  });
  error.rethrow();
}

}  // namespace raygauge
