// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "python/bindings/interrupt.h"

#include <pybind11/pybind11.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace raygauge::python {
namespace {

namespace py = pybind11;

constexpr std::chrono::milliseconds kBetweenLooks(20);

/// The outcome of `work`, told from its thread to the one that waits.
struct Outcome {
  std::mutex mutex;
  std::condition_variable changed;
  bool done = false;
  std::exception_ptr error;

  bool wait() {
    std::unique_lock lock(mutex);
    return changed.wait_for(lock, kBetweenLooks, [this] { return done; });
  }
  void finish(std::exception_ptr raised) {
    {
      const std::lock_guard lock(mutex);
      error = std::move(raised);
      done = true;
    }
    changed.notify_one();
  }
};

void perform(const std::function<void()>& work, Outcome& outcome) {
  std::exception_ptr error;
  try {
    work();
  } catch (...) {
    error = std::current_exception();
  }
  outcome.finish(std::move(error));
}

}  // namespace

bool SignalWatch::look() {
  if (raised_) return true;
  const auto now = std::chrono::steady_clock::now();
  if (last_look_ == std::chrono::steady_clock::time_point()) last_look_ = now;
  if (now - last_look_ < kBetweenLooks) return false;
  last_look_ = now;
  const py::gil_scoped_acquire acquire;
  if (PyErr_CheckSignals() != 0) raised_.emplace();
  return raised_.has_value();
}

void run_interruptibly(std::atomic<bool>& stop, const std::function<void()>& work) {
  Outcome outcome;
  bool interrupted = false;
  {
    const py::gil_scoped_release release;
    std::thread worker(perform, std::cref(work), std::ref(outcome));
    while (!outcome.wait()) {
      if (interrupted) continue;
      const py::gil_scoped_acquire acquire;
      interrupted = PyErr_CheckSignals() != 0;
      if (interrupted) stop = true;
    }
    worker.join();
  }
  if (interrupted) throw py::error_already_set();
  if (outcome.error) std::rethrow_exception(outcome.error);
}

}  // namespace raygauge::python
