// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <mpi.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <numeric>
#include <stop_token>
#include <thread>

#include "cluster/ranks.h"

namespace raygauge {
namespace {

constexpr auto kPause = std::chrono::milliseconds(1);

/// Open MPI looks for networks for 0.2 s before it takes shared memory. Where all ranks are on this machine,
/// it is told so, unless the user has chosen.
void skip_networks_on_one_machine() {
  const char* all = std::getenv("OMPI_COMM_WORLD_SIZE");
  const char* here = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
  if (all == nullptr || here == nullptr || std::strcmp(all, here) != 0) return;
  ::setenv("OMPI_MCA_pml", "ob1", 0);
}

/// Ranks by MPI. One thread at a time is in MPI; none holds the lock while it waits for other ranks.
class MpiRanks final : public Ranks {
 public:
  MpiRanks() {
    skip_networks_on_one_machine();
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
    const MPI_Aint bytes = rank_ == 0 ? kCounters * sizeof(std::uint64_t) : 0;
    MPI_Win_allocate(bytes, sizeof(std::uint64_t), MPI_INFO_NULL, MPI_COMM_WORLD, &counters_, &window_);
    if (rank_ == 0) std::fill_n(counters_, kCounters, 0);
    MPI_Barrier(MPI_COMM_WORLD);
    MPI_Win_lock_all(0, window_);
    MPI_Win_sync(window_);
    if (rank_ == 0) server_ = std::jthread([this](const std::stop_token& stop) { serve(stop); });
  }

  ~MpiRanks() override {
    barrier();
    server_ = {};
    MPI_Win_unlock_all(window_);
    MPI_Win_free(&window_);
    MPI_Finalize();
  }

  int rank() const override { return rank_; }
  int count() const override { return count_; }

  std::string broadcast(const std::string& text) override {
    std::uint64_t size = text.size();
    wait([&](MPI_Request* request) { MPI_Ibcast(&size, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD, request); });
    std::string result = rank_ == 0 ? text : std::string(size, '\0');
    wait([&](MPI_Request* request) {
      MPI_Ibcast(result.data(), static_cast<int>(size), MPI_BYTE, 0, MPI_COMM_WORLD, request);
    });
    return result;
  }

  std::vector<std::string> gather(const std::string& text) override {
    const int size = static_cast<int>(text.size());
    std::vector<int> sizes(rank_ == 0 ? count_ : 0);
    wait([&](MPI_Request* request) {
      MPI_Igather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, MPI_COMM_WORLD, request);
    });
    std::vector<int> places(sizes.size());
    std::exclusive_scan(sizes.begin(), sizes.end(), places.begin(), 0);
    std::string all(std::accumulate(sizes.begin(), sizes.end(), std::size_t{0}), '\0');
    wait([&](MPI_Request* request) {
      MPI_Igatherv(text.data(), size, MPI_BYTE, all.data(), sizes.data(), places.data(), MPI_BYTE, 0,
                   MPI_COMM_WORLD, request);
    });
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < sizes.size(); ++i) texts.push_back(all.substr(places[i], sizes[i]));
    return texts;
  }

  void barrier() override {
    wait([](MPI_Request* request) { MPI_Ibarrier(MPI_COMM_WORLD, request); });
  }

  std::uint64_t fetch_and_add(int counter, std::uint64_t summand) override {
    const std::scoped_lock lock(mutex_);
    std::uint64_t before = 0;
    MPI_Fetch_and_op(&summand, &before, MPI_UINT64_T, 0, counter, MPI_SUM, window_);
    MPI_Win_flush(0, window_);
    return before;
  }

 private:
  template <class Start>
  void wait(const Start& start) {
    MPI_Request request = MPI_REQUEST_NULL;
    {
      const std::scoped_lock lock(mutex_);
      start(&request);
    }
    for (int done = 0; done == 0;) {
      {
        const std::scoped_lock lock(mutex_);
        MPI_Test(&request, &done, MPI_STATUS_IGNORE);
      }
      // Who started us has died: nobody is left to wait for.
      if (::getppid() != parent_) MPI_Abort(MPI_COMM_WORLD, 1);
      if (done == 0) std::this_thread::sleep_for(kPause);
    }
  }

  /// Over a network without remote memory access the counters move only while rank 0 is in MPI: a thread
  /// that looks in a thousand times a second, for a microsecond each, serves those who ask.
  void serve(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      {
        const std::scoped_lock lock(mutex_);
        int any = 0;
        MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &any, MPI_STATUS_IGNORE);
      }
      std::this_thread::sleep_for(kPause);
    }
  }

  const pid_t parent_ = ::getppid();
  int rank_ = 0;
  int count_ = 1;
  std::uint64_t* counters_ = nullptr;
  MPI_Win window_ = MPI_WIN_NULL;
  std::mutex mutex_;
  std::jthread server_;
};

}  // namespace
}  // namespace raygauge

extern "C" raygauge::Ranks* raygauge_create_ranks() { return new raygauge::MpiRanks(); }
