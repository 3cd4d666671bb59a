// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/threads/chunk_team.h"

namespace raygauge {

/// The threads that a solve may use besides its own: those of a team, for work that is worth waking them.
class Helpers {
 public:
  Helpers() = default;
  Helpers(ChunkTeam& team, int threads) noexcept : team_(&team), threads_(threads) {}

  /// work(chunk) once for every chunk in 0 … chunks - 1, on any thread; some `operations` in all. By the
  /// caller alone, chunk after chunk, where those are few.
  template <class Work>
  void run(int chunks, double operations, const Work& work) const {
    if (threads_ == 1 || chunks == 1 || operations < kWorthWaking) {
      for (int chunk = 0; chunk < chunks; ++chunk) work(chunk);
      return;
    }
    team_->resize(threads_);
    team_->run(chunks, true, work);
  }

 private:
  static constexpr double kWorthWaking = 1 << 18;  // some 30 µs of multiplications, or 50 of reading

  ChunkTeam* team_ = nullptr;
  int threads_ = 1;
};

}  // namespace raygauge
