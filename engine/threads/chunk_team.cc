// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/threads/chunk_team.h"

#include <algorithm>
#include <chrono>
#include <system_error>

namespace raygauge {
namespace {

constexpr std::uint32_t kOpen = 1;
constexpr std::uint32_t kHelper = 2;

// Runs by the caller alone after one in which it waited longer for a helper than it worked itself.
constexpr int kLeastPenalty = 16;
constexpr int kMostPenalty = 1024;

using Clock = std::chrono::steady_clock;

// Looks at what is waited for before a thread sleeps: the caller's at the end of a work, a helper's between
// two. Each gives the processor to whoever else wants it.
constexpr int kLooksAtEnd = 300;
constexpr int kLooksBetween = 3000;

template <class Value>
void wait_while(const std::atomic<Value>& value, Value old, int looks) {
  for (int look = 0; look < looks; ++look) {
    if (value.load(std::memory_order_acquire) != old) return;
    std::this_thread::yield();
  }
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

ChunkTeam::~ChunkTeam() { end_helpers(); }

void ChunkTeam::resize(int threads) {
  if (threads == wanted_) return;
  end_helpers();
  wanted_ = threads;
  ending_.store(false);
  try {
    while (static_cast<int>(helpers_.size()) < threads - 1) helpers_.emplace_back([this] { help(); });
  } catch (const std::system_error&) {
    // The threads there are will do.
  }
}

void ChunkTeam::end_helpers() {
  ending_.store(true);
  calls_.fetch_add(1);
  calls_.notify_all();
  for (std::thread& helper : helpers_) helper.join();
  helpers_.clear();
}

void ChunkTeam::share(const Job& job, bool wake) {
  if (helpers_.empty() || alone_ > 0) {
    alone_ = std::max(alone_ - 1, 0);
    for (int chunk = 0; chunk < job.chunks; ++chunk) job.call(job.work, chunk);
    return;
  }
  const auto begin = Clock::now();
  job_ = job;
  next_.store(0, std::memory_order_relaxed);
  gate_.store(kOpen, std::memory_order_release);
  calls_.fetch_add(1, std::memory_order_release);
  if (wake) calls_.notify_all();
  take_chunks();
  const auto out_of_chunks = Clock::now();
  std::uint32_t at_work = gate_.fetch_and(~kOpen, std::memory_order_acq_rel) & ~kOpen;
  while (at_work != 0) {
    wait_while(gate_, at_work, kLooksAtEnd);
    at_work = gate_.load(std::memory_order_acquire);
  }
  const bool late = !patient_ && Clock::now() - out_of_chunks > out_of_chunks - begin;
  penalty_ = late ? std::clamp(2 * penalty_, kLeastPenalty, kMostPenalty) : penalty_ / 2;
  if (late) alone_ = penalty_;
}

void ChunkTeam::take_chunks() {
  const Job job = job_;
  for (;;) {
    const int chunk = next_.fetch_add(1, std::memory_order_relaxed);
    if (chunk >= job.chunks) return;
    job.call(job.work, chunk);
  }
}

// A helper that comes late finds the gate closed, or that of the next work open.
void ChunkTeam::help() {
  std::uint32_t seen = 0;
  for (;;) {
    wait_while(calls_, seen, kLooksBetween);
    seen = calls_.load(std::memory_order_acquire);
    if (ending_.load()) return;
    std::uint32_t gate = gate_.load(std::memory_order_relaxed);
    while ((gate & kOpen) != 0) {
      if (!gate_.compare_exchange_weak(gate, gate + kHelper, std::memory_order_acquire)) continue;
      take_chunks();
      if (gate_.fetch_sub(kHelper, std::memory_order_acq_rel) == kHelper) gate_.notify_one();
      break;
    }
  }
}

}  // namespace raygauge
