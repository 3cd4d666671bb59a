// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>

#include "engine/threads/chunk_team.h"
#include "engine/threads/team.h"

namespace raygauge {

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
