// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

namespace raygauge {

/// Threads that share the chunks of one piece of work after the other: each takes the next chunk as soon as
/// it is free. The calling thread takes chunks too and waits for no thread that has none, so that work ends
/// as soon as by the caller alone where the others get no processor. It sleeps while a last chunk is finished
/// elsewhere: its processor is then free for the thread that has it. Where that took longer than the helpers
/// saved, others want the processors more: the caller works alone for a while, longer each time.
class ChunkTeam {
 public:
  ChunkTeam() = default;
  ~ChunkTeam();
  ChunkTeam(const ChunkTeam&) = delete;
  ChunkTeam& operator=(const ChunkTeam&) = delete;

  /// To `threads` with the caller, fewer where the system grants no more. Does nothing if they are as many
  /// already.
  void resize(int threads);

  /// A patient caller of long work does not work alone after it has waited.
  void be_patient() noexcept { patient_ = true; }

  /// work(chunk) once for every chunk in 0 … chunks - 1, on any thread. `work` must not throw. A helper
  /// sleeps some ms after its last work; `wake` wakes it, which costs the caller some µs, otherwise only
  /// those that are awake take part. Allocates nothing.
  template <class Work>
  void run(int chunks, bool wake, const Work& work) {
    share({[](const void* function, int chunk) { (*static_cast<const Work*>(function))(chunk); }, &work,
           chunks},
          wake);
  }

 private:
  struct Job {
    void (*call)(const void* work, int chunk) = nullptr;
    const void* work = nullptr;
    int chunks = 0;
  };

  void share(const Job& job, bool wake);
  void take_chunks();
  void help();
  void end_helpers();

  bool patient_ = false;
  int wanted_ = 1;
  int alone_ = 0;    // runs without helpers to come
  int penalty_ = 0;  // how many the next delay costs
  std::vector<std::thread> helpers_;
  Job job_;
  std::atomic<int> next_{0};
  std::atomic<std::uint32_t> gate_{0};  // 2 · helpers at work, + 1 while more may begin
  std::atomic<std::uint32_t> calls_{0};
  std::atomic<bool> ending_{false};
};

}  // namespace raygauge
